# SPDX-License-Identifier: MIT
"""Fields, mesh and start of the stand-in."""
import numpy as np

LOW, HIGH, CELLS = (0.1, 0.0), (0.105, 0.079), (4, 40)


class ConvergenceError(Exception):
    pass


def init(comm) -> None:
    assert comm.size == 1


class Coordinates:
    def __init__(self, points: np.ndarray):
        self.points = points

    def getValues(self) -> list[float]:
        return list(self.points.ravel())


class Mesh:
    """The plate's nodes on its outline and the SEG3 cells of "wet", turned outwards by ORIE_PEAU alone."""

    def __init__(self):
        x, y = (np.linspace(LOW[k], HIGH[k], 2 * CELLS[k] + 1) for k in range(2))
        down = [(LOW[0], value) for value in y[::-1]]
        along = [(value, LOW[1]) for value in x[1:]]
        up = [(HIGH[0], value) for value in y[1:]]
        self.points = np.column_stack([np.array(down + along + up), np.zeros(len(down) + len(along) + len(up))])
        count = (len(self.points) - 1) // 2
        self.cells = [(2 * k + 2, 2 * k, 2 * k + 1) for k in range(count)]       # the wrong way round

    def orient(self) -> None:
        self.cells = [(min(a, b), max(a, b), middle) for a, b, middle in self.cells]

    def getCells(self, group: str) -> list[int]:
        assert group == "wet"
        return list(range(len(self.cells)))

    def getNodeName(self, node: int) -> str:
        return f"N{node + 1}"

    def getConnectivity(self) -> list[tuple]:
        return self.cells

    def getCoordinates(self) -> Coordinates:
        return Coordinates(self.points)


class SimpleField:
    """Values of some components at some nodes."""

    def __init__(self, mesh: Mesh, quantity: str, values: dict):
        self.mesh, self.quantity, self.values = mesh, quantity, values

    def setValues(self, nodes, components, values) -> None:
        assert len(nodes) == len(components) == len(values)
        self.values |= {(int(node), component): value for node, component, value in zip(nodes, components, values)}

    def getValuesWithDescription(self) -> tuple:
        nodes, components = zip(*self.values)
        return list(self.values.values()), (list(nodes), list(components))

    def toFieldOnNodes(self) -> "FieldOnNodesReal":
        field = FieldOnNodesReal(self.mesh, self.quantity, {})
        field.values = dict(self.values)
        return field


class FieldOnNodesReal:
    def __init__(self, mesh: Mesh, quantity: str, everywhere: dict):
        assert quantity in ("PRES_R", "DEPL_R")
        self.mesh, self.quantity = mesh, quantity
        self.values = {(node, name): value for node in range(len(mesh.points)) for name, value in everywhere.items()}

    def toSimpleFieldOnNodes(self) -> SimpleField:
        return SimpleField(self.mesh, self.quantity, dict(self.values))
