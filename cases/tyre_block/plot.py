# SPDX-License-Identifier: MIT
"""Pictures of the tyre's block: thickness of the film from above, before, under and behind the block; forces over time."""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "tools")]

import numpy as np  # noqa: E402

from convergence import spacing  # noqa: E402
from field_file import open_fields  # noqa: E402
from figure_style import FLUID, SOLID, draw, plt  # noqa: E402
from measure import LENGTH, WIDTH  # noqa: E402
from run_folder import RunFolder  # noqa: E402

SPAN = (-0.008, 0.028)                                           # of x in the pictures [m]


def thickness(step, cell: float) -> np.ndarray:
    """Volume of water over each square of the ground, per area [m]."""
    shape = (round((SPAN[1] - SPAN[0]) / cell), round(WIDTH / cell))
    volume, *_ = np.histogram2d(step.points[:, 0], step.points[:, 1], shape, (SPAN, (0, WIDTH)), weights=step.fields["volume"])
    return volume / ((SPAN[1] - SPAN[0]) / shape[0] * WIDTH / shape[1])


def film(run: RunFolder):
    """From above: the film's thickness at five times, the block's edges as lines."""
    fields, sole = open_fields(run.file("fluid/fields.h5")), run.table("solid/probes.csv")
    if fields is None or sole is None or len(fields.times) < 2:
        return None
    times = np.linspace(0, fields.times[-1], 5)
    figure, rows = plt.subplots(len(times), 1, figsize=(9, 7.5), sharex=True, layout="constrained")
    for axes, time in zip(rows, times):
        image = axes.imshow(1e3 * thickness(fields.nearest(time), 2 * spacing(run)).T, origin="lower", aspect="equal", cmap="Blues", vmin=0,
                            vmax=2.5, extent=(1e3 * SPAN[0], 1e3 * SPAN[1], 0, 1e3 * WIDTH))
        rear = np.interp(time, sole["t"], sole["sole.ux"])
        for edge in (rear, rear + LENGTH):
            axes.axvline(1e3 * edge, color=SOLID, linewidth=1.2)
        axes.set(ylabel="y [mm]", title=f"{1e3 * time:.2f} ms")
        axes.grid(False)
    rows[-1].set(xlabel="x [mm]")
    figure.colorbar(image, ax=list(rows), label="water [mm]")
    return figure


def forces(run: RunFolder):
    """What the ground and the water do to the block."""
    contact, load = run.table("solid/contact.csv"), run.table("coupling/interface.csv")
    if contact is None or load is None:
        return None
    figure, axes = plt.subplots(figsize=(9, 3.4), layout="constrained")
    draw(axes, 1e3 * contact["t"], contact["back.normal_z"], color=SOLID, label="contact, up")
    draw(axes, 1e3 * contact["t"], -contact["back.friction_x"], color="0.4", label="friction, back")
    draw(axes, 1e3 * load["t"], load["force_received_z"], color=FLUID, label="water, up", linewidth=0.8)
    axes.set(xlabel="t [ms]", ylabel="[N]")
    axes.legend(fontsize=7.5)
    return figure


def pictures(run: RunFolder) -> list[tuple]:
    """(figure, kind, caption) of each picture for the report."""
    return [(film(run), "png", "The film from above; the lines are the rear and the front of its sole."),
            (forces(run), "svg", "Forces on the block from below.")]


def main() -> int:
    run, folder = RunFolder(Path(sys.argv[1])), Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    for name, figure in (("film", film(run)), ("forces", forces(run))):
        if figure is not None:
            figure.savefig(folder / f"{name}.png", dpi=110)
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
