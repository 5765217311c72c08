# SPDX-License-Identifier: MIT
"""fem_solver on 1, 2 and 4 ranks: the same answers to 1e-8, the same fields, and errors that end all ranks in words.

usage: test_ranks.py --program FEM_SOLVER --mpiexec MPIEXEC
"""
import argparse
import csv
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

ARGUMENTS = argparse.Namespace()

MODEL = """
[model]
dimension = 2
[mesh]
kind = "block"
low = [0.0, 0.0]
high = [0.04, 0.02]
cells = [12, 6]
element = "quad8"
[material.rubber]
law = "neo_hookean"
E = 1e6
nu = 0.4
density = 1100
[[probes]]
name = "corner"
position = [0.04, 0.02]
quantities = ["displacement", "velocity"]
"""

STATIC = MODEL + """
[[supports]]
group = "left"
fix = ["x", "y"]
[[loads]]
name = "water"
kind = "pressure"
group = "top"
pressure = "1e3*x/0.04"
follower = true
[[loads]]
name = "spring"
kind = "spring"
position = [0.04, 0.0]
stiffness = [1e4, 1e4]
[analysis]
kind = "static"
load_steps = 2
"""

DRIVEN = MODEL + """
[[drives]]
group = "left"
centre = [0.0, 0.01]
angle = "0.3*sin(100*t)"
[time]
dt = 1e-4
end = 2e-3
"""

THROWN = MODEL + """
[initial]
velocity = [0.5, -0.4]
[gravity]
acceleration = [0.0, -9.81]
[[contact]]
group = "bottom"
ground = "plane"
point = [0.0, -1e-4]
friction = 0.3
[time]
alpha = -0.1
dt = 5e-5
end = 4e-3
"""

PRESSED = MODEL + """
[[supports]]
group = "top"
uy = "-2e-3*t"
fix = ["x"]
[[contact]]
group = "bottom"
ground = "formula"
height = "-1e-4 - 2*(x - 0.02)^2"
friction = 0.3
[analysis]
kind = "static"
load_steps = 2
"""

SOLID_3D = MODEL.replace("dimension = 2", "dimension = 3").replace("[0.0, 0.0]", "[0.0, 0.0, 0.0]").replace(
    "[0.04, 0.02]", "[0.04, 0.02, 0.02]").replace("[12, 6]", "[8, 4, 4]").replace("quad8", "hexa8") + """
[[supports]]
group = "left"
fix = ["x", "y", "z"]
[[loads]]
kind = "follower_traction"
group = "right"
traction = [0.0, 1e3, 2e3]
[time]
dt = 2e-4
end = 1e-3
"""


def run(folder: Path, ranks: int, text: str, *options: str) -> subprocess.CompletedProcess:
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "solid.toml").write_text(text, encoding="utf-8")
    line = [ARGUMENTS.mpiexec, "--oversubscribe", "-n", str(ranks), ARGUMENTS.program, str(folder / "solid.toml"),
            "--out", str(folder / "out")]
    for option in options:
        line += ["--set", option]
    return subprocess.run(line, capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=100, check=False)


def table(path: Path) -> tuple[list[str], np.ndarray]:
    with path.open(encoding="utf-8") as file:
        rows = list(csv.reader(file))
    return rows[0], np.array(rows[1:], dtype=float)


def scale(header: list[str], values: np.ndarray, column: str) -> float:
    """The largest value of all columns with the same unit: sums that cancel have none of their own."""
    unit = column[column.index("["):]
    return max(np.abs(values[:, k]).max() for k, name in enumerate(header) if name.endswith(unit))


def last_fields(path: Path) -> dict[str, np.ndarray]:
    """Points with their displacement, and elements' middles with their stress, sorted by place."""
    with h5py.File(path, "r") as file:
        start, end = file["step_000000"], file[sorted(file)[-1]]
        points, cells = start["points"][:], start["connectivity"][:]
        middles = points[cells].mean(axis=1)
        nodes = np.lexsort(np.round(points, 9).T)
        elements = np.lexsort(np.round(middles, 9).T)
        return {"displacement": end["displacement"][:][nodes], "stress": end["stress"][:][elements]}


class Ranks(unittest.TestCase):
    def setUp(self) -> None:
        scratch = tempfile.TemporaryDirectory(prefix="rivage_")
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def compare(self, text: str, *options: str, ranks: tuple[int, ...] = (2, 4), tolerance: float = 1e-8) -> None:
        alone = self.folder / "1"
        result = run(alone, 1, text)
        self.assertEqual(result.returncode, 0, result.stderr)
        for count in ranks:
            shared = self.folder / str(count)
            result = run(shared, count, text, *options)
            self.assertEqual(result.returncode, 0, result.stderr)
            for path in sorted((alone / "out" / "solid").glob("*.csv")):
                header, expected = table(path)
                own_header, found = table(shared / "out" / "solid" / path.name)
                self.assertEqual(own_header, header)
                for column, difference in zip(header, np.abs(found - expected).max(axis=0)):
                    self.assertLess(difference, tolerance * scale(header, expected, column) + 1e-12,
                                    f"{path.name} {column} on {count} ranks")
            one, several = (last_fields(place / "out" / "solid" / "fields.h5") for place in (alone, shared))
            for name, values in one.items():
                self.assertEqual(several[name].shape, values.shape)
                self.assertLess(np.abs(several[name] - values).max(), tolerance * np.abs(values).max(), name)

    def test_static(self) -> None:
        self.compare(STATIC)

    def test_driven_face(self) -> None:
        self.compare(DRIVEN, ranks=(3,))

    def test_impact_with_friction(self) -> None:
        self.compare(THROWN, ranks=(2,))

    def test_curved_ground_with_multipliers(self) -> None:
        self.compare(PRESSED, ranks=(3,))

    def test_solid_in_space(self) -> None:
        self.compare(SOLID_3D, ranks=(2,))

    def test_multigrid(self) -> None:
        for method in ("gamg", "hypre"):
            self.compare(SOLID_3D, f"solid.linear_solver.method={method}", ranks=(2,))

    def fails(self, code: int, words: list[str], text: str, *options: str) -> None:
        result = run(self.folder, 2, text, *options)
        self.assertEqual(result.returncode, code, result.stderr)
        for word in words:
            self.assertIn(word, result.stderr)
        self.assertEqual(result.stderr.count("rivage: "), 1, result.stderr)

    def test_elements_turned_inside_out_are_named_once(self) -> None:
        crushed = '[[supports]]\ngroup = "right"\nux = "-600*t"\nuy = "0"\n'
        held = '[[supports]]\ngroup = "left"\nfix = ["x", "y"]\n'
        self.fails(3, ["inside out", "turns element", "node"],
                   MODEL + held + crushed + "[time]\ndt = 0.01\nend = 0.1\n")

    def test_a_body_that_nothing_holds_is_named_once(self) -> None:
        self.fails(3, ["singular matrix", "Add supports"], STATIC.replace('fix = ["x", "y"]', 'fix = ["x"]').replace("1e4, 1e4", "0.0, 0.0"))

    def test_a_solver_for_one_rank_is_refused(self) -> None:
        self.fails(2, ["banded", "mumps"], STATIC, "solid.linear_solver.method=banded")

    def test_more_ranks_than_elements_are_refused(self) -> None:
        self.fails(2, ["1 elements", "-n 1"], STATIC, "solid.mesh.cells=[1, 1]")


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", required=True)
    parser.add_argument("--mpiexec", required=True)
    ARGUMENTS, rest = parser.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest])
