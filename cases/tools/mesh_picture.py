# SPDX-License-Identifier: MIT
"""The picture of a solid whose case draws none of its own: its mesh where it ended, coloured by how far it moved."""
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import PolyCollection
from matplotlib.colors import Normalize
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

from cells import is_plane, polygons
from field_file import open_fields
from figure_style import WATER, plt
from run_folder import RunFolder


def draw_plane(figure, corners: np.ndarray, colours) -> None:
    axes = figure.add_subplot()
    axes.add_collection(PolyCollection(corners[:, :, :2], facecolors=colours, edgecolors="#333333", linewidths=0.3))
    axes.autoscale_view()
    axes.set(aspect="equal", xlabel="x [m]", ylabel="y [m]")


def draw_space(figure, corners: np.ndarray, colours) -> None:
    axes = figure.add_subplot(projection="3d")
    axes.add_collection3d(Poly3DCollection(corners, facecolors=colours, edgecolors="#333333", linewidths=0.3))
    low, high = corners.reshape(-1, 3).min(axis=0), corners.reshape(-1, 3).max(axis=0)
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]), xlabel="x [m]", ylabel="y [m]", zlabel="z [m]")
    axes.set_box_aspect(np.maximum(high - low, 0.05 * (high - low).max()))
    axes.locator_params(nbins=4)


def mesh_figure(run: RunFolder):
    """The solid's last fields; None where there are none or their cells are not known here."""
    fields = open_fields(run.file("solid/fields.h5"))
    if fields is None or not fields.steps:
        return None
    step = fields.read(len(fields.steps) - 1)
    nodes = polygons(step)
    if nodes is None or "displacement" not in step.fields:
        return None
    moved = 1000 * np.linalg.norm(step.fields["displacement"].reshape(len(step.points), -1), axis=1)
    scale = ScalarMappable(Normalize(0, moved.max() or 1.0), WATER)
    figure = plt.figure(figsize=(6.5, 3.6), layout="constrained")
    draw = draw_plane if is_plane(step) else draw_space
    draw(figure, step.points[nodes], scale.to_rgba(moved[nodes].mean(axis=1)))
    figure.colorbar(scale, ax=figure.axes, shrink=0.8, pad=0.02).set_label("displacement [mm]", fontsize=8)
    return figure
