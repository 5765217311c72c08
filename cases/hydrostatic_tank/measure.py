# SPDX-License-Identifier: MIT
"""Pressure of water at rest against the exact one of Tait's fluid.

    rho = rho0 (1 + (gamma - 1) g d/c0^2)^(1/(gamma - 1)),   p = (rho0 c0^2/gamma) ((rho/rho0)^gamma - 1),   gamma = 7

d is the depth below the free surface of the side that a particle is on. The free surface's first layer, d < dx, is left out.
"""
import tomllib

import numpy as np

from field_file import open_fields

GRAVITY, GAMMA = 9.81, 7.0


def exact_pressure(depth, c0: float, rho0: float):
    rho = rho0 * (1 + (GAMMA - 1) * GRAVITY * np.maximum(depth, 0) / c0**2) ** (1 / (GAMMA - 1))
    return rho0 * c0**2 / GAMMA * ((rho / rho0) ** GAMMA - 1)


def errors(run, entry) -> list[np.ndarray]:
    """Errors of the particles' pressure over that at the bottom of their side, at each output but the first.

    entry["sides"]: a list of {until, level}: the side's right end and its free surface [m], from the left.
    """
    used = tomllib.loads((run.path / "used_config.toml").read_text(encoding="utf-8"))["fluid"]
    fluid = (used["fluid"]["sound_speed"], used["fluid"]["density"])
    file, found = open_fields(run.file("fluid/fields.h5")), []
    for index in range(1, len(file.steps)):
        step = file.read(index)
        x, y, pressure = step.points[:, 0], step.points[:, 1], np.ravel(step.fields["pressure"])
        level = np.full(len(x), np.nan)
        for side in reversed(entry.get("sides", [{"until": np.inf, "level": 0.14}])):
            level[x < side["until"]] = side["level"]
        inside = y < level - used["resolution"]["spacing"]
        found.append(((pressure - exact_pressure(level - y, *fluid)) / exact_pressure(level, *fluid))[inside])
    return found


def pressure_rms(run, entry) -> float:
    """The worst output's."""
    return max(float(np.sqrt(np.mean(error**2))) for error in errors(run, entry))


def pressure_largest(run, entry) -> float:
    return max(float(np.abs(error).max()) for error in errors(run, entry))
