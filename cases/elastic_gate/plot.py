# SPDX-License-Identifier: MIT
"""Pictures of the elastic gate: water and gate at the experiment's times; the free end beside the experiment and the
energies of both sides, as figures 3 and 4 of the SPH-FEM paper (README.md); the water levels.

usage: plot.py RUN FOLDER          writes them as PNG into FOLDER; the report calls pictures(run).
"""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "tools"))

import numpy as np  # noqa: E402

from energy import energy_sum  # noqa: E402
from field_file import open_fields  # noqa: E402
from figure_style import FLUID, REFERENCE, SOLID, TOTAL, draw, plt  # noqa: E402
from run_folder import RunFolder, Table  # noqa: E402
from snapshots import View, snapshot_figure  # noqa: E402

WATER_WIDTH, WATER_HEIGHT, GATE_TOP, GATE_THICKNESS = 0.1, 0.14, 0.079, 0.005      # [m]
TIMES = np.arange(0.04, 0.401, 0.04)                                               # of the experiment's pictures [s]
DRY_SIDE = WATER_WIDTH + GATE_THICKNESS
WALLS = [[(0, 0.15), (0, 0), (1.2, 0)],
         [(WATER_WIDTH, 0.15), (WATER_WIDTH, GATE_TOP), (DRY_SIDE, GATE_TOP), (DRY_SIDE, 0.15)]]
CAPTIONS = ("Water coloured by pressure and the gate's mesh in its deformed place.",
            "Left: middle of the gate's lower face, beside the experiment of Antoci et al. (2007); bars: uncertainty. "
            "Right: energies of water and gate, their change since the start.",
            "Highest water in the last 5 mm before the gate's place, and 5 cm before it.")


def snapshots(run: RunFolder, times=TIMES, columns: int = 5):
    """Water coloured by pressure and the deformed gate; None where the run holds no fields."""
    water, solid = open_fields(run.file("fluid/fields.h5")), open_fields(run.file("solid/fields.h5"))
    particles = len(water.read(0).points) if water and water.steps else 14000
    spacing = np.sqrt(WATER_WIDTH * WATER_HEIGHT / particles)
    view = View((-0.006, 0.235, -0.006, 0.148), pressure=1000 * 9.81 * WATER_HEIGHT, spacing=spacing, walls=WALLS)
    return snapshot_figure(water, [solid], times, view, columns)


def draw_tip(axes, probes: Table) -> None:
    """Displacement of the middle of the gate's lower face, with the measured one and its uncertainty."""
    measured = Table(HERE / "reference" / "antoci_gate_experiment.csv")
    for column, name, colour, marker in (("tip.ux", "x", FLUID, "o"), ("tip.uy", "y", SOLID, "s")):
        draw(axes, probes["t"], 1000 * probes[column], color=colour, label=f"computed, {name}")
        axes.errorbar(measured["t"], measured[f"{name}_tip"], yerr=measured[f"u_{name}"], label=f"measured, {name}",
                      fmt=marker, markersize=4, mfc="white" if name == "y" else REFERENCE, color=REFERENCE,
                      capsize=2, linewidth=0.9)
    axes.set(title="Free end of the gate", xlabel="t [s]", ylabel="displacement [mm]", xlim=(0, None))
    axes.legend(ncols=2, fontsize=7.5)


def tip_and_energies(run: RunFolder):
    probes, energies = run.table("solid/probes.csv"), energy_sum(run)
    if probes is None or energies is None:
        return None
    figure, (left, right) = plt.subplots(1, 2, figsize=(11.5, 3.6), layout="constrained")
    draw_tip(left, probes)
    for values, colour, label in ((energies.fluid, FLUID, "water"), (energies.solid, SOLID, "gate"), (energies.total, TOTAL, "both")):
        draw(right, energies.t, values - values[0], color=colour, label=label)
    right.set(title="Total energies, change since the start", xlabel="t [s]", ylabel="energy [J/m]", xlim=(0, None))
    right.legend()
    return figure


def levels(run: RunFolder):
    probes = run.table("fluid/probes.csv")
    if probes is None or "level_at_gate.front" not in probes:
        return None
    figure, axes = plt.subplots(figsize=(5.8, 3.0), layout="constrained")
    for name, colour, label in (("level_at_gate", SOLID, "at the gate"), ("level_5_cm_before_gate", FLUID, "5 cm before it")):
        draw(axes, probes["t"], 1000 * probes[f"{name}.front"], color=colour, label=label)
    axes.set(title="Water level", xlabel="t [s]", ylabel="[mm]", xlim=(0, None), ylim=(0, None))
    axes.legend()
    return figure


def pictures(run: RunFolder) -> list[tuple]:
    """(figure, kind, caption) of each picture for the report."""
    return list(zip((snapshots(run), tip_and_energies(run), levels(run)), ("png", "svg", "svg"), CAPTIONS))


def main() -> int:
    run, folder = RunFolder(Path(sys.argv[1])), Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    for name, (figure, _, _) in zip(("snapshots", "tip", "levels"), pictures(run)):
        if figure is not None:
            figure.savefig(folder / f"{name}.png", dpi=130)
            print(folder / f"{name}.png")
    return 0


if __name__ == "__main__":
    sys.exit(main())
