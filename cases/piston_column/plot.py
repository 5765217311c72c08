# SPDX-License-Identifier: MIT
"""Pictures of the piston: its motion beside the exact one, and what is left between the two."""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "tools"))

import numpy as np  # noqa: E402

from figure_style import FLUID, REFERENCE, TOTAL, draw, plt  # noqa: E402
from run_folder import Table  # noqa: E402


def pictures(run) -> list[tuple]:
    """(figure, kind, caption) of each picture for the report."""
    probes = run.table("solid/probes.csv")
    if probes is None:
        return []
    exact = Table(HERE / "reference" / "piston_column_c50.csv")
    t, x = probes["t"], 1000 * probes["piston.u"]
    figure, (left, right) = plt.subplots(1, 2, figsize=(11.5, 3.2), layout="constrained", width_ratios=(2, 1))
    inside = exact["t"] <= t[-1]
    left.plot(exact["t"][inside], exact["x"][inside], color=REFERENCE, linewidth=2.2, alpha=0.45,
              label="exact (d'Alembert)")
    draw(left, t, x, color=FLUID, label="computed")
    left.set(title="Displacement of the piston", xlabel="t [s]", ylabel="x [mm]")
    left.legend()
    draw(right, t, x - np.interp(t, exact["t"], exact["x"]), color=TOTAL)
    right.set(title="Computed minus exact", xlabel="t [s]", ylabel="[mm]")
    return [(figure, "svg", "Spring-mass piston under a 1 m column of water: a coupled problem with an exact answer.")]
