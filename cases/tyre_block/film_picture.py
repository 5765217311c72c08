# SPDX-License-Identifier: MIT
"""The tyre's block in space: ground, film coloured by its thickness, dry track, and the block that can be seen through; as frames."""
import io

import numpy as np
from convergence import spacing
from field_file import open_fields
from figure_style import SOLID, WATER, plt
from measure import ground, hull, used
from mpl_toolkits.mplot3d.art3d import Poly3DCollection
from PIL import Image                                           # matplotlib's own way to write pictures
from run_folder import RunFolder

DRY, DEEPEST = "#b8a98c", 0.0025                                 # colour of the ground; film at the scale's end [m]


class Film:
    """Squares of the ground and the volume of water over each, per area [m]."""

    def __init__(self, run: RunFolder):
        water = used(run)["fluid"]["water"][0]
        low, high = np.array(water["low"][:2]), np.array(water["high"][:2])
        self.dx = spacing(run)
        low, high = low - (0.003, 0), high + (0.005, 0)          # room for what is pushed out along x
        shape = np.round((high - low) / (2 * self.dx)).astype(int)
        self.x, self.y = (np.linspace(low[axis], high[axis], shape[axis] + 1) for axis in (0, 1))
        corners = np.stack(np.meshgrid(self.x, self.y, indexing="ij"), axis=-1)
        self.height = ground(corners.reshape(-1, 2)).reshape(corners.shape[:2])
        self.span = (low[0], high[0], low[1], high[1])

    def sum(self, step, values) -> np.ndarray:
        """Over each square; a particle is spread over a square of its own, dx wide: nine points."""
        shifts = self.dx / 3 * np.array([-1, 0, 1])
        x = step.points[:, 0, None] + np.repeat(shifts, 3)
        y = np.clip(step.points[:, 1, None] + np.tile(shifts, 3), self.y[0], self.y[-1])
        return np.histogram2d(x.ravel(), y.ravel(), (self.x, self.y), weights=np.repeat(values / 9, 9))[0]

    def thickness(self, step) -> np.ndarray:
        return self.sum(step, step.fields["volume"]) / ((self.x[1] - self.x[0]) * (self.y[1] - self.y[0]))

    def pressure(self, step) -> np.ndarray:
        """Mean over each square's water [Pa]; NaN where there is none."""
        volume = self.sum(step, step.fields["volume"])
        weighted = self.sum(step, step.fields["volume"] * step.fields["pressure"])
        return np.divide(weighted, volume, out=np.full_like(volume, np.nan), where=volume > 0)

    def squares(self, step) -> tuple[np.ndarray, list]:
        """Corners of the film's upper side over each square, and its colour: that of the ground where less than a quarter dx is left."""
        thick = self.thickness(step)
        edge = np.pad(thick, 1, mode="edge")
        level = self.height + 0.25 * (edge[1:, 1:] + edge[:-1, 1:] + edge[1:, :-1] + edge[:-1, :-1])
        x, y = np.meshgrid(self.x, self.y, indexing="ij")
        grid = np.stack((x, y, level), axis=-1)
        quads = np.stack((grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]), axis=2).reshape(-1, 4, 3)
        colours = [plt.matplotlib.colors.to_rgba(DRY) if h < 0.25 * self.dx else WATER(h / DEEPEST) for h in thick.ravel()]
        return quads, colours


class Scene:
    """One frame from the fields of both sides at an output."""

    def __init__(self, run: RunFolder):
        self.water, self.solid = open_fields(run.file("fluid/fields.h5")), open_fields(run.file("solid/fields.h5"))
        self.film = Film(run)
        cells = next(step.connectivity for step in (self.solid.read(0), self.solid.read(len(self.solid.times) - 1))
                     if step.connectivity is not None)
        self.faces = hull(cells)
        self.frames = min(len(self.water.times), len(self.solid.times))

    def draw(self, axes, index: int) -> None:
        """Everything in one collection, for matplotlib hides faces by their distance within one alone."""
        step, block = self.water.read(index), self.solid.read(index)
        quads, colours = self.film.squares(step)
        sides = block.points[self.faces]
        axes.clear()
        axes.add_collection3d(Poly3DCollection(1e3 * np.concatenate((quads, sides)), linewidths=0.25,
                              facecolors=colours + [plt.matplotlib.colors.to_rgba(SOLID, 0.3)] * len(sides),
                              edgecolors=[(0, 0, 0, 0.04)] * len(quads) + [plt.matplotlib.colors.to_rgba(SOLID, 0.6)] * len(sides)))
        low_x, high_x, low_y, high_y = (1e3 * end for end in self.film.span)
        axes.set(xlim=(low_x, high_x), ylim=(low_y, high_y), zlim=(-0.6, 12))
        axes.figure.suptitle(f"{1e3 * step.time:.2f} ms", x=0.06, y=0.95, ha="left", fontsize=13)
        axes.set_box_aspect((high_x - low_x, high_y - low_y, 12.6), zoom=0.9)
        axes.view_init(elev=30, azim=-75)
        axes.set_axis_off()


def animation(run: RunFolder, width: float = 7.5) -> bytes | None:
    """A GIF of all outputs; None where fields are missing."""
    if run.file("fluid/fields.h5") is None or run.file("solid/fields.h5") is None:
        return None
    scene = Scene(run)
    figure = plt.figure(figsize=(width, 0.6 * width))
    axes = figure.add_axes((-0.15, -0.56, 1.3, 1.3 / 0.6), projection="3d")      # drawn in a square, so one larger than the picture
    scale = plt.matplotlib.cm.ScalarMappable(plt.Normalize(0, 1e3 * DEEPEST), WATER)
    figure.colorbar(scale, cax=figure.add_axes((0.68, 0.86, 0.28, 0.03)), orientation="horizontal", label="water [mm]")
    images = []
    for index in range(scene.frames):
        scene.draw(axes, index)
        figure.canvas.draw()
        images.append(Image.fromarray(np.asarray(figure.canvas.buffer_rgba())).convert("RGB").quantize(64))
    plt.close(figure)
    buffer = io.BytesIO()
    images[0].save(buffer, "gif", save_all=True, append_images=images[1:], duration=[250] * (len(images) - 1) + [2000], loop=0)
    return buffer.getvalue()
