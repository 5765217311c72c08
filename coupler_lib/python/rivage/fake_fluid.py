# SPDX-License-Identifier: MIT
"""A pressure that is known beforehand, for whoever couples a solid: python3 -m rivage.fake_fluid coupling.toml PRESSURE ...

    constant      p, the same everywhere and always            a spring's plate: u = p L/k (1 - cos(t sqrt(k/m)))
    hydrostatic   rho g max(level - y, 0)                      force on a vertical wall wetted to the depth h: rho g h^2/2
    recorded      a table t[s],p[Pa] (CSV), linear between its rows, held at its ends

2D, one rank, per metre of depth. With --out: coupling/interface.csv and energy_total.csv. The load of a window is that at the middle of the fluid's last step, on the
surface as it was at that step's start.
"""
import argparse
import math
from pathlib import Path

import numpy as np

from rivage.fake_program import add_common, command, run
from rivage.participant import Error, Participant
from rivage.sides import Fluid, Window


def parse() -> argparse.Namespace:
    parser = command("fluid", __doc__)
    laws = parser.add_subparsers(dest="law", required=True)
    constant, hydrostatic, recorded = (laws.add_parser(name) for name in ("constant", "hydrostatic", "recorded"))
    constant.add_argument("--pressure", type=float, required=True, help="Pa")
    hydrostatic.add_argument("--level", type=float, required=True, help="height y of the surface [m]")
    hydrostatic.add_argument("--density", type=float, default=1000.0, help="kg/m^3 (1000)")
    hydrostatic.add_argument("--gravity", type=float, default=9.81, help="m/s^2 (9.81)")
    recorded.add_argument("--table", required=True, help="CSV file with one line of headings, t[s],p[Pa]; its place is relative to coupling.toml")
    for law in (constant, hydrostatic, recorded):
        law.add_argument("--dt", type=float, required=True, help="the fluid's step [s]")
        law.add_argument("--impedance", type=float, default=1e5, help="rho c that it reports [kg/(m^2 s)] (1e5)")
        law.add_argument("--partner", help="role of the solid, where there are several")
    add_common(laws.choices.values(), "fluid")
    return parser.parse_args()


def read_table(path: str) -> np.ndarray:
    """Rows of t, p with t ascending. Raises Error(2)."""
    try:
        rows = np.loadtxt(path, delimiter=",", skiprows=1, ndmin=2)
    except (OSError, ValueError) as error:
        raise Error(2, f"{path}: {error}") from None
    if rows.shape[1:] != (2,) or len(rows) == 0 or not np.isfinite(rows).all() or (np.diff(rows[:, 0]) <= 0).any():
        raise Error(2, f"{path}: wanted are two columns of numbers, t[s] ascending and p[Pa], below a line of headings")
    return rows


def pressure_law(told: argparse.Namespace):
    """p(y, t) [Pa] for an array of heights."""
    if told.law == "constant":
        return lambda y, t: np.full_like(y, told.pressure)
    if told.law == "hydrostatic":
        return lambda y, t: told.density * told.gravity * np.maximum(told.level - y, 0)
    rows = read_table(str(Path(told.file).parent / told.table))
    return lambda y, t: np.full_like(y, np.interp(t, rows[:, 0], rows[:, 1]))


class Load:
    """Corner forces of a pressure that is linear along each facet: the exact integral against the ends' linear functions,

        F_a = L (2 p_a + p_b)/6 n,  F_b = L (p_a + 2 p_b)/6 n,  L n = (-dy, dx) of a -> b
    """

    def __init__(self, wet: Fluid, pressure):
        self.wet, self.pressure = wet, pressure
        self.measure(0.0)

    def measure(self, time: float) -> None:
        a, b = self.wet.facet_nodes[:, 0], self.wet.facet_nodes[:, 1]
        x = np.array(self.wet.position)
        along = x[b] - x[a]
        into = np.column_stack([-along[:, 1], along[:, 0]])
        p = self.pressure(x[:, 1], time)
        self.corners = np.zeros((len(a), 4, 2))
        self.corners[:, 0] = into * ((2 * p[a] + p[b]) / 6)[:, None]
        self.corners[:, 1] = into * ((p[a] + 2 * p[b]) / 6)[:, None]
        length = np.hypot(*along.T)
        self.averaged = {"weight": length, "weighted_pressure": length * (p[a] + p[b]) / 2, "full_weight": length}

    def fields(self) -> dict:
        return {"corner_force": self.corners, **self.averaged}

    @property
    def force(self) -> np.ndarray:
        return self.corners.sum(axis=(0, 1))

    def work_along(self, way: np.ndarray) -> float:
        """Of this load while its nodes go a way [nodes, 2]."""
        nodes = self.wet.facet_nodes
        return float((self.corners[:, 0] * way[nodes[:, 0]]).sum() + (self.corners[:, 1] * way[nodes[:, 1]]).sum())


def play(told: argparse.Namespace, me: Participant) -> None:
    if told.dt <= 0 or not math.isfinite(told.dt):
        raise Error(2, f"--dt {told.dt}: a step above zero is wanted")
    pressure = pressure_law(told)
    wet = me.fluid(2, told.impedance, told.partner, output_dir=told.out)
    wet.send(Window(-1, 0, 0))
    wet.receive()
    load, dt, work, step = Load(wet, pressure), told.dt * me.solid_every, 0.0, 0
    while True:
        stop, time = wet.stop_agreed, step * dt
        window = Window(step, time, dt, stop or time > me.end_time - 1e-9 * dt, stop)
        before, last_step = np.array(wet.position), dt if step > 0 else 0.0
        ahead = work + load.work_along(last_step * wet.velocity + 0.5 * last_step**2 * wet.acceleration)
        wet.send(window, **load.fields(), force=load.force, work_on_solid=ahead, path_work=ahead, external_work=ahead)
        wet.receive()
        work += load.work_along(wet.position - before)
        if window.last:
            break
        step += 1
        load.measure(time + 0.5 * dt)
    print(f"rivage.fake_fluid: force {load.force[0]:.9e} {load.force[1]:.9e} N/m, work {work:.9e} J/m at t = {time:g} s", flush=True)


if __name__ == "__main__":
    run(parse(), play)
