# SPDX-License-Identifier: MIT
"""Draws one instant of a coupled run: water coloured by pressure, the solids' meshes deformed, the rigid walls."""
from dataclasses import dataclass, field

import numpy as np
from matplotlib.collections import LineCollection, PolyCollection

from cells import polygons
from field_file import FieldStep
from figure_style import SOLID, WATER, plt


@dataclass
class View:
    """What a snapshot shows: window [m], pressure at the dark end of the colours [Pa], dx [m], walls' corners [m]."""
    window: tuple[float, float, float, float]
    pressure: float
    spacing: float
    walls: list[list[tuple[float, float]]] = field(default_factory=list)


def draw_water(axes, step: FieldStep, view: View):
    """The particles as squares of about their own size, coloured by pressure."""
    x, y = step.points[:, 0], step.points[:, 1]
    low_x, high_x, low_y, high_y = view.window
    margin = view.spacing
    inside = (x > low_x - margin) & (x < high_x + margin) & (y > low_y - margin) & (y < high_y + margin)
    box = axes.get_window_extent()
    points_per_metre = box.width / axes.figure.dpi * 72 / (high_x - low_x)
    size = max(view.spacing * points_per_metre * 1.15, 0.5)
    return axes.scatter(x[inside], y[inside], c=np.ravel(step.fields["pressure"])[inside], s=size**2, marker="o",
                        cmap=WATER, vmin=-0.1 * view.pressure, vmax=view.pressure, linewidths=0, rasterized=True)


def draw_solid(axes, step: FieldStep) -> None:
    """The deformed mesh, one in space seen along z: cells filled, their edges as hair lines. Without cells, a line through
    the nodes."""
    position, nodes = step.points[:, :2], polygons(step)
    if nodes is None:
        axes.plot(position[:, 0], position[:, 1], "-", color=SOLID, linewidth=2.5)
        return
    axes.add_collection(PolyCollection(position[nodes], facecolors="#f0b27a", edgecolors=SOLID, linewidths=0.25))


def draw_step(axes, water: FieldStep | None, solids: list[FieldStep], view: View):
    """One panel; returns the scatter that carries the colours, or None."""
    low_x, high_x, low_y, high_y = view.window
    axes.set(xlim=(low_x, high_x), ylim=(low_y, high_y), aspect="equal")
    axes.grid(False)
    axes.add_collection(LineCollection(view.walls, colors="#444444", linewidths=1.4))
    colours = draw_water(axes, water, view) if water is not None else None
    for solid in solids:
        draw_solid(axes, solid)
    return colours


def snapshot_figure(water_file, solid_files: list, times, view: View, columns: int = 4):
    """A figure with one panel for each of the times [s] the run has reached; None where it reached none."""
    panels = []
    for time in times:
        water = water_file.nearest(time) if water_file else None
        solids = [step for file in solid_files if file and (step := file.nearest(time)) is not None]
        if water is not None or solids:
            panels.append((water, solids))
    if not panels:
        return None
    rows = -(-len(panels) // columns)
    low_x, high_x, low_y, high_y = view.window
    width = 11.5
    height = rows * (width / columns * (high_y - low_y) / (high_x - low_x) + 0.25) + 0.4
    figure, grid = plt.subplots(rows, columns, figsize=(width, height), squeeze=False, layout="constrained")
    figure.get_layout_engine().set(w_pad=0.02, h_pad=0.02)
    figure.draw_without_rendering()
    colours = None
    for index, axes in enumerate(grid.flat):
        if index >= len(panels):
            axes.axis("off")
            continue
        water, solids = panels[index]
        colours = draw_step(axes, water, solids, view) or colours
        axes.set_title(f"t = {(water or solids[0]).time:.3g} s", fontsize=9)
        axes.tick_params(labelsize=7, labelleft=index % columns == 0, labelbottom=index + columns >= len(panels))
        if index % columns == 0:
            axes.set_ylabel("y [m]", fontsize=8)
        if index + columns >= len(panels):
            axes.set_xlabel("x [m]", fontsize=8)
    if colours is not None:
        bar = figure.colorbar(colours, ax=grid, extend="both", shrink=0.9, aspect=30, pad=0.01)
        bar.set_label(f"pressure [Pa] (orange: below {-0.1 * view.pressure:.0f})", fontsize=7)
        bar.ax.tick_params(labelsize=7)
        bar.outline.set_visible(False)
    return figure
