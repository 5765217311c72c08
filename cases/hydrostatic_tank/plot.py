# SPDX-License-Identifier: MIT
"""Pictures of water at rest: pressure of the particles at the end, and the spurious kinetic energy."""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "tools"))

import numpy as np  # noqa: E402

from field_file import open_fields  # noqa: E402
from figure_style import FLUID, WATER, draw, plt  # noqa: E402
from run_folder import RunFolder  # noqa: E402

SCALE = 9.6138                                               # [J/m] rho g H^2 W/2


def rest(run: RunFolder):
    file, table = open_fields(run.file("fluid/fields.h5")), run.table("fluid/energy.csv")
    if file is None or table is None:
        return None
    step = file.read(-1)
    figure, (left, right) = plt.subplots(1, 2, figsize=(11.5, 3.8), layout="constrained")
    points = left.scatter(step.points[:, 0], step.points[:, 1], c=np.ravel(step.fields["pressure"]), s=3, cmap=WATER,
                          linewidths=0, rasterized=True)
    figure.colorbar(points, ax=left, label="pressure [Pa]")
    left.set(title=f"t = {step.time:.3f} s", xlabel="x [m]", ylabel="y [m]", aspect="equal")
    left.grid(False)
    draw(right, table["t"], np.maximum(table["kinetic"], 1e-16) / SCALE, color=FLUID)
    right.set(title="Kinetic energy over rho g H² W/2", xlabel="t [s]", ylabel="[-]", yscale="log")
    return figure


def pictures(run: RunFolder) -> list[tuple]:
    """(figure, kind, caption) of each picture for the report."""
    return [(rest(run), "png", "Water at rest: everything that moves is spurious.")]
