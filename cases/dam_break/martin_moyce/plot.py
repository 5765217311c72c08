# SPDX-License-Identifier: MIT
"""Picture of the front on a dry floor beside the experiment of Martin and Moyce."""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent.parent / "tools"))

from expectations import case_function  # noqa: E402
from figure_style import FLUID, REFERENCE, draw, plt  # noqa: E402
from run_folder import RunFolder  # noqa: E402

WIDTH, STAR = 0.05715, 18.5286                               # a [m], sqrt(2 g/a) [1/s]


def front(run: RunFolder):
    probes = run.table("fluid/probes.csv")
    if probes is None:
        return None
    times, measured = case_function(HERE, "measured_front")()
    figure, axes = plt.subplots(figsize=(6.5, 3.6), layout="constrained")
    draw(axes, STAR * probes["t"], probes["water.front"] / WIDTH, color=FLUID, label="computed")
    axes.plot(times, measured, "o", color=REFERENCE, markersize=4, label="Martin and Moyce 1952")
    axes.set(title="Front on the dry floor", xlabel="n t sqrt(g/a)", ylabel="x/a")
    axes.legend()
    return figure


def pictures(run: RunFolder) -> list[tuple]:
    """(figure, kind, caption) of each picture for the report."""
    return [(front(run), "svg", "Front of the water beside the experiment.")]
