# SPDX-License-Identifier: MIT
"""Pictures of the stretching patch, as the figures 1 and 2 of the SPH-FEM paper: the disc over time; energies, mass, and the
total energy at each resolution that lies beside the run (./rivage verify puts them there).

usage: plot.py RUN FOLDER          writes patch.png and energies.png into FOLDER; the report calls pictures(run).
"""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "tools"))

import numpy as np  # noqa: E402

from field_file import open_fields  # noqa: E402
from figure_style import FLUID, REFERENCE, SHADES, SOLID, WATER, draw, plt  # noqa: E402
from run_folder import RunFolder, Table  # noqa: E402

TIMES = (0.0, 0.5, 1.0, 1.5, 2.0)                                                  # [s]
EXACT = Table(HERE / "reference" / "patch_exact.csv")


def snapshots(run: RunFolder):
    """Particles coloured by pressure, and the exact ellipse."""
    file = open_fields(run.file("fluid/fields.h5"))
    if file is None:
        return None
    figure, panels = plt.subplots(1, len(TIMES), figsize=(11.5, 5.6), layout="constrained", sharey=True)
    angle = np.linspace(0, 2 * np.pi, 200)
    for axes, time in zip(panels, TIMES):
        step = file.nearest(time)
        axes.set(xlim=(-1.15, 1.15), ylim=(-3.9, 3.9), aspect="equal", title=f"t = {time:g} s")
        axes.grid(False)
        if step is None:
            continue
        pressure = np.ravel(step.fields["pressure"])
        axes.scatter(step.points[:, 0], step.points[:, 1], c=pressure, s=1.2, cmap=WATER, linewidths=0, rasterized=True,
                     vmin=0, vmax=max(float(np.percentile(pressure, 99)), 1.0))
        a, b = (np.interp(time, EXACT["t"], EXACT[name]) for name in ("a_x", "b_y"))
        axes.plot(a * np.cos(angle), b * np.sin(angle), color=REFERENCE, linewidth=0.8)
    return figure


def resolutions(run: RunFolder) -> list[tuple[str, Table]]:
    """(name, energy.csv) of the runs beside this one, or of this one alone."""
    beside = [(folder.name.replace("_", " = "), folder / "fluid/energy.csv") for folder in sorted(run.path.parent.glob("dx_*"))]
    found = [(name, Table(path)) for name, path in beside if path.is_file()]
    return found[::-1] or [("this run", run.table("fluid/energy.csv"))]


def energies(run: RunFolder):
    """Kinetic and internal energy; total mass; total energy at each resolution."""
    table = run.table("fluid/energy.csv")
    if table is None:
        return None
    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(11.5, 3.3), layout="constrained")
    start = table["kinetic"][0]
    draw(left, table["t"], table["kinetic"] - start, color=FLUID, label="kinetic, change")
    draw(left, table["t"], table["internal"], color=SOLID, label="internal")
    left.set(title="Energies", xlabel="t [s]", ylabel="[J/m]")
    left.legend()
    draw(middle, table["t"], table["mass"] / table["mass"][0] - 1, color=FLUID)
    middle.set(title="Total mass, relative change", xlabel="t [s]", ylabel="[-]", ylim=(-1e-12, 1e-12))
    for (name, one), colour in zip(resolutions(run), SHADES):
        total = one["kinetic"] + one["internal"]
        draw(right, one["t"], total / total[0], color=colour, label=name)
    right.set(title="Total energy over its start", xlabel="t [s]", ylabel="[-]")
    right.legend()
    return figure


def pictures(run: RunFolder) -> list[tuple]:
    """(figure, kind, caption) of each picture for the report."""
    return [(snapshots(run), "png", "Particles coloured by pressure; line: exact incompressible ellipse."),
            (energies(run), "svg", "Energies, mass, and the total energy at each resolution.")]


def main() -> int:
    run, folder = RunFolder(Path(sys.argv[1])), Path(sys.argv[2])
    for name, figure in (("patch", snapshots(run)), ("energies", energies(run))):
        if figure is not None:
            figure.savefig(folder / f"{name}.png", dpi=110)
    return 0


if __name__ == "__main__":
    sys.exit(main())
