# SPDX-License-Identifier: MIT
"""The two ends of an interface."""
import ctypes
import os
import sys
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from rivage import library as c

EVERYWHERE = np.array([[-1e30] * 3, [1e30] * 3])


@dataclass(frozen=True)
class Window:
    """Packet `step` is exchanged at `time` [s], and a step of `dt` follows. step -1 is the greeting."""
    step: int
    time: float
    dt: float
    last: bool = False
    stop_requested: bool = False


def fill(report, values: dict) -> None:
    """Sets a report's fields. Raises TypeError on a name that it does not have."""
    known = {name for name, *_ in report._fields_}
    for name, value in values.items():
        if name not in known:
            raise TypeError(f"'{name}' is no field of a report; there are: {', '.join(sorted(known))}")
        if name in ("force", "moment"):
            value = (ctypes.c_double * 3)(*np.pad(np.ravel(value), (0, 3 - np.size(value))))
        setattr(report, name, value)


def rows_of_nodes(facets) -> np.ndarray:
    """As rows of four, -1 where unused. Raises TypeError where they are no rows."""
    rows = np.full((len(facets), 4), -1, dtype=np.int32)
    for row, nodes in zip(rows, facets):
        if np.ndim(nodes) != 1 or not 2 <= len(nodes) <= 4:
            raise TypeError(f"facets are rows of 2 to 4 node indices, [[0, 1], ...], not {facets!r}")
        row[:len(nodes)] = nodes
    return rows


class Solid:
    """The solid's end. After `receive`: force [nodes, dimension] or pressure [facets], impedance rho c [kg/(m^2 s)],
    wall_velocity [nodes, dimension], fluid_report."""

    def __init__(self, participant, check, dimension: int, node_ids, reference, facets, facet_ids):
        self.participant, self.check = participant, check
        ids = np.ascontiguousarray(node_ids, dtype=np.int64)
        self.reference = c.as_array(reference, np.float64, (len(ids), dimension), "reference").copy()
        self.facets = rows_of_nodes(facets)
        numbers = c.as_array(np.arange(len(facets)) if facet_ids is None else facet_ids, np.int64, (len(facets),), "facet_ids")
        self.window, self.answered, self.predicted = Window(-1, 0, 0), True, False
        self.handle = ctypes.c_void_p()
        check(c.LIBRARY.rivage_solid_open(participant.handle, dimension, len(ids), c.pointer(ids, c.LONG), c.pointer(self.reference),
                                          len(facets), c.pointer(numbers, c.LONG), c.pointer(self.facets, c.INT),
                                          ctypes.byref(self.handle)))

    def receive(self) -> Window:
        """Waits for the fluid's packet. Raises RuntimeError where the last one was not answered."""
        if not self.answered:
            raise RuntimeError(f"window {self.window.step} was not answered: call send once in each")
        window = c.CWindow()
        self.check(c.LIBRARY.rivage_solid_receive(self.handle, ctypes.byref(window)))
        self.window = Window(window.step, window.time, window.dt, bool(window.last), bool(window.stop_requested))
        self.answered = False
        return self.window

    @property
    def answered_last(self) -> bool:
        return self.window.last and self.answered

    def windows(self) -> Iterator[Window]:
        """Receives until the last window; answer each with one `send`."""
        while not self.answered_last:
            yield self.receive()

    @property
    def force(self) -> np.ndarray:
        """On the nodes. Raises RuntimeError where the load is averaged."""
        if self.is_averaged:
            raise RuntimeError('interface.load is "averaged": the load is in `pressure`, `nodal_force` makes forces of it')
        return c.view(c.LIBRARY.rivage_solid_force(self.handle), self.reference.shape)

    @property
    def pressure(self) -> np.ndarray:
        """Of the facets. Raises RuntimeError where the load is conservative."""
        if c.LIBRARY.rivage_solid_force(self.handle):
            raise RuntimeError('interface.load is "conservative": the load is in `force`')
        return c.view(c.LIBRARY.rivage_solid_pressure(self.handle), (len(self.facets),))

    @property
    def is_averaged(self) -> bool:
        """Whether the load that came is a pressure on facets (interface.load = "averaged") and no force on nodes."""
        return bool(c.LIBRARY.rivage_solid_pressure(self.handle))

    def inward(self, position: np.ndarray) -> np.ndarray:
        """Normal of each facet into the body, times its length or area [facets, dimension]."""
        corner = position[self.facets[:, :3]]
        if self.reference.shape[1] == 2:
            along = corner[:, 1] - corner[:, 0]
            return np.column_stack([-along[:, 1], along[:, 0]])
        last = np.where(self.facets[:, 3] < 0, self.facets[:, 0], self.facets[:, 3])     # a triangle is a quadrilateral with a = d
        return -0.5 * np.cross(corner[:, 2] - corner[:, 0], position[last] - corner[:, 1])

    def nodal_force(self, position: np.ndarray) -> np.ndarray:
        """The load as forces on nodes [nodes, dimension]; of an averaged one equal parts of p n A on each corner, the surface at `position`."""
        if not self.is_averaged:
            return np.array(self.force)
        used = self.facets >= 0
        part = (self.pressure / used.sum(axis=1))[:, None] * self.inward(position)
        force = np.zeros_like(self.reference)
        np.add.at(force, self.facets[used], np.repeat(part, used.sum(axis=1), axis=0))
        return force

    @property
    def wall_velocity(self) -> np.ndarray:
        """Mean velocity of the nodes while the load was measured."""
        return c.view(c.LIBRARY.rivage_solid_wall_velocity(self.handle), self.reference.shape)

    @property
    def impedance(self) -> float:
        return c.LIBRARY.rivage_solid_impedance(self.handle)

    @property
    def fluid_report(self) -> c.FluidReport:
        report = c.FluidReport()
        self.check(c.LIBRARY.rivage_solid_fluid_report(self.handle, ctypes.byref(report)))
        return report

    def predict(self, velocity, dt: float) -> None:
        """What coupling.scheme makes of the load for a step of dt, in place; once for each step, with the velocity at its start."""
        array = c.as_array(velocity, np.float64, self.reference.shape, "velocity")
        self.predicted = True
        self.check(c.LIBRARY.rivage_solid_predict(self.handle, c.pointer(array), dt))

    def send(self, position, velocity, acceleration, **report) -> None:
        """Answers the last receive, each array [nodes, dimension]. report: fields of SolidReport, e.g. work, kinetic, strain."""
        if self.window.step == 1 and not self.predicted and self.participant.impedance_share > 0:
            print(f"{self.participant.role}: warning: this solid takes the load as it comes, though coupling.scheme = \"parallel_impedance\": it "
                  "runs as \"parallel\", which is stable while rho c dt / (mass per wet area) stays well below 1", file=sys.stderr, flush=True)
        arrays = [c.as_array(values, np.float64, self.reference.shape, name)
                  for name, values in (("position", position), ("velocity", velocity), ("acceleration", acceleration))]
        told = c.SolidReport()
        fill(told, report)
        self.check(c.LIBRARY.rivage_solid_send(self.handle, *map(c.pointer, arrays), ctypes.byref(told)))
        self.answered = True

    def close(self) -> None:
        if self.handle:
            self.check(c.LIBRARY.rivage_solid_close(self.handle))
        self.handle = None


