# SPDX-License-Identifier: MIT
"""Pictures of the two gates: water and gates at some instants, and both tips."""
from field_file import open_fields
from figure_style import FLUID, SOLID, draw, plt
from snapshots import View, snapshot_figure

WALLS = [[(-0.26, 0), (0.26, 0)]] + [[(side * 0.1, 0.15), (side * 0.1, 0.079), (side * 0.105, 0.079), (side * 0.105, 0.15)] for side in (-1, 1)]


def tips(run):
    figure, axes = plt.subplots(figsize=(11.5, 3.2), layout="constrained")
    for role, colour in (("left", FLUID), ("right", SOLID)):
        probes = run.table(f"{role}/probes.csv")
        if probes is None:
            return None
        for column, name, style in (("tip.ux", "x", "solid"), ("tip.uy", "y", (0, (4, 3)))):
            draw(axes, probes["t"], 1000 * probes[column], color=colour, linestyle=style, label=f"{role}, {name}")
    axes.set(title="Free ends of the gates", xlabel="t [s]", ylabel="displacement [mm]", xlim=(0, None))
    axes.legend(ncols=2)
    return figure


def pictures(run) -> list[tuple]:
    """(figure, kind, caption) of each picture for the report."""
    files = [open_fields(run.file(f"{role}/fields.h5")) for role in ("left", "right")]
    view = View((-0.21, 0.21, -0.006, 0.148), pressure=1000 * 9.81 * 0.14, spacing=0.0025, walls=WALLS)
    snapshots = snapshot_figure(open_fields(run.file("fluid/fields.h5")), files, [0.02, 0.06, 0.1], view, 3)
    return [(snapshots, "png", "Water coloured by pressure and both gates' meshes in their deformed places."),
            (tips(run), "svg", "Middle of each gate's lower face.")]
