# SPDX-License-Identifier: MIT
"""The period between the first two maxima of the tip, and how well the energy identity closes."""
import numpy as np


def peak_time(t, u) -> float:
    """Instant of the largest value, by the parabola through it and its neighbours [s]."""
    k = int(np.argmax(u))
    rise, bend = u[k + 1] - u[k - 1], u[k + 1] - 2 * u[k] + u[k - 1]
    return t[k] - 0.5 * (t[k + 1] - t[k]) * rise / bend


def period(run, entry) -> float:
    probes = run.table("solid/probes.csv")
    t, u = probes["t"], probes["tip.ux"]
    first = t < 0.066
    return peak_time(t[~first], u[~first]) - peak_time(t[first], u[first])


def identity(run, entry) -> float:
    energy = run.table("solid/energy.csv")
    return np.abs(energy["balance_error"]).max() / np.abs(energy["work_loads"]).max()
