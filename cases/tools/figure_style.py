# SPDX-License-Identifier: MIT
"""One look for every picture of a report: colours with a meaning, quiet axes, figures as data URIs."""
import base64
import io

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.colors import LinearSegmentedColormap  # noqa: E402

FLUID, SOLID, TOTAL, REFERENCE = "#1f6fb2", "#c8641b", "#222222", "#8a1c3c"
SHADES = ("#1f6fb2", "#7fb2dd", "#3d8f7a", "#9a7fb8", "#c8641b", "#8a8a8a")
WATER = LinearSegmentedColormap.from_list("water", ["#a9d3ee", "#5aa5d8", "#1f6fb2", "#0b2e5c"])
WATER.set_under("#e8b07a")         # clearly negative pressure
WATER.set_over("#061a36")

plt.rcParams.update({
    "figure.dpi": 100,
    "font.family": "DejaVu Sans", "font.size": 9, "axes.titlesize": 10, "axes.titleweight": "bold",
    "axes.titlelocation": "left", "axes.spines.top": False, "axes.spines.right": False, "axes.linewidth": 0.7,
    "axes.edgecolor": "#555555", "axes.grid": True, "grid.color": "#e6e6e6", "grid.linewidth": 0.7,
    "xtick.color": "#555555", "ytick.color": "#555555", "xtick.labelcolor": "#222222", "ytick.labelcolor": "#222222",
    "legend.frameon": False, "legend.fontsize": 8.5, "lines.linewidth": 1.5, "lines.solid_capstyle": "round",
})


def as_image(figure, kind: str = "svg", alt: str = "") -> str:
    """The figure as a self-contained <img>; closes it. SVG for lines, PNG where many particles are drawn; an animation comes as the
    bytes of a GIF."""
    if kind == "gif":
        return f'<img alt="{alt}" src="data:image/gif;base64,{base64.b64encode(figure).decode("ascii")}">'
    buffer = io.BytesIO()
    figure.savefig(buffer, format=kind, dpi=150)
    plt.close(figure)
    mime = "image/svg+xml" if kind == "svg" else "image/png"
    data = base64.b64encode(buffer.getvalue()).decode("ascii")
    return f'<img alt="{alt}" src="data:{mime};base64,{data}">'


def thin(t: np.ndarray, y: np.ndarray, bins: int = 700) -> tuple[np.ndarray, np.ndarray]:
    """At most two points a bin, its least and its largest: a noisy curve keeps its envelope, a picture stays small."""
    if len(t) <= 2 * bins:
        return t, y
    edges = np.linspace(0, len(t), bins + 1).astype(int)
    keep = {0, len(t) - 1}
    for low, high in zip(edges[:-1], edges[1:]):
        keep.add(low + int(np.argmin(y[low:high])))
        keep.add(low + int(np.argmax(y[low:high])))
    index = np.array(sorted(keep))
    return t[index], y[index]


def draw(axes, t, y, **style) -> None:
    axes.plot(*thin(np.asarray(t), np.asarray(y)), **style)
