# SPDX-License-Identifier: MIT
"""The film's thickness over time beside its one-dimensional model."""
import importlib.util
from pathlib import Path

from figure_style import SOLID, draw, plt

SPEC = importlib.util.spec_from_file_location("measure_squeeze_film", Path(__file__).with_name("measure.py"))
film = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(film)


def pictures(run) -> list[tuple]:
    """(figure, kind, caption) of each picture for the report."""
    t, h, dx = film.thickness(run)
    figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
    axes.plot(1e3 * t, 1e3 * film.model(t), color="0.4", linestyle="--", label="model")
    draw(axes, 1e3 * t, 1e3 * h, color=SOLID, label="computed")
    axes.axhline(1e3 * film.RESOLVED * dx, color="0.7", linewidth=0.8, label=f"{film.RESOLVED} particles")
    axes.set(xlabel="t [ms]", ylabel="film [mm]")
    axes.legend(fontsize=8)
    return [(figure, "svg", "Thickness of the film under the block, and its one-dimensional model without friction.")]
