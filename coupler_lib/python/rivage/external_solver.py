# SPDX-License-Identifier: MIT
"""Carries a solver of the shape that Code_Aster gives its external couplings through a run, as the solid.

    converged, fields = solver.run_iteration(i_iter, current_time, delta_t, data)

data: {"fluid_forces": [nodes, dimension]} where interface.load is "conservative", {"fluid_pressure": [facets]} where it is "averaged",
constant over the step; fields: {"mesh_displacement": ..., "mesh_velocity": ...} [nodes, dimension] at current_time, the end of
a step of delta_t. i_iter is 0, the first of a step as Code_Aster counts them: the coupling is explicit, one call a step. With
coupling.solid_every = k the call is made once for k steps of the fluid, with their mean load and their whole length.
"""
from typing import Protocol

import numpy as np

from rivage.participant import Error, Participant
from rivage.sides import Solid, Window

FIELDS = ("mesh_displacement", "mesh_velocity")


class ExternalSolver(Protocol):
    def run_iteration(self, i_iter: int, current_time: float, delta_t: float, data: dict) -> tuple[bool, dict]: ...


def taken(fields: dict, shape: tuple[int, ...], time: float) -> list[np.ndarray]:
    """The two fields as arrays. Raises Error(2) where one is missing or has another shape, Error(3) where one is not a number."""
    arrays = []
    for name in FIELDS:
        if name not in fields:
            raise Error(2, f"run_iteration returned no '{name}' at t = {time:g} s, but {sorted(fields)}")
        array = np.array(fields[name], dtype=float)
        if array.shape != shape:
            raise Error(2, f"'{name}' has the shape {array.shape} at t = {time:g} s, but {shape} is wanted")
        if not np.isfinite(array).all():
            raise Error(3, f"'{name}' is not a number at t = {time:g} s, node {int(np.argwhere(~np.isfinite(array))[0, 0])} of the surface")
        arrays.append(array)
    return arrays


class Carrier:
    """The surface's state between the calls. Its acceleration is the mean one of the last step, (v_1 - v_0)/dt: the interface has none."""

    def __init__(self, wet: Solid, solver: ExternalSolver):
        self.wet, self.solver, self.calls = wet, solver, 0
        self.displacement, self.velocity, self.acceleration = (np.zeros_like(wet.reference) for _ in range(3))
        self.work, self.force = 0.0, np.zeros(wet.reference.shape[1])

    def call(self, time: float, dt: float) -> None:
        """One step to `time`. The load's work is f . du, f on the mean of the surfaces before and after: exact for a pressure on segments."""
        data = {"fluid_pressure": np.array(self.wet.pressure)} if self.wet.is_averaged else {"fluid_forces": np.array(self.wet.force)}
        converged, fields = self.solver.run_iteration(0, time, dt, data)
        self.calls += 1
        if not converged:
            raise Error(3, f"the solver did not converge in its step to t = {time:g} s, dt = {dt:g} s")
        displacement, velocity = taken(fields, self.displacement.shape, time)
        force = self.wet.nodal_force(self.wet.reference + 0.5 * (self.displacement + displacement))
        self.work += float((force * (displacement - self.displacement)).sum())
        self.force, self.acceleration = force.sum(axis=0), (velocity - self.velocity) / dt
        self.displacement, self.velocity = displacement, velocity

    def send(self) -> None:
        energies = self.solver.energies() if hasattr(self.solver, "energies") else {}
        self.wet.send(self.wet.reference + self.displacement, self.velocity, self.acceleration, work=self.work, force=self.force,
                      displacement_max=float(np.linalg.norm(self.displacement, axis=1).max()), **energies)


def carry(me: Participant, solver: ExternalSolver, node_ids, reference, facets, facet_ids=None) -> Carrier:
    """Answers every window until the run ends. The wet surface: as Participant.solid takes it, at rest at the start.

    `solver.energies()`, where it has one, gives kinetic, strain, ... for the audit. Raises Error, which ends the whole run.
    """
    if me.impedance_share > 0:
        raise Error(2, 'an external solver takes the load as it comes: write coupling.scheme = "parallel" or "serial"')
    reference = np.asarray(reference, dtype=float)
    carrier = Carrier(me.solid(reference.shape[1], node_ids, reference, facets, facet_ids), solver)
    before = Window(-1, 0, 0)
    for window in carrier.wet.windows():
        if me.serial and window.step > 0:
            carrier.call(window.time, before.dt)                     # the load of the step that the fluid has made
        carrier.send()
        before = window
        if window.step >= 0 and not (me.serial or window.last):
            carrier.call(window.time + window.dt, window.dt)         # while the fluid makes the same step
    return carrier
