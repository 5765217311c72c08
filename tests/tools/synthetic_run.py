# SPDX-License-Identifier: MIT
"""Writes a small run folder of the elastic gate with invented, smooth data: what the report's tests draw.

usage: synthetic_run.py FOLDER
"""
import json
import sys
from pathlib import Path

import h5py
import numpy as np

END, STEPS, FRAMES = 0.4, 2000, 11


def write_csv(path: Path, columns: dict[str, np.ndarray]) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    rows = np.column_stack(list(columns.values()))
    np.savetxt(path, rows, delimiter=",", header=",".join(columns), comments="", fmt="%.12g")


def gate_shape(t: float) -> float:
    """The tip's displacement in x [m]."""
    return 0.040 * np.sin(np.pi * min(t, 0.12) / 0.24) - 0.03 * max(t - 0.12, 0.0)


def write_fields(folder: Path) -> None:
    """Particles of a sinking column and a bending gate of 2 x 10 cells of eight nodes."""
    spacing = 0.0025
    gx, gy = np.meshgrid(np.arange(0.5, 40) * spacing, np.arange(0.5, 56) * spacing)
    nodes, cells = q8_block(2, 10, 0.1, 0.0, 0.005, 0.079)
    (folder / "fluid").mkdir(parents=True, exist_ok=True)
    (folder / "solid").mkdir(parents=True, exist_ok=True)
    with h5py.File(folder / "fluid/fields.h5", "w") as fluid, h5py.File(folder / "solid/fields.h5", "w") as solid:
        for frame, t in enumerate(np.linspace(0, END, FRAMES)):
            sink = 1 - t
            water = fluid.create_group(f"step_{frame:06d}")
            water.attrs["time"] = t
            escaped = gx.ravel() * (1 + 2 * t * (gy.ravel() < 0.02) * (gx.ravel() > 0.05))
            water["points"] = np.column_stack((escaped, gy.ravel() * sink, 0 * gx.ravel()))
            water["pressure"] = 9810 * (0.14 - gy.ravel()) * sink
            mesh = solid.create_group(f"step_{frame:06d}")
            mesh.attrs["time"] = t
            arm = (0.079 - nodes[:, 1]) / 0.079
            mesh["points"], mesh["connectivity"] = np.column_stack((nodes, 0 * arm)), cells
            mesh["displacement"] = np.column_stack((gate_shape(t) * arm**2, 0.3 * gate_shape(t) * arm**2, 0 * arm))


def q8_block(nx: int, ny: int, x0: float, y0: float, width: float, height: float):
    """Nodes and eight-node cells (four corners, then four mid-sides) of a structured block."""
    number, nodes, cells = {}, [], []

    def node(i: int, j: int) -> int:
        if (i, j) not in number:
            number[i, j] = len(nodes)
            nodes.append((x0 + width * i / (2 * nx), y0 + height * j / (2 * ny)))
        return number[i, j]

    for j in range(0, 2 * ny, 2):
        for i in range(0, 2 * nx, 2):
            walk = ((0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1))
            cells.append([node(i + a, j + b) for a, b in walk])
    return np.array(nodes), np.array(cells)


def write_tables(folder: Path) -> None:
    t = np.linspace(0, END, STEPS)
    dt = np.full(STEPS, END / STEPS)
    ux = np.array([gate_shape(time) for time in t])
    kinetic, strain = 4 * np.sin(3 * t) ** 2, 400 * ux**2
    lost = 0.8 * t
    zero = np.zeros(STEPS)
    write_csv(folder / "fluid/energy.csv", {
        "t[s]": t, "dt[s]": dt, "kinetic[J/m]": kinetic, "potential[J/m]": 9.61 - kinetic - strain - lost,
        "internal[J/m]": 0.01 + zero, "total[J/m]": 9.62 - strain - lost, "mass[kg/m]": 14.0 - 0.1 * t,
        "work_by_walls[J/m]": zero, "work_by_interface[J/m]": -strain, "outflow_mass[kg/m]": 0.1 * t,
        "outflow_energy[J/m]": zero, "dissipation_riemann[J/m]": 0.6 * t, "dissipation_mass_flux[J/m]": 0.1 * t,
        "dissipation_walls[J/m]": 0.08 * t, "viscous[J/m]": zero, "balance_error[J/m]": -0.02 * t})
    write_csv(folder / "solid/energy.csv", {
        "t[s]": t, "dt[s]": dt, "kinetic[J/m]": 10 * ux**2, "strain[J/m]": 0.9 * strain, "potential[J/m]": 3 * ux**2,
        "work_interface[J/m]": strain, "work_supports[J/m]": zero, "work_loads[J/m]": zero,
        "numerical_dissipation[J/m]": 0.002 * t, "balance_error[J/m]": zero})
    write_csv(folder / "fluid/probes.csv", {"t[s]": t, "level_at_gate.front[m]": 0.14 - 0.1 * t,
                                            "level_5_cm_before_gate.front[m]": 0.14 - 0.12 * t})
    write_csv(folder / "solid/probes.csv", {"t[s]": t, "tip.ux[m]": ux, "tip.uy[m]": 0.3 * ux})
    noise = 4 * np.sin(2 * np.pi * 900 * t)
    write_csv(folder / "coupling/interface.csv", {
        "t[s]": t, "dt[s]": dt, "force_sent_x[N/m]": 70 - 60 * t + noise, "force_sent_y[N/m]": 30 * ux / 0.04,
        "force_received_x[N/m]": 70 - 60 * t + noise, "force_received_y[N/m]": 30 * ux / 0.04,
        "work_on_fluid[J/m]": -strain * 1.0005, "work_on_solid[J/m]": strain, "jump_work[J/m]": zero,
        "mismatch[-]": 0.0005 + zero,
        "wait_fluid[s]": t, "wait_solid[s]": 4 * t})


def write_summary(folder: Path) -> None:
    tree = {"fluxes": {"seconds": 60.0, "calls": 4000}, "gradients": {"seconds": 41.0, "calls": 4000},
            "exchange": {"seconds": 2.0, "calls": 2000, "inside": {"wait": {"seconds": 1.2, "calls": 2000}}}}
    fluid = {"ranks": 1, "particles": 2240, "steps": STEPS, "wall_s": 112.0, "particle_updates_per_s": 1.1e6,
             "version": "0.1.0 (synthetic)", "state_hash": "0f3c9a51", "timers": tree}
    solid = {"ranks": 1, "nodes": 85, "steps": STEPS, "wall_s": 112.0, "version": "0.1.0 (synthetic)",
             "state_hash": "77b1", "timers": {"newton": {"seconds": 21.0, "calls": STEPS}}}
    (folder / "summary.json").write_text(json.dumps({"fluid": fluid, "solid": solid}), encoding="utf-8")


def write_run(folder: Path) -> None:
    write_fields(folder)
    write_tables(folder)
    write_summary(folder)


if __name__ == "__main__":
    write_run(Path(sys.argv[1]))
