# SPDX-License-Identifier: MIT
"""Motion of the wet end over time."""
from figure_style import SOLID, draw, plt


def pictures(run) -> list[tuple]:
    """(figure, kind, caption) of each picture for the report."""
    end = run.table("solid/probes.csv")
    figure, axes = plt.subplots(figsize=(7, 3.5), layout="constrained")
    draw(axes, end["t"], 1e3 * end["end.uy"], color=SOLID)
    axes.set(xlabel="t [s]", ylabel="wet end [mm]")
    return [(figure, "svg", "Displacement of the block's wet end.")]
