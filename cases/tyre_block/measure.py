# SPDX-License-Identifier: MIT
"""The tyre's block: conservation of the water, momentum of block and water, energy, and how dry the ground is under the block."""
import tomllib
from pathlib import Path

import numpy as np

from convergence import spacing
from field_file import FieldFile
from run_folder import RunFolder

HEIGHT = tomllib.loads((Path(__file__).resolve().parent / "ground.toml").read_text(encoding="utf-8"))["height"]
GROUND = compile(HEIGHT.replace("^", "**"), "ground.toml", "eval")
FACES = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))     # of a brick
NAMES = {"__builtins__": {}, "cos": np.cos, "sin": np.sin, "pi": np.pi}


def ground(x: np.ndarray) -> np.ndarray:
    """Height of the ground of ground.toml below points [m]."""
    return eval(GROUND, NAMES, {"x": x[:, 0], "y": x[:, 1]})


def used(run: RunFolder) -> dict:
    return tomllib.loads((run.path / "used_config.toml").read_text(encoding="utf-8"))


def block_size(run: RunFolder) -> np.ndarray:
    """Length, width and height of the block [m]."""
    mesh = used(run)["solid"]["mesh"]
    return np.subtract(mesh["high"], mesh["low"])


def hull(cells: np.ndarray) -> np.ndarray:
    """Corners of the faces that belong to one brick only."""
    faces = np.concatenate([cells[:, face] for face in FACES])
    _, first, count = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    return faces[first[count == 1]]


def rubber_below_ground(run: RunFolder, entry: dict) -> float:
    """Deepest point of the block's faces below the ground at any output, up to the time `until` if given [dx]; 11 x 11 points a face."""
    fields, u = FieldFile(run.file("solid/fields.h5")), np.linspace(0, 1, 11)
    s, t = (grid.ravel() for grid in np.meshgrid(u, u))
    shape = np.stack(((1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t), axis=-1)
    steps = [fields.read(k) for k in range(len(fields.times))]
    faces = hull(next(step.connectivity for step in steps if step.connectivity is not None))
    heights = []
    for step in (step for step in steps if step.time <= entry.get("until", np.inf)):
        points = np.einsum("nc,fca->fna", shape, step.points[faces]).reshape(-1, 3)
        heights.append((points[:, 2] - ground(points)).min())
    return max(0.0, -min(heights)) / spacing(run)


def vector(table, name: str) -> np.ndarray:
    return np.array([table[f"{name}{axis}"] for axis in "xyz"])


def at(times: np.ndarray, table, values: np.ndarray) -> np.ndarray:
    """Rows of a table at other times."""
    return np.array([np.interp(times, table["t"], row) for row in values])


def impulse(table, force: np.ndarray) -> np.ndarray:
    """Of a force given in rows, from the start on."""
    steps = 0.5 * (force[:, 1:] + force[:, :-1]) * np.diff(table["t"])
    return np.concatenate((np.zeros((3, 1)), np.cumsum(steps, axis=1)), axis=1)


def water_momentum_error(run: RunFolder, entry: dict) -> float:
    """Momentum of all water, of what has left too, against the impulses of ground and block; over the largest impulse."""
    table = run.table("fluid/energy.csv")
    given = vector(table, "impulse_of_walls_") + vector(table, "impulse_of_interface_")
    kept = vector(table, "momentum_") + vector(table, "outflow_momentum_")
    return float(np.abs(kept - given).max() / np.abs(given).max())


def block_momentum(run: RunFolder) -> tuple[np.ndarray, np.ndarray]:
    """Times of the outputs and the block's momentum then [kg m/s]: its bricks' mass times their mean nodal velocity."""
    fields = FieldFile(run.file("solid/fields.h5"))
    solid = used(run)["solid"]
    mass = solid["material"]["rubber"]["density"] * np.prod(block_size(run)) / np.prod(solid["mesh"]["cells"])
    steps = [fields.read(k) for k in range(len(fields.times))]
    cells = steps[0].connectivity if steps[0].connectivity is not None else steps[-1].connectivity
    return fields.times, np.array([mass * step.fields["velocity"][cells].mean(axis=1).sum(axis=0) for step in steps]).T


def momentum_error(run: RunFolder, entry: dict) -> float:
    """Mean forces between two outputs along x and z: change of the momentum of block and water less the force of the driven face, the
    contact and the ground's push on the water; over the largest mean force of the driven face. (The planes of symmetry hold the
    block along y alone; their groups' sums count the driven face's edges again.)"""
    times, block = block_momentum(run)
    water, held, contact = (run.table(name) for name in ("fluid/energy.csv", "solid/reactions.csv", "solid/contact.csv"))
    face = impulse(held, vector(held, "front.f"))
    ground = impulse(contact, vector(contact, "back.normal_") + vector(contact, "back.friction_"))
    outside = at(times, held, face) + at(times, contact, ground) + at(times, water, vector(water, "impulse_of_walls_"))
    inside = block + at(times, water, vector(water, "momentum_") + vector(water, "outflow_momentum_"))
    span = np.diff(times)
    return float(np.abs(np.diff(inside - outside)[[0, 2]] / span).max() / np.abs(np.diff(at(times, held, face)) / span).max())


def energy_error(run: RunFolder, entry: dict) -> float:
    """Energy of block and water, with all dissipations and what has left, against the work of the driven face; over that
    work's peak, up to the time `until` if given."""
    water, block = run.table("fluid/energy.csv"), run.table("solid/energy.csv")
    kept = sum(water[name] for name in ("total", "outflow_energy", "dissipation_riemann", "dissipation_mass_flux", "dissipation_walls"))
    held = sum(block[name] for name in ("kinetic", "strain", "contact", "friction", "numerical_dissipation"))
    off = held + np.interp(block["t"], water["t"], kept) - block["work_supports"]
    inside = block["t"] <= entry.get("until", np.inf)
    return float(np.abs(off - off[0])[inside].max() / np.abs(block["work_supports"][inside]).max())


def drained(run: RunFolder, entry: dict) -> float:
    """Share of the water within dx of the ground that has gone from under the block at the time `at`; above ground higher than
    `higher` [m] only."""
    fields, dx, mesh = FieldFile(run.file("fluid/fields.h5")), spacing(run), used(run)["solid"]["mesh"]
    sole = run.table("solid/probes.csv")
    rear = np.interp(entry["at"], sole["t"], sole["sole.ux"])

    def near(step) -> float:
        if step is None:
            raise ValueError(f"no fields at {entry['at']:g} s")
        height = ground(step.points)
        x = step.points - (rear, 0, 0)
        under = np.all((x > mesh["low"])[:, :2] & (x < mesh["high"])[:, :2], axis=1)
        under &= (x[:, 2] - height < dx) & (height > entry.get("higher", -1.0))
        return float(step.fields["mass"][under].sum())

    return 1 - near(fields.nearest(entry["at"])) / near(fields.read(0))


def other_run(entry: dict) -> RunFolder:
    return RunFolder(entry["beside"] / entry["reference"]["run"])


def impulse_difference(run: RunFolder, entry: dict) -> float:
    """Impulse of the driven face against that of another run, at every row of the table; over that one's largest."""
    mine, theirs = run.table("solid/reactions.csv"), other_run(entry).table("solid/reactions.csv")
    own, other = (impulse(table, vector(table, "front.f")) for table in (mine, theirs))
    return float(np.abs(own - at(mine["t"], theirs, other)).max() / np.abs(other).max())


def drained_difference(run: RunFolder, entry: dict) -> float:
    return abs(drained(run, entry) - drained(other_run(entry), entry))
