# SPDX-License-Identifier: MIT
"""Solvers of the shape that Code_Aster gives its external couplings: a plate on a spring, and the gate's command file on a stand-in.

usage: code_aster.py --build FOLDER [unittest's arguments]
"""
import re
import subprocess
from pathlib import Path

import numpy as np

from coupled_run import ROOT
from outside_test import CASE, OutsideTest, main

HERE = Path(__file__).resolve().parent
EXAMPLE = ROOT / "coupler_lib/python/examples/code_aster"
END, DT, OMEGA = 0.03, 1e-4, 100.0
PRESSURE = 1e6                                   # on the gate [Pa]
SETTINGS = (f"coupling.time.end={END}", "coupling.coupling.acceleration=nodal", 'coupling.coupling.scheme="parallel"')
EXACT = 1e-3 * (1 - np.cos(OMEGA * END))         # 1000 N on 100 kg and 1e6 N/m
# The trapezoidal rule under the load of the step, constant over it.
PLATE = """
import sys
import numpy as np
import rivage
from rivage.external_solver import carry

MASS, STIFFNESS = 100.0, 1e6

class Plate:
    u = v = 0.0

    def run_iteration(self, i_iter, current_time, delta_t, data):
        assert i_iter == 0 and abs(current_time / delta_t - round(current_time / delta_t)) < 1e-6
        down = -data["fluid_pressure"][0] * 1.0 if "fluid_pressure" in data else data["fluid_forces"][:, 1].sum()
        before = (down - STIFFNESS * self.u) / MASS
        ahead = self.u + delta_t * self.v + 0.25 * delta_t**2 * before
        after = (down - STIFFNESS * ahead) / (MASS + 0.25 * delta_t**2 * STIFFNESS)
        self.u, self.v = ahead + 0.25 * delta_t**2 * after, self.v + 0.5 * delta_t * (before + after)
        fields = {"mesh_displacement": [[0, self.u]] * 2, "mesh_velocity": [[0, self.v]] * 2}
        return True, fields

    def energies(self):
        return {"kinetic": 0.5 * MASS * self.v**2, "strain": 0.5 * STIFFNESS * self.u**2}

with rivage.Participant("solid", sys.argv[1], sys.argv[2:]) as me:
    done = carry(me, Plate(), [0, 1], [[1, 0], [0, 0]], [[0, 1]])
    print(f"plate: {done.calls} calls, u = {done.displacement[0, 1]:.9e} m, work {done.work:.9e} J/m", flush=True)
"""


