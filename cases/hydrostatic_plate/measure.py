# SPDX-License-Identifier: MIT
"""Extremes of the plate's motion."""
import numpy as np


def extreme(run, entry) -> float:
    """The least displacement within [from, until] [m], by the parabola through it and its neighbours."""
    probes = run.table("solid/probes.csv")
    t, u = probes["t"], probes["middle.uy"]
    inside = np.flatnonzero((t >= entry["from"]) & (t <= entry["until"]))
    k = inside[np.argmin(u[inside])]
    rise, bend = u[k + 1] - u[k - 1], u[k + 1] - 2 * u[k] + u[k - 1]
    return u[k] - rise**2 / (8 * bend)
