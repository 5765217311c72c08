# SPDX-License-Identifier: MIT
"""Bad mesh files: fem_solver names file, cell and cause, and ends with exit code 2.

usage: test_med_files.py --program FEM_SOLVER
"""
import argparse
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[2] / "cases" / "tools"))

from msh_to_med import write_med  # noqa: E402

ARGUMENTS = argparse.Namespace()
SOLID = """
[model]
dimension = {dimension}
[mesh]
kind = "med"
file = "{file}"
{more}
[material.rubber]
law = "elastic"
E = 1e6
nu = 0.3
density = 1000
[analysis]
kind = "static"
[[supports]]
group = "{group}"
fix = ["x", "y"]
"""
TRIANGLE, QUAD, EDGE, PRISM = 2, 3, 1, 6
POINTS = np.array([[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0], [1, 1, 0], [2, 1, 0], [9, 9, 0]], dtype=float)
TWO_QUADS = [(1, [1, 2, 5, 4]), (1, [2, 3, 6, 5])]
NAMES = {(2, 1): "body", (1, 2): "left"}
LEFT = [(2, [4, 1])]


class BadMeshes(unittest.TestCase):
    def setUp(self) -> None:
        scratch = tempfile.TemporaryDirectory(prefix="rivage_")
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)
        self.file = self.folder / "mesh.med"

    def write(self, cells, names=None, points=POINTS) -> None:
        write_med(self.file, names or NAMES, points, cells, "mesh")

    def check(self, *words: str, code: int = 2, group="left", more="", dimension=2) -> None:
        toml = self.folder / "solid.toml"
        toml.write_text(SOLID.format(file=self.file.name, group=group, more=more, dimension=dimension), encoding="utf-8")
        result = subprocess.run([ARGUMENTS.program, toml, "--check"], capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual(result.returncode, code, result.stderr)
        for word in words:
            self.assertIn(word, result.stderr if code else result.stdout + result.stderr)

    def test_good_file_passes_and_lone_nodes_are_left_out(self) -> None:
        self.write({QUAD: TWO_QUADS, EDGE: LEFT})
        self.check("2 elements quad4, 6 nodes", code=0)

    def test_turned_element(self) -> None:
        self.write({QUAD: [TWO_QUADS[0], (1, [2, 5, 6, 3])], EDGE: LEFT})
        self.check("mesh.med", "element 1 (quad4)", "(1, 0) m", "Jacobian", "inside out")

    def test_mixed_types(self) -> None:
        self.write({QUAD: TWO_QUADS[:1], TRIANGLE: [(1, [2, 3, 5])], EDGE: LEFT})
        self.check("mesh.med", "1 TRIA3", "1 QUAD4", "one type")

    def test_no_cells_of_the_models_dimension(self) -> None:
        self.write({QUAD: TWO_QUADS, EDGE: LEFT})
        self.check("the model has the dimension 3", "2 QUAD4", dimension=3)

    def test_face_of_no_element(self) -> None:
        self.write({QUAD: TWO_QUADS, EDGE: [(2, [1, 5])]})
        self.check("mesh.med", "SEG2 1 of the group 'left' at (0, 0) m", "no element")

    def test_face_inside_the_body(self) -> None:
        self.write({QUAD: TWO_QUADS, EDGE: [(2, [2, 5])]})
        self.check("SEG2 1 of the group 'left'", "inside the body, between the elements 0 and 1")

    def test_missing_group(self) -> None:
        self.write({QUAD: TWO_QUADS, EDGE: LEFT})
        self.check("no group 'lift'", "body, left", group="lift")

    def test_empty_group(self) -> None:
        self.write({QUAD: TWO_QUADS, EDGE: LEFT}, {**NAMES, (1, 3): "nothing"})
        self.check("the group 'nothing' holds no node")

    def test_mesh_out_of_the_plane(self) -> None:
        points = POINTS.copy()
        points[4, 2] = 0.1
        self.write({QUAD: TWO_QUADS, EDGE: LEFT}, points=points)
        self.check("plane z = constant", "0.1 along z")

    def test_two_meshes_in_a_file(self) -> None:
        self.write({QUAD: TWO_QUADS, EDGE: LEFT})
        with h5py.File(self.file, "a") as file:
            file.copy("ENS_MAA/mesh", "ENS_MAA/other")
            file.copy("FAS/mesh", "FAS/other")
        self.check("several meshes", "'mesh', 'other'")
        self.check("2 elements quad4", code=0, more='name = "other"')
        self.check("no mesh 'third'", "'mesh', 'other'", more='name = "third"')

    def test_node_that_does_not_exist(self) -> None:
        self.write({QUAD: [(1, [1, 2, 5, 44])], EDGE: LEFT})
        self.check("QUAD4 1 has a node 44; there are 7")

    def test_no_such_file(self) -> None:
        self.check("mesh.med' cannot be opened")

    def test_no_med_file(self) -> None:
        self.file.write_text("$MeshFormat\n4.1 0 8\n", encoding="utf-8")
        self.check("mesh.med' is no MED file")

    def test_file_cut_off(self) -> None:
        self.write({QUAD: TWO_QUADS, EDGE: LEFT})
        whole = self.file.read_bytes()
        self.file.write_bytes(whole[: len(whole) // 2])
        self.check("mesh.med' is", "or it is cut off")

    def test_newer_version(self) -> None:
        self.write({QUAD: TWO_QUADS, EDGE: LEFT})
        with h5py.File(self.file, "a") as file:
            file["INFOS_GENERALES"].attrs["MAJ"] = np.int32(9)
        self.check("mesh.med' is of no version of MED that this library (4.1) reads", "as MED 4")


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", required=True)
    ARGUMENTS, rest = parser.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest])
