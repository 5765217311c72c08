# SPDX-License-Identifier: MIT
"""Pictures of the dam break: water over time, pressure and level beside the experiment, energies."""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / "tools"), str(HERE)]

import numpy as np  # noqa: E402

from field_file import open_fields  # noqa: E402
from figure_style import FLUID, REFERENCE, SOLID, TOTAL, draw, plt  # noqa: E402
from run_folder import RunFolder, Table  # noqa: E402
from snapshots import View, snapshot_figure  # noqa: E402

STAR, HEAD, HEIGHT = 5.718391, 1000 * 9.81 * 0.3, 0.3       # sqrt(g/H) [1/s], rho g H [Pa], H [m]
TIMES = np.array([1, 2, 2.5, 3, 4, 5, 5.5, 6]) / STAR        # [s]
WALLS = [[(0, 0.6), (0, 0), (1.61, 0), (1.61, 0.6)]]


def water(run: RunFolder):
    file = open_fields(run.file("fluid/fields.h5"))
    return snapshot_figure(file, [], TIMES, View((-0.03, 1.64, -0.03, 0.6), HEAD, 0.0025, WALLS)) if file else None


def curves(run: RunFolder):
    """Pressure of P1 and level of H1 beside the measured ones, and where the energy is."""
    probes, energy = run.table("fluid/probes.csv"), run.table("fluid/energy.csv")
    if probes is None or energy is None or "P1.wall_pressure" not in probes:
        return None
    pressure = Table(HERE / "reference" / "dambreak_lobovsky2014_pressure_H300.csv").values
    levels = Table(HERE / "reference" / "dambreak_lobovsky2014_levels_H300.csv").values
    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(11.5, 3.4), layout="constrained")
    left.plot(pressure[:, 0], pressure[:, 1], color=REFERENCE, linewidth=1.0, label="measured, one run")
    draw(left, STAR * probes["t"], probes["P1.wall_pressure"] / HEAD, color=FLUID, linewidth=0.9, label="computed")
    left.set(title="Pressure, P1", xlabel="t sqrt(g/H)", ylabel="p/(rho g H)", xlim=(2.2, 6), ylim=(-0.3, 4))
    left.legend()
    middle.plot(levels[:, 0], levels[:, 1], color=REFERENCE, linewidth=1.0, label="measured")
    draw(middle, STAR * probes["t"], probes["H1.front"] / HEIGHT, color=FLUID, label="computed")
    middle.set(title="Level, H1", xlabel="t sqrt(g/H)", ylabel="h/H", xlim=(0, 6))
    middle.legend()
    for name, colour in (("kinetic", FLUID), ("potential", SOLID), ("internal", REFERENCE), ("total", TOTAL)):
        draw(right, STAR * energy["t"], energy[name] - (energy[name][0] if name != "kinetic" else 0), color=colour, label=name)
    right.set(title="Energy, change since the start", xlabel="t sqrt(g/H)", ylabel="[J/m]")
    right.legend()
    return figure


def pictures(run: RunFolder) -> list[tuple]:
    """(figure, kind, caption) of each picture for the report."""
    return [(water(run), "png", "Water coloured by pressure."),
            (curves(run), "svg", "Beside the experiment of Lobovský et al. (2014).")]
