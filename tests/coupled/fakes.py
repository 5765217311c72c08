# SPDX-License-Identifier: MIT
"""The fakes in Python against their analytic answers, against each other and against the shipped programs.

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

    def pressed(self, dt: float = 1e-4) -> list[str]:
        return ["constant", "--pressure", "1000", "--dt", str(dt)]

    def test_a_spring_under_a_sudden_pressure(self) -> None:
        exact = 1e-3 * (1 - np.cos(OMEGA * END))
        for more in ((), ('coupling.interface.load="averaged"',), ('coupling.coupling.scheme="serial"',)):
            with self.subTest(more=more):
                done = self.together(self.pressed(), SPRING, *more)
                u, work = self.solid_of(done)
                self.assertAlmostEqual(u / exact, 1, delta=1e-4)      # the trapezoidal rule at dt w = 0.01
                self.assertAlmostEqual(work, 1000 * u, delta=1e-9)
                np.testing.assert_allclose(self.fluid_of(done), (0, -1000, work), atol=1e-6)

    def test_the_energies_that_the_fluid_writes_close(self) -> None:
        self.solid_of(self.together([*self.pressed(), "--out", str(self.folder)], SPRING))
        with (self.folder / "energy_total.csv").open(encoding="utf-8") as file:
            lines = [line for line in file if not line.startswith("#")]
        names = [name.split("[")[0].strip() for name in lines[0].split(",")]
        table = np.array([line.split(",") for line in lines[1:]], dtype=float)
        self.assertAlmostEqual(table[:, names.index("solid")].max(), 1.99, delta=1e-3)
        self.assertLess(np.abs(table[:, names.index("drift")]).max(), 1e-6)   # 2.5e-7 J/m: each step's work is predicted, then mended

    def test_a_plate_that_moves_as_told(self) -> None:
        u, work = self.solid_of(self.together(self.pressed(), ["rigid", "--amplitude", "0.002", "--frequency", "7"]))
        self.assertAlmostEqual(u, 0.002 * np.sin(2 * np.pi * 7 * END), delta=1e-12)
        self.assertAlmostEqual(work, 1000 * u, delta=1e-9)

    def test_a_beam_under_a_sudden_pressure(self) -> None:
        mass, bending = 50.0, 1e3
        n = np.arange(1, 10, 2) * np.pi
        w = n**2 * np.sqrt(bending / mass)
        exact = (4e3 / (n * mass * w**2) * np.sin(n / 2) * (1 - np.cos(w * END))).sum()
        u, _ = self.solid_of(self.together(self.pressed(5e-5), ["beam", "--mass", str(mass), "--bending", str(bending),
                                                                "--facets", "80"]))
        self.assertAlmostEqual(u / exact, 1, delta=1e-3)

    def test_hydrostatic_force_on_a_wall(self) -> None:
        wall = ["rigid", "--amplitude", "0", "--frequency", "1", "--start", "0", "0", "--end", "0", "1"]
        done = self.together(["hydrostatic", "--level", "0.75", "--dt", "1e-3"], wall)
        np.testing.assert_allclose(self.fluid_of(done), (-0.5 * 9810 * 0.75**2, 0, 0), rtol=1e-9)

    def test_a_recorded_ramp(self) -> None:
        table = self.folder / "ramp.csv"
        table.write_text("t[s],p[Pa]\n0,0\n1,20000\n", encoding="utf-8")
        u, _ = self.solid_of(self.together(["recorded", "--table", str(table), "--dt", "1e-4"], SPRING))
        late = END - 1e-4                        # a parallel exchange applies the load one step after it was measured
        exact = 20000 / 1e6 * (late - np.sin(OMEGA * late) / OMEGA)
        self.assertAlmostEqual(u / exact, 1, delta=1e-4)

    def test_each_beside_a_shipped_program(self) -> None:
        u, _ = self.solid_of(self.together([], SPRING, "fluid.fluid.radiating=false", "fluid.fluid.dt=1e-4"))
        self.assertAlmostEqual(u / (1e-3 * (1 - np.cos(OMEGA * END))), 1, delta=1e-4)
        force = self.fluid_of(self.together(self.pressed(), []))       # fake_solid is the same plate, damped by HHT
        self.assertAlmostEqual(force[2] / (1 - np.cos(OMEGA * END)), 1, delta=2e-3)

    def test_what_cannot_be_is_said(self) -> None:
        table = self.folder / "table.csv"
        table.write_text("t[s],p[Pa]\n1,0\n0,1\n", encoding="utf-8")
        recorded = ["recorded", "--table", str(table), "--dt", "1e-4"]
        for fluid, more, words in ((recorded, (), "t[s] ascending"), (["constant", "--pressure", "1", "--dt", "0"], (), "step above zero"),
                                   (self.pressed(), ('coupling.coupling.scheme="parallel_impedance"', "coupling.coupling.impedance_factor=1"),
                                    "takes the load as it comes")):
            done = self.together(fluid, SPRING, *more)
            self.assertEqual(done.returncode, 2, done.stdout)
            self.assertIn(words, done.stdout)
            self.assertEqual(done.stdout.count("rivage: "), 1, done.stdout)


if __name__ == "__main__":
    main(__doc__)
