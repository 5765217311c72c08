# SPDX-License-Identifier: MIT
"""Figures of the dam breaks, in the experiments' dimensionless time.

Lobovsky et al. 2014: t* = t sqrt(g/H), H = 0.3 m, pressure over rho g H, levels over H.
Martin and Moyce 1952: T = n t sqrt(g/a), n^2 = 2, a = 57.15 mm, front Z = x/a.
"""
import math
from pathlib import Path

import numpy as np

from run_folder import Table

HERE = Path(__file__).resolve().parent
GRAVITY, DENSITY, HEIGHT, WIDTH = 9.81, 1000.0, 0.3, 0.05715
STAR = math.sqrt(GRAVITY / HEIGHT)                           # t* = STAR t
MM = math.sqrt(2 * GRAVITY / WIDTH)                          # T = MM t
ARRIVED = 0.1                                                # share of rho g H at which a sensor is held to be hit


def measured_pressure() -> tuple[np.ndarray, np.ndarray]:
    """(t*, p/(rho g H)) of the sensor P1 in the experiment."""
    table = Table(HERE / "reference" / "dambreak_lobovsky2014_pressure_H300.csv")
    return table.values[:, 0], table.values[:, 1]


def pressure(run) -> tuple[np.ndarray, np.ndarray]:
    probes = run.table("fluid/probes.csv")
    return STAR * probes["t"], probes["P1.wall_pressure"] / (DENSITY * GRAVITY * HEIGHT)


def mean_over(t: np.ndarray, y: np.ndarray, low: float, high: float) -> float:
    if t[-1] < high:
        raise ValueError(f"the run ends at t* = {t[-1]:.3g}")
    times = np.linspace(low, high, 2001)
    return float(np.trapz(np.interp(times, t, y), times) / (high - low))


def arrival(run, entry) -> float:
    """t* at which P1 first feels ARRIVED rho g H."""
    t, p = pressure(run)
    if not (p > ARRIVED).any():
        raise ValueError("the water has not arrived")
    return float(t[np.argmax(p > ARRIVED)])


def plateau(run, entry) -> float:
    """Mean of P1 over t* 3.5 to 5, over the experiment's."""
    return mean_over(*pressure(run), 3.5, 5.0) / mean_over(*measured_pressure(), 3.5, 5.0)


def impulse(run, entry) -> float:
    """Integral of P1 over t* 2.4 to 5, over the experiment's."""
    return mean_over(*pressure(run), 2.4, 5.0) / mean_over(*measured_pressure(), 2.4, 5.0)


def level_error(run, entry) -> float:
    """Largest distance of the level H1 from the experiment's at t* = 1, 2 ... 6, over H."""
    probes, measured = run.table("fluid/probes.csv"), Table(HERE / "reference" / "dambreak_lobovsky2014_levels_H300.csv")
    t = STAR * probes["t"]
    times = np.arange(1.0, math.floor(t[-1] + 1e-3) + 0.5)
    if len(times) < 6:
        raise ValueError(f"the run ends at t* = {t[-1]:.3g}")
    ours = np.interp(times, t, probes["H1.front"]) / HEIGHT
    return float(np.abs(ours - np.interp(times, measured.values[:, 0], measured.values[:, 1])).max())


def loss_before_impact(run, entry) -> float:
    """Energy lost until t* = 2.3, over the potential energy released until then."""
    table = run.table("fluid/energy.csv")
    t = STAR * table["t"]
    total = np.interp(2.3, t, table["total"]) - table["total"][0]
    return float(total / (np.interp(2.3, t, table["potential"]) - table["potential"][0]))


def measured_front() -> tuple[np.ndarray, np.ndarray]:
    """(T, Z) of Martin and Moyce's column of n^2 = 2, a = 2.25 in."""
    rows = [line.split(",") for line in
            (HERE / "reference" / "dambreak_martin_moyce.csv").read_text(encoding="utf-8").splitlines()
            if line.startswith("Z_n2=2_a=2.25in,")]
    return np.array([float(row[1]) for row in rows]), np.array([float(row[2]) for row in rows])


def front_misfit(run) -> tuple[float, float]:
    """(relative rms of the front, shift of T) for the shift within +-0.1 that fits best: the experiment's origin of time,
    when its diaphragm was gone, is not known better."""
    probes = run.table("fluid/probes.csv")
    times, front = measured_front()
    best = (math.inf, 0.0)
    for shift in np.linspace(-0.1, 0.1, 201):
        ours = np.interp(times + shift, MM * probes["t"], probes["water.front"] / WIDTH)
        best = min(best, (float(np.sqrt(np.mean((ours / front - 1) ** 2))), float(shift)))
    return best


def front_rms(run, entry) -> float:
    return front_misfit(run)[0]


def front_shift(run, entry) -> float:
    return front_misfit(run)[1]


def front_rms_unshifted(run, entry) -> float:
    probes = run.table("fluid/probes.csv")
    times, front = measured_front()
    ours = np.interp(times, MM * probes["t"], probes["water.front"] / WIDTH)
    return float(np.sqrt(np.mean((ours / front - 1) ** 2)))