class Fluid:
    """The fluid's end. After `receive`: node_ids, facet_ids, facet_nodes [facets, 4], position, velocity and acceleration
    [nodes, dimension] of the facets in the region asked for."""

    def __init__(self, participant, check, dimension: int, impedance: float, partner: str | None, pressure_limit: float,
                 output_dir: str | os.PathLike | None):
        self.participant, self.check, self.dimension = participant, check, dimension
        self.answered_last = False
        self.handle = ctypes.c_void_p()
        check(c.LIBRARY.rivage_fluid_open(participant.handle, partner.encode() if partner else None, dimension, impedance,
                                          pressure_limit, os.fsencode(output_dir) if output_dir else None, ctypes.byref(self.handle)))

    @property
    def facet_count(self) -> int:
        return c.LIBRARY.rivage_fluid_facets(self.handle)

    def nodal(self, name: str) -> np.ndarray:
        shape = (c.LIBRARY.rivage_fluid_nodes(self.handle), self.dimension)
        return c.view(getattr(c.LIBRARY, f"rivage_fluid_{name}")(self.handle), shape)

    @property
    def position(self) -> np.ndarray:
        return self.nodal("position")

    @property
    def velocity(self) -> np.ndarray:
        return self.nodal("velocity")

    @property
    def acceleration(self) -> np.ndarray:
        return self.nodal("acceleration")

    @property
    def node_ids(self) -> np.ndarray:
        return c.view(c.LIBRARY.rivage_fluid_node_ids(self.handle), (c.LIBRARY.rivage_fluid_nodes(self.handle),), np.int64)

    @property
    def facet_ids(self) -> np.ndarray:
        return c.view(c.LIBRARY.rivage_fluid_facet_ids(self.handle), (self.facet_count,), np.int64)

    @property
    def facet_nodes(self) -> np.ndarray:
        return c.view(c.LIBRARY.rivage_fluid_facet_nodes(self.handle), (self.facet_count, 4), np.int32)

    @property
    def stop_agreed(self) -> bool:
        """The next window must be the last, with stop_requested."""
        return bool(c.LIBRARY.rivage_fluid_stop_agreed(self.handle))

    def send(self, window: Window, corner_force=None, weight=None, weighted_pressure=None, full_weight=None, region=EVERYWHERE,
             **report) -> None:
        """Sends the load on the facets of the last receive: corner_force [facets, 4, dimension], and for averaged loads weight,
        weighted_pressure, full_weight [facets]. region: [[low], [high]] of the box where facets are wanted."""
        facets, low_high = self.facet_count, np.zeros((2, 3))
        low_high[:, :np.shape(region)[1]] = region
        shapes = ((facets, 4, self.dimension), (facets,), (facets,), (facets,))
        names = ("corner_force", "weight", "weighted_pressure", "full_weight")
        arrays = [None if values is None else c.as_array(values, np.float64, shape, name) for name, shape, values in
                  zip(names, shapes, (corner_force, weight, weighted_pressure, full_weight))]
        told, sent = c.FluidReport(), c.CWindow(window.step, window.time, window.dt, window.last, window.stop_requested)
        fill(told, report)
        self.sent_last = window.last
        self.check(c.LIBRARY.rivage_fluid_send(self.handle, ctypes.byref(sent), c.pointer(low_high[0]), c.pointer(low_high[1]),
                                               *map(c.pointer, arrays), ctypes.byref(told)))

    def receive(self) -> c.SolidReport:
        """Waits for the solid's answer; returns its report."""
        report = c.SolidReport()
        self.check(c.LIBRARY.rivage_fluid_receive(self.handle, ctypes.byref(report)))
        self.answered_last = self.sent_last
        return report

    def close(self) -> None:
        if self.handle:
            self.check(c.LIBRARY.rivage_fluid_close(self.handle))
        self.handle = None