class CodeAster(OutsideTest):
    python_paths = (HERE / "stand_in",)

    def together(self, script: Path, case: Path, *settings: str, pressure: float = 1000, dt: float = DT) -> subprocess.CompletedProcess:
        fluid = ["constant", "--pressure", str(pressure), "--dt", str(dt), "--out", str(self.folder)]
        return self.mpirun(["-n", "1", "/usr/bin/python3", "-m", "rivage.fake_fluid", str(case), *fluid,
                            *(word for setting in settings for word in ("--set", setting))],
                           ["-n", "1", "/usr/bin/python3", str(script), str(case), *settings])

    def plate(self, *more: str, good: str = "", bad: str = "") -> subprocess.CompletedProcess:
        path = self.folder / "plate.py"
        path.write_text(PLATE.replace(good, bad) if good else PLATE, encoding="utf-8")
        return self.together(path, CASE, *SETTINGS, *more)

    def gate(self, *more: str, good: str = "", bad: str = "", pressure: float = PRESSURE) -> subprocess.CompletedProcess:
        """The example, its command file with `bad` put for `good`."""
        path = self.folder / "gate.py"
        text = (EXAMPLE / "gate.py").read_text(encoding="utf-8")
        self.assertIn(good, text)
        path.write_text(text.replace(good, bad) if good else text, encoding="utf-8")
        return self.together(path, EXAMPLE / "coupling.toml", "coupling.time.end=0.001", *more, pressure=pressure, dt=1e-6)

    def told(self, done: subprocess.CompletedProcess, name: str) -> tuple[int, float, float]:
        """Calls, displacement and work at the end."""
        self.assertEqual(done.returncode, 0, done.stdout)
        found = re.search(rf"{name}: (\d+) calls, u = (\S+) m, work (\S+) J/m", done.stdout)
        self.assertIsNotNone(found, done.stdout)
        return int(found[1]), float(found[2]), float(found[3])

    def test_a_plate_on_a_spring_with_both_loads_and_the_serial_scheme(self) -> None:
        for more in ((), ('coupling.interface.load="averaged"',), ('coupling.coupling.scheme="serial"',)):
            with self.subTest(more=more):
                calls, u, work = self.told(self.plate(*more), "plate")
                self.assertEqual(calls, 300)
                self.assertAlmostEqual(u / -EXACT, 1, delta=2e-6)    # 1.8e-6: the phase, (w dt)^2/12 of it
                self.assertAlmostEqual(work, -1000 * u, delta=1e-9)

    def test_a_dear_solver_is_called_once_for_several_steps_of_the_fluid(self) -> None:
        for scheme in ("parallel", "serial"):
            with self.subTest(scheme):
                calls, u, work = self.told(self.plate("coupling.coupling.solid_every=4", f'coupling.coupling.scheme="{scheme}"'), "plate")
                self.assertEqual(calls, 75)
                self.assertAlmostEqual(u / -EXACT, 1, delta=3.2e-5)  # 16 times as much with dt four times as long
                self.assertAlmostEqual(work, -1000 * u, delta=1e-9)

    def test_the_audit_closes(self) -> None:
        for more, most, end in (((), 6e-5, 1e-7), (('coupling.interface.load="averaged"',), 6e-5, 1e-7),
                                (("coupling.coupling.solid_every=4",), 9e-4, 6e-6)):
            with self.subTest(more=more):
                self.told(self.plate(*more), "plate")
                lines = [line for line in (self.folder / "energy_total.csv").read_text(encoding="utf-8").splitlines() if line[0] != "#"]
                column = [name.startswith("drift") for name in lines[0].split(",")].index(True)
                drift = np.abs([float(line.split(",")[column]) for line in lines[1:]])
                self.assertLess(drift.max(), most)                   # J/m of 1.99: the acceleration of the start is not known
                self.assertLess(drift[-1], end)

    def test_the_command_file_on_the_stand_in(self) -> None:
        """A plate of 0.4345 kg/m on a spring of 12 MN/m, 1 MPa on 5 mm of lower face, its sides in balance."""
        mass, spring, push = 1100 * 0.005 * 0.079, 12e6, PRESSURE * 0.005
        exact = (push - mass * 9.81) / spring * (1 - np.cos(np.sqrt(spring / mass) * 0.001))
        for load in ("conservative", "averaged"):
            for every in (1, 4):
                with self.subTest(load=load, every=every):
                    done = self.gate(f'coupling.interface.load="{load}"', f"coupling.coupling.solid_every={every}")
                    calls, u, work = self.told(done, "gate")
                    self.assertEqual(calls, 1000 / every)
                    self.assertAlmostEqual(u / exact, 1, delta=2.5e-5 * every**2)     # of second order in the step
                    self.assertAlmostEqual(work / (push * u), 1, delta=1e-9)

    def test_the_stand_in_refuses_what_code_aster_does_not_have(self) -> None:
        for good, bad, words in (('SCHEMA="HHT"', 'SCHEME="HHT"', "DYNA_NON_LINE, SCHEMA_TEMPS: {'SCHEME'} unknown"),
                                 ("CHAM_MATER=self", "CHAM_MATR=self", "DYNA_NON_LINE: missing {'CHAM_MATER'}, unknown {'CHAM_MATR'}"),
                                 ("FX=float(x)", "DX=float(x)", "AFFE_CHAR_MECA, FORCE_NODALE: {'DX'} unknown")):
            done = self.gate(good=good, bad=bad)
            self.assertEqual(done.returncode, 3, done.stdout)
            self.assertIn(words, done.stdout)

    def test_a_step_of_the_command_file_that_does_not_converge(self) -> None:
        done = self.gate("coupling.interface.motion_jump_limit=10", pressure=1e9)
        self.assertEqual(done.returncode, 3, done.stdout)
        self.assertIn("the solver did not converge in its step to t = ", done.stdout)
        self.assertEqual(done.stdout.count("rivage: "), 1, done.stdout)

    def test_what_cannot_be_is_said(self) -> None:
        for good, bad, code, words in (("return True", "return current_time < 0.001", 3, "the solver did not converge in its step to t = 0.001"),
                                       ("[[0, self.v]] * 2", "[[0, self.v]]", 2, "'mesh_velocity' has the shape (1, 2)"),
                                       ("[[0, self.u]] * 2", "[[0, np.nan]] * 2", 3, "'mesh_displacement' is not a number"),
                                       ('"mesh_velocity"', '"velocity"', 2, "no 'mesh_velocity'")):
            done = self.plate(good=good, bad=bad)
            self.assertEqual(done.returncode, code, done.stdout)
            self.assertIn(words, done.stdout)
            self.assertEqual(done.stdout.count("rivage: "), 1, done.stdout)
        done = self.plate('coupling.coupling.scheme="parallel_impedance"')
        self.assertEqual(done.returncode, 2, done.stdout)
        self.assertIn("takes the load as it comes", done.stdout)


if __name__ == "__main__":
    main(__doc__)
