# SPDX-License-Identifier: MIT
"""Pictures of the gate in space: water and gate seen from the side, and the free end in the middle and at a side wall."""
from field_file import open_fields
from figure_style import FLUID, SOLID, draw, plt
from snapshots import View, snapshot_figure

WALLS = [[(0, 0.15), (0, 0), (0.4, 0)], [(0.1, 0.15), (0.1, 0.079), (0.105, 0.079), (0.105, 0.15)]]


def tips(run):
    probes = run.table("solid/probes.csv")
    if probes is None:
        return None
    figure, axes = plt.subplots(figsize=(11.5, 3.2), layout="constrained")
    for component, colour in (("ux", FLUID), ("uy", SOLID)):
        for place, style in (("tip", "solid"), ("side", (0, (4, 3)))):
            draw(axes, probes["t"], 1000 * probes[f"{place}.{component}"], color=colour, linestyle=style,
                 label=f"{component[1]}, {'middle' if place == 'tip' else 'side wall'}")
    axes.set(title="Free end of the gate", xlabel="t [s]", ylabel="displacement [mm]", xlim=(0, None))
    axes.legend(ncols=2)
    return figure


def pictures(run) -> list[tuple]:
    """(figure, kind, caption) of each picture for the report."""
    view = View((-0.006, 0.235, -0.006, 0.148), pressure=1000 * 9.81 * 0.14, spacing=0.002, walls=WALLS)
    water, gate = open_fields(run.file("fluid/fields.h5")), open_fields(run.file("solid/fields.h5"))
    return [(snapshot_figure(water, [gate], (0.04, 0.08, 0.12), view, 3), "png", "Water of all the width, coloured by pressure, seen from the side."),
            (tips(run), "svg", "Middle of the gate's lower face, half-way across and at a side wall.")]
