# SPDX-License-Identifier: MIT
"""Pictures of the tyre's block: an animation, the film from above, what presses on the sole, and forces and slip over time.

usage: plot.py RUN FOLDER      writes them into the folder
"""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "tools")]

import numpy as np  # noqa: E402
from matplotlib.colors import PowerNorm  # noqa: E402

from field_file import open_fields  # noqa: E402
from figure_style import FLUID, SOLID, WATER, draw, plt  # noqa: E402
from film_picture import DEEPEST, Film, animation  # noqa: E402
from measure import block_size, hull, used  # noqa: E402
from run_folder import RunFolder  # noqa: E402

CAPTIONS = ("The film from above; the lines are the rear and the front of its sole.",
            "What presses on the sole: rubber on the ground, and the water between them (mean over each square's height); and the way that the sole "
            "has slipped in contact. From above; contact and slip where the rubber was at first, the water where it is.",
            "Forces on the block from below, friction over load along the slide, and the speed of the sole's rear edge.",
            "Block, ground and film; the ground is bare where less than a quarter of dx is left.")


def film(run: RunFolder):
    """From above: the film's thickness at five times, the block's edges as lines."""
    fields, sole = open_fields(run.file("fluid/fields.h5")), run.table("solid/probes.csv")
    if fields is None or sole is None or len(fields.times) < 2:
        return None
    times, squares, length = np.linspace(0, fields.times[-1], 5), Film(run), 1e3 * block_size(run)[0]
    figure, rows = plt.subplots(len(times), 1, figsize=(9, 7.5), sharex=True, layout="constrained")
    for axes, time in zip(rows, times):
        image = axes.imshow(1e3 * squares.thickness(fields.nearest(time)).T, origin="lower", aspect="equal", cmap="Blues", vmin=0,
                            vmax=1e3 * DEEPEST, extent=[1e3 * end for end in squares.span])
        rear = 1e3 * np.interp(time, sole["t"], sole["sole.ux"])
        for edge in (rear, rear + length):
            axes.axvline(edge, color=SOLID, linewidth=1.2)
        axes.set(ylabel="y [mm]", title=f"{1e3 * time:.2f} ms")
        axes.grid(False)
    rows[-1].set(xlabel="x [mm]")
    figure.colorbar(image, ax=list(rows), label="water [mm]")
    return figure


def instants(run: RunFolder, times: np.ndarray) -> list[int]:
    """Outputs: of the water's largest load, before the slide, in its middle and the last."""
    load, sole = run.table("coupling/interface.csv"), run.table("solid/probes.csv")
    still = sole["t"][np.abs(sole["sole.ux"]) <= 0.1 * np.abs(sole["sole.ux"]).max()]
    wanted = (load["t"][load["force_received_z"].argmax()], still[-1], 0.5 * (still[-1] + times[-1]), times[-1])
    return sorted({int(np.argmin(np.abs(times - time))) for time in wanted})


def sole_of(fields, low: float) -> np.ndarray:
    """Corners (n x 4) of the facets of the sole, which lay at the height `low` [m] at first."""
    first = fields.read(0)
    faces = hull(first.connectivity if first.connectivity is not None else fields.read(len(fields.times) - 1).connectivity)
    return faces[np.all(np.abs(first.points[faces][:, :, 2] - low) < 1e-9, axis=1)]


