# SPDX-License-Identifier: MIT
"""What is drawn of a mesh's cells: plane cells themselves, of cells in space their outer faces."""
import numpy as np

from field_file import FieldStep

# The corner-and-edge walk around a plane cell, by number of nodes: corners come first, then the mid-sides.
OUTLINE = {3: (0, 1, 2), 6: (0, 3, 1, 4, 2, 5), 4: (0, 1, 2, 3), 8: (0, 4, 1, 5, 2, 6, 3, 7), 9: (0, 4, 1, 5, 2, 6, 3, 7)}
# Corners of the faces of a cell in space, likewise.
TETRAHEDRON = ((0, 1, 2), (0, 1, 3), (1, 2, 3), (0, 2, 3))
HEXAHEDRON = ((0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
FACES = {4: TETRAHEDRON, 10: TETRAHEDRON, 8: HEXAHEDRON, 20: HEXAHEDRON, 27: HEXAHEDRON}


def outer_faces(cells: np.ndarray) -> np.ndarray:
    """The faces (n x corners) that belong to one cell only."""
    faces = np.vstack([cells[:, corners] for corners in FACES[cells.shape[1]]])
    _, first, count = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    return faces[first[count == 1]]


def is_plane(step: FieldStep) -> bool:
    return not np.any(step.points[:, 2])


def polygons(step: FieldStep) -> np.ndarray | None:
    """Node numbers (n x corners) of what is drawn; None without cells, or with cells that are not known here."""
    cells = step.connectivity
    if cells is None or cells.ndim != 2 or cells.shape[1] not in (OUTLINE if is_plane(step) else FACES):
        return None
    return cells[:, OUTLINE[cells.shape[1]]] if is_plane(step) else outer_faces(cells)
