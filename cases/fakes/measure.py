# SPDX-License-Identifier: MIT
"""The fakes' exact answers; each function gives the largest distance of the run's middle.u from its own, over its peak."""
import numpy as np

MASS, STIFFNESS, PRESSURE, RAMP = 100.0, 1e6, 1000.0, 20000.0     # of the plate [kg/m, N/m^2]; Pa, Pa/s
OMEGA = np.sqrt(STIFFNESS / MASS)
BEAM_MASS, BENDING = 50.0, 1e3                                    # [kg/m^2], EI [N m]


def distance(run, exact) -> float:
    table = run.table("solid/probes.csv")
    wanted = exact(table["t"])
    return float(np.abs(table["middle.u"] - wanted).max() / np.abs(wanted).max())


def spring(run, entry) -> float:
    """u = p L/k (1 - cos w t)"""
    return distance(run, lambda t: PRESSURE / STIFFNESS * (1 - np.cos(OMEGA * t)))


def ramp(run, entry) -> float:
    """u = r L/k (s - sin(w s)/w), s = t less the fluid's step: a parallel exchange applies each load one step late"""
    s = lambda t: np.maximum(t - 1e-4, 0)
    return distance(run, lambda t: RAMP / STIFFNESS * (s(t) - np.sin(OMEGA * s(t)) / OMEGA))


def beam(run, entry) -> float:
    """w = sum over odd n of 4 p/(n pi m w_n^2) sin(n pi/2) (1 - cos w_n t), w_n = (n pi/L)^2 sqrt(EI/m)"""
    n = np.arange(1, 10, 2)[:, None] * np.pi
    w = n**2 * np.sqrt(BENDING / BEAM_MASS)
    return distance(run, lambda t: (4 * PRESSURE / (n * BEAM_MASS * w**2) * np.sin(n / 2) * (1 - np.cos(w * t))).sum(axis=0))