def under_the_sole(run: RunFolder):
    """Pressure of contact, pressure of water and way slipped over the sole, a row an instant."""
    fields, water = open_fields(run.file("solid/fields.h5")), open_fields(run.file("fluid/fields.h5"))
    if fields is None or water is None or run.table("coupling/interface.csv") is None or run.table("solid/probes.csv") is None:
        return None
    chosen = [index for index in instants(run, fields.times) if index < len(water.times)]
    facets, squares = sole_of(fields, used(run)["solid"]["mesh"]["low"][2]), Film(run)
    steps = [(fields.read(index), water.read(index)) for index in chosen]
    first = 1e3 * fields.read(0).points
    top = 1e-6 * max(step.fields["contact_pressure"].max() for step, _ in steps)
    wettest = 1e-6 * max(np.nanpercentile(squares.pressure(wet), 98) for _, wet in steps)
    farthest = 1e3 * max(step.fields["contact_slip"].max() for step, _ in steps)
    figure, rows = plt.subplots(len(chosen), 3, figsize=(11, 1.55 * len(chosen) + 0.6), layout="constrained", squeeze=False)
    for row, (step, wet) in zip(rows, steps):
        x, y = first[:, 0], first[:, 1]                          # where the rubber was: an edge may be tucked under
        split = np.concatenate((facets[:, :3], facets[:, [0, 2, 3]]))
        pressed = row[0].tripcolor(x, y, split, 1e-6 * step.fields["contact_pressure"], cmap="OrRd", norm=PowerNorm(0.5, 0, top or 1.0), shading="gouraud")
        image = row[1].imshow(1e-6 * squares.pressure(wet).T, origin="lower", cmap=WATER, vmin=0, vmax=wettest, extent=[1e3 * end for end in squares.span])
        slipped = row[2].tripcolor(x, y, split, 1e3 * step.fields["contact_slip"], cmap="Greys", vmin=0, vmax=farthest, shading="gouraud")
        for axes, corners in zip(row, (first[facets], 1e3 * step.points[facets], first[facets])):
            axes.set(xlim=(corners[..., 0].min(), corners[..., 0].max()), ylim=(y[facets].min(), y[facets].max()), aspect="equal")
            axes.grid(False)
        row[0].set(title=f"{1e3 * step.time:.2f} ms", ylabel="y [mm]")
    for column, (mark, label) in enumerate(((pressed, "contact [MPa]"), (image, "water [MPa]"), (slipped, "slipped [mm]"))):
        figure.colorbar(mark, ax=list(rows[:, column]), location="bottom", label=label, aspect=30, extend="max" if column == 1 else "neither")
    return figure


def forces(run: RunFolder):
    """What the ground and the water do to the block, friction over load, and the speed of the sole."""
    contact, load, sole = run.table("solid/contact.csv"), run.table("coupling/interface.csv"), run.table("solid/probes.csv")
    if contact is None or load is None or sole is None:
        return None
    figure, (top, middle, low) = plt.subplots(3, 1, figsize=(9, 7), sharex=True, layout="constrained")
    t, normal, friction = 1e3 * contact["t"], contact["back.normal_z"], -contact["back.friction_x"]
    draw(top, t, normal, color=SOLID, label="contact, up")
    draw(top, t, friction, color="0.4", label="friction, back")
    draw(top, 1e3 * load["t"], load["force_received_z"], color=FLUID, label="water, up", linewidth=0.8)
    top.set(ylabel="[N]")
    top.legend(fontsize=7.5)
    pressed = normal > 0.05 * normal.max()
    middle.plot(t[pressed], friction[pressed] / normal[pressed], color="0.4")
    middle.axhline(used(run)["solid"]["contact"][0]["friction"], color="0.7", linewidth=0.8, linestyle="--")
    middle.set(ylabel="friction over load, x [-]")
    draw(low, 1e3 * sole["t"], sole["sole.vx"], color=SOLID, label="sole, rear edge")
    low.set(xlabel="t [ms]", ylabel="velocity along x [m/s]")
    low.legend(fontsize=7.5)
    return figure


def pictures(run: RunFolder) -> list[tuple]:
    """(figure, kind, caption) of each picture for the report."""
    return list(zip((film(run), under_the_sole(run), forces(run), animation(run)), ("png", "png", "svg", "gif"), CAPTIONS))


def main() -> int:
    run, folder = RunFolder(Path(sys.argv[1])), Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    for name, (figure, kind, _) in zip(("film", "under_the_sole", "forces", "animation"), pictures(run)):
        if kind == "gif" and figure is not None:
            (folder / f"{name}.gif").write_bytes(figure)
        elif figure is not None:
            figure.savefig(folder / f"{name}.png", dpi=110)
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
