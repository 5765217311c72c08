# SPDX-License-Identifier: MIT
"""Contact with grounds of triangles and lines, as a user runs it: what a plane gives, an incline's exact answer, bad files in words.

usage: test_grounds.py --program FEM_SOLVER
"""
import argparse
import csv
import math
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

ARGUMENTS = argparse.Namespace()

BLOCK = """
[model]
dimension = {dimension}
[mesh]
low = {low}
high = {high}
cells = {cells}
element = "{element}"
[material.stiff]
law = "elastic"
kinematics = "small"
E = 1e8
nu = 0.0
density = 1000
[gravity]
acceleration = {gravity}
[analysis]
initial_equilibrium = true
load_steps = 1
[time]
alpha = -0.1
dt = 5e-4
end = 0.05
[initial]
velocity = {velocity}
[[probes]]
name = "mid"
position = {middle}
quantities = ["displacement", "velocity"]
[[contact]]
group = "bottom"
friction = 0.3
"""
PLANE_2D = BLOCK.format(dimension=2, low=[0.0, 0.0], high=[0.1, 0.02], cells=[6, 2], element="quad4", gravity=[0.0, -9.81],
                        velocity=[1.0, 0.0], middle=[0.05, 0.01])
PLANE_3D = BLOCK.format(dimension=3, low=[0.0, 0.0, 0.0], high=[0.1, 0.02, 0.02], cells=[3, 1, 1], element="hexa8",
                        gravity=[0.0, 0.0, -9.81], velocity=[1.0, 0.2, 0.0], middle=[0.05, 0.01, 0.01]).replace(
                            'group = "bottom"', 'group = "back"')
LINE = "x[m],y[m]\n-1,0\n0.03,0\n0.061,0\n3,0\n"
SQUARE = [[(-1, -1, 0), (1, -1, 0), (1, 1, 0)], [(-1, -1, 0), (1, 1, 0), (-1, 1, 0)]]


def stl(triangles: list) -> str:
    facets = "".join("facet normal 0 0 0\nouter loop\n" + "".join("vertex {} {} {}\n".format(*corner) for corner in triangle) +
                     "endloop\nendfacet\n" for triangle in triangles)
    return f"solid ground\n{facets}endsolid ground\n"


class Grounds(unittest.TestCase):
    def setUp(self) -> None:
        scratch = tempfile.TemporaryDirectory(prefix="rivage_")
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def run_solid(self, text: str, **files: str) -> subprocess.CompletedProcess:
        for name, content in files.items():
            (self.folder / name.replace("_", ".")).write_text(content, encoding="utf-8")
        (self.folder / "solid.toml").write_text(text, encoding="utf-8")
        return subprocess.run([ARGUMENTS.program, str(self.folder / "solid.toml"), "--out", str(self.folder / "out")],
                              capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=100, check=False)

    def probes(self, text: str, **files: str) -> np.ndarray:
        result = self.run_solid(text, **files)
        self.assertEqual(result.returncode, 0, result.stderr)
        with (self.folder / "out" / "solid" / "probes.csv").open(encoding="utf-8") as file:
            return np.array(list(csv.reader(file))[1:], dtype=float)

    def test_a_line_is_a_plane(self) -> None:
        plane = self.probes(PLANE_2D)
        line = self.probes(PLANE_2D + 'ground = "surface"\nfile = "ground.csv"\n', ground_csv=LINE)
        self.assertGreater(plane[-1, 1], 0.04)
        self.assertLess(np.abs(line - plane).max(), 1e-9)

    def test_two_triangles_are_a_plane(self) -> None:
        plane = self.probes(PLANE_3D)
        surface = self.probes(PLANE_3D + 'ground = "surface"\nfile = "ground.stl"\n', ground_stl=stl(SQUARE))
        self.assertGreater(plane[-1, 1], 0.03)
        self.assertLess(np.abs(surface - plane).max(), 1e-9)

    def test_sliding_down_an_incline_of_triangles(self) -> None:
        """a = g (sin - mu cos) = 0.58970 m/s2 at 20 degrees; gravity is turned instead of the ground."""
        tilt = math.radians(20)
        text = PLANE_3D.replace("[0.0, 0.0, -9.81]", f"[{9.81 * math.sin(tilt)}, 0.0, {-9.81 * math.cos(tilt)}]").replace(
            "[1.0, 0.2, 0.0]", "[0.1, 0.0, 0.0]").replace("initial_equilibrium = true", "")
        probes = self.probes(text + 'ground = "surface"\nfile = "ground.stl"\n', ground_stl=stl(SQUARE))
        self.assertAlmostEqual((probes[-1, 4] - 0.1) / 0.05 / 0.58970, 1, delta=0.005)

    def test_a_contact_that_does_not_settle_cuts_the_step_and_says_so(self) -> None:
        thrown = PLANE_2D.replace("[1.0, 0.0]", "[0.0, -5.0]").replace("initial_equilibrium = true", "")
        result = self.run_solid(thrown + 'formulation = "augmented_lagrangian"\nmax_augmentations = 1\ntolerance = 1e-12\n')
        said = result.stdout + result.stderr
        self.assertEqual(result.returncode, 3, said)
        self.assertIn("did not settle in 1 augmentations", said)
        self.assertIn("half of it is tried", said)
        self.assertIn("at node", said)

    def bad(self, text: str, *words: str, **files: str) -> None:
        result = self.run_solid(text, **files)
        self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
        for word in words:
            self.assertIn(word, result.stderr)

    def test_bad_files(self) -> None:
        surface = 'ground = "surface"\n'
        self.bad(PLANE_3D + surface, "needs file", "FILE.stl")
        self.bad(PLANE_3D + surface + 'file = "none.stl"\n', "none.stl")
        self.bad(PLANE_3D + surface + 'file = "ground.stl"\n', "ground.stl", ground_stl="nonsense")
        self.bad(PLANE_2D + surface + 'file = "ground.csv"\n', "two points at least", ground_csv="x[m],y[m]\n0,0\n")
        self.bad(PLANE_2D + 'ground = "table"\nfile = "none.h5"\n', "none.h5")


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", required=True)
    ARGUMENTS, rest = parser.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest])
