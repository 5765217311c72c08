# SPDX-License-Identifier: MIT
"""The elastic gate's solid played by GetFEM: gate.py coupling.toml [--as ROLE] [--out DIR] [--set KEY=VALUE ...]

The gate is that of fem_solver, read from its own solid.toml; elements, assembly and factorisation are GetFEM's and scipy's.
"""
import sys

import numpy as np
import scipy.sparse as sparse

import rivage
from hht import Hht, Load, NotConverged
from rubber import Rubber


def make_rubber(told: dict) -> Rubber:
    mesh, material = told["mesh"], told["material"]["rubber"]
    if material["law"] != "neo_hookean":
        raise rivage.Error(2, f"material.rubber.law = \"{material['law']}\": this solver knows neo_hookean alone")
    return Rubber(mesh["low"], mesh["high"], mesh["cells"], material["E"], material["nu"], material["density"],
                  told["gravity"]["acceleration"])


class WetFaces:
    """The three free faces as segments from node to node, the body on their left."""

    def __init__(self, body: Rubber, low, high):
        self.size = 2 * len(body.nodes)
        self.nodes = body.polyline([(low[0], high[1]), (low[0], low[1]), (high[0], low[1]), (high[0], high[1])])
        self.entries = 2 * self.nodes[:, None] + np.arange(2)
        self.reference = body.nodes[self.nodes]
        self.facets = np.column_stack([np.arange(len(self.nodes) - 1), np.arange(1, len(self.nodes))])

    def spread(self, on_nodes: np.ndarray) -> np.ndarray:
        """Of the wet nodes to all unknowns."""
        every = np.zeros(self.size)
        every[self.entries] = on_nodes
        return every

    def damping(self, impedance: float, force: np.ndarray, position: np.ndarray) -> sparse.csc_matrix:
        """Z of Z (v - w): on each end of a facet that the fluid presses on, half of rho c L n n^T."""
        pressed = (force != 0).any(axis=1)
        facets = self.facets[pressed[self.facets].all(axis=1)]
        along = position[facets[:, 1]] - position[facets[:, 0]]
        normal = np.column_stack([along[:, 1], -along[:, 0]])
        blocks = 0.5 * impedance * normal[:, :, None] * normal[:, None, :] / np.hypot(*along.T)[:, None, None]
        blocks, ends = np.concatenate([blocks, blocks]), self.entries[np.concatenate([facets[:, 0], facets[:, 1]])]
        rows, columns = np.broadcast_arrays(ends[:, :, None], ends[:, None, :])
        return sparse.csc_matrix((blocks.ravel(), (rows.ravel(), columns.ravel())), (self.size, self.size))


class Gate:
    """The solid's side of the exchange."""

    def __init__(self, me: rivage.Participant, told: dict):
        self.share = me.impedance_share
        self.body = make_rubber(told)
        low, high = told["mesh"]["low"], told["mesh"]["high"]
        self.faces = WetFaces(self.body, low, high)
        self.clamped = np.flatnonzero(np.repeat(self.body.nodes[:, 1] > high[1] - 1e-9, 2))
        self.tip = int(np.argmin(np.linalg.norm(self.body.nodes - told["probes"][0]["position"], axis=1)))
        self.told = told
        self.wet = me.solid(2, self.faces.nodes, self.faces.reference, self.faces.facets)
        self.tables = rivage.SolidTables(me, ["tip.ux[m]", "tip.uy[m]"])

    def start(self) -> None:
        """At rest under the load of window 0, which gives the first acceleration."""
        self.step = Hht(self.body, self.clamped, self.told["time"]["alpha"], self.told["newton"]["tolerance"],
                        Load(self.faces.spread(self.wet.force)))

    def load(self, dt: float) -> Load:
        """What came, made ready for a step of dt."""
        velocity = self.step.v[self.faces.entries]
        self.wet.predict(velocity, dt)
        if self.share == 0:
            return Load(self.faces.spread(self.wet.force))
        position = self.faces.reference + self.step.u[self.faces.entries]
        damping = self.faces.damping(self.share * self.wet.impedance, self.wet.force, position)
        return Load(self.faces.spread(self.wet.force), damping, self.faces.spread(self.wet.wall_velocity))

    def advance(self, dt: float) -> None:
        self.step.advance(self.load(dt), dt)

    def send(self, window: rivage.Window) -> None:
        if window.step < 0:
            zero = np.zeros_like(self.faces.reference)
            self.wet.send(self.faces.reference, zero, zero)
            return
        u, v, a = (field[self.faces.entries] for field in (self.step.u, self.step.v, self.step.a))
        energies = {"kinetic": self.step.kinetic, "strain": self.body.strain_energy(self.step.u),
                    "potential": -float(self.body.weight @ self.step.u), "work": self.step.work}
        self.wet.send(self.faces.reference + u, v, a, force=self.step.external[self.faces.entries].sum(axis=0),
                      displacement_max=np.hypot(*u.T).max(), **energies)
        self.tables.write(window, self.step.u[2 * self.tip:2 * self.tip + 2], **energies)


def play(me: rivage.Participant, told: dict) -> None:
    gate, dt = Gate(me, told), 0.0
    for window in gate.wet.windows():
        if window.step == 0:
            gate.start()
        elif me.serial and window.step > 0:
            gate.advance(dt)                     # the load of the step that the fluid has made
        gate.send(window)
        dt = window.dt
        if window.step >= 0 and not (me.serial or window.last):
            gate.advance(dt)                     # while the fluid makes the same step
    done = gate.step
    print(f"gate: {done.steps} steps, {done.iterations / max(done.steps, 1):.2f} iterations and "
          f"{1000 * done.factorisations / max(done.steps, 1):.1f} factorisations in 1,000 each", flush=True)


def main() -> None:
    with rivage.Participant("solid", sys.argv[1], sys.argv[2:]) as me:
        if me.comm.size > 1:
            raise rivage.Error(2, f"GetFEM plays the gate on one rank, but '{me.role}' has {me.comm.size}")
        try:
            play(me, rivage.read_own_file(me.file, me.role, me.arguments))
        except NotConverged as error:
            raise rivage.Error(3, f"the gate's step did not converge: {error}") from None


if __name__ == "__main__":
    main()
