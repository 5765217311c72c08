# SPDX-License-Identifier: MIT
"""The fakes in Python with both loads and the serial scheme, beside the shipped programs, and what they refuse.

Each against its analytic answer: cases/fakes.

usage: fakes.py --build FOLDER [unittest's arguments]
"""
import re
import subprocess

import numpy as np

from outside_test import ARGUMENTS, CASE, OutsideTest, main

END = 0.03
SETTINGS = [f"coupling.time.end={END}", "coupling.coupling.acceleration=nodal", 'coupling.coupling.scheme="parallel"',
            "coupling.coupling.impedance_factor=0"]
OMEGA = 100.0                                    # of a plate of 100 kg/m on a spring of 1e6 N/m
PRESSED = ["constant", "--pressure", "1000", "--dt", "1e-4"]
SPRING = ["spring", "--mass", "100", "--stiffness", "1e6"]
NUMBER = r"(-?\d\S*)"


class Fakes(OutsideTest):
    def together(self, fluid: list[str], solid: list[str], *more: str) -> subprocess.CompletedProcess:
        """One run of both, each a fake of the module or a program of the build."""
        overrides = [word for setting in (*SETTINGS, *more) for word in ("--set", setting)]
        segments = []
        for name, words in (("fluid", fluid), ("solid", solid)):
            program = ["/usr/bin/python3", "-m", f"rivage.fake_{name}", str(CASE), *words]
            if not words:
                program = [str(ARGUMENTS.build / "bin" / f"fake_{name}"), str(CASE), "--out", str(self.folder / "out")]
            segments.append(["-n", "1", *program, *overrides])
        return self.mpirun(*segments)

    def solid_of(self, done: subprocess.CompletedProcess) -> tuple[float, float]:
        """Largest displacement and the load's work at the end."""
        self.assertEqual(done.returncode, 0, done.stdout)
        found = re.search(rf"u = {NUMBER} m at t = {END:g} s, work {NUMBER} J/m", done.stdout)
        self.assertIsNotNone(found, done.stdout)
        return float(found[1]), float(found[2])

    def fluid_of(self, done: subprocess.CompletedProcess) -> np.ndarray:
        """Force in x and y and the work at the end."""
        self.assertEqual(done.returncode, 0, done.stdout)
        found = re.search(rf"force {NUMBER} {NUMBER} N/m, work {NUMBER} J/m at", done.stdout)
        self.assertIsNotNone(found, done.stdout)
        return np.array([float(number) for number in found.groups()])

    def test_a_spring_under_a_sudden_pressure(self) -> None:
        exact = 1e-3 * (1 - np.cos(OMEGA * END))
        for more in ((), ('coupling.interface.load="averaged"',), ('coupling.coupling.scheme="serial"',)):
            with self.subTest(more=more):
                done = self.together(PRESSED, SPRING, *more)
                u, work = self.solid_of(done)
                self.assertAlmostEqual(u / exact, 1, delta=1e-4)      # the trapezoidal rule at dt w = 0.01
                self.assertAlmostEqual(work, 1000 * u, delta=1e-9)
                np.testing.assert_allclose(self.fluid_of(done), (0, -1000, work), atol=1e-6)

    def test_each_beside_a_shipped_program(self) -> None:
        u, _ = self.solid_of(self.together([], SPRING, "fluid.fluid.radiating=false", "fluid.fluid.dt=1e-4"))
        self.assertAlmostEqual(u / (1e-3 * (1 - np.cos(OMEGA * END))), 1, delta=1e-4)
        force = self.fluid_of(self.together(PRESSED, []))       # fake_solid is the same plate, damped by HHT
        self.assertAlmostEqual(force[2] / (1 - np.cos(OMEGA * END)), 1, delta=2e-3)

    def test_what_cannot_be_is_said(self) -> None:
        table = self.folder / "table.csv"
        table.write_text("t[s],p[Pa]\n1,0\n0,1\n", encoding="utf-8")
        recorded = ["recorded", "--table", str(table), "--dt", "1e-4"]
        for fluid, more, words in ((recorded, (), "t[s] ascending"), (["constant", "--pressure", "1", "--dt", "0"], (), "step above zero"),
                                   (PRESSED, ('coupling.coupling.scheme="parallel_impedance"', "coupling.coupling.impedance_factor=1"),
                                    "takes the load as it comes")):
            done = self.together(fluid, SPRING, *more)
            self.assertEqual(done.returncode, 2, done.stdout)
            self.assertIn(words, done.stdout)
            self.assertEqual(done.stdout.count("rivage: "), 1, done.stdout)


if __name__ == "__main__":
    main(__doc__)
