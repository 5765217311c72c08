# SPDX-License-Identifier: MIT
"""What is drawn of a mesh: plane cells as they are, outer faces in space."""
import sys
import unittest
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "cases/tools"))

from cells import FACES, outer_faces, polygons  # noqa: E402
from field_file import FieldStep  # noqa: E402

CORNERS = np.array([[x, y, z] for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))], dtype=float)


def step(points, cells) -> FieldStep:
    return FieldStep(0.0, np.asarray(points, dtype=float), np.asarray(cells), {})


class Cells(unittest.TestCase):
    def test_two_bricks_have_ten_outer_faces(self):
        above = [4, 5, 6, 7, 8, 9, 10, 11]
        faces = outer_faces(np.array([list(range(8)), above]))
        self.assertEqual(len(faces), 10)
        self.assertNotIn([4, 5, 6, 7], np.sort(faces, axis=1).tolist())        # the one between them

    def test_faces_of_a_brick_enclose_it(self):
        area = sum(np.linalg.norm(np.cross(CORNERS[f[1]] - CORNERS[f[0]], CORNERS[f[3]] - CORNERS[f[0]])) for f in FACES[8])
        self.assertAlmostEqual(area, 6.0)

    def test_a_plane_cell_is_walked_around_its_mid_sides(self):
        six = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
        self.assertEqual(polygons(step(six, [range(6)])).tolist(), [[0, 3, 1, 4, 2, 5]])

    def test_unknown_cells_are_not_drawn(self):
        self.assertIsNone(polygons(step(CORNERS, [range(5)])))
        self.assertIsNone(polygons(FieldStep(0.0, CORNERS, None, {})))


if __name__ == "__main__":
    unittest.main()
