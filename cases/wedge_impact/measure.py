# SPDX-License-Identifier: MIT
"""Figures of the wedge: deflection of the panel's middle normal to it, beside its fall, and the water's pressure at A and C.

Pressure at a wet node: the load's normal part over the 5 mm of wet face that belong to it.
"""
from pathlib import Path

import numpy as np

from run_folder import RunFolder, Table

SPEED, FACET, RISE = 30.0, 0.005, np.radians(10)                 # [m/s], [m]
INWARD = np.array([-np.sin(RISE), np.cos(RISE)])
REFERENCE = Path(__file__).resolve().parent / "reference"
LAST = 0.0022                                                    # of the deflection and of C's impulse [s]


def deflection(run: RunFolder) -> tuple[np.ndarray, np.ndarray]:
    """Times and deflections [m]."""
    probes = run.table("solid/probes.csv")
    return probes["t"], INWARD[0] * probes["middle.ux"] + INWARD[1] * (probes["middle.uy"] + SPEED * probes["t"])


def pressure(run: RunFolder, point: str) -> tuple[np.ndarray, np.ndarray]:
    probes = run.table("solid/probes.csv")
    return probes["t"], (INWARD[0] * probes[f"{point}.fx"] + INWARD[1] * probes[f"{point}.fy"]) / FACET


def deflection_rms(run: RunFolder, entry: dict) -> float:
    """To the hydroelastic Wagner model, until 2.2 ms [m]."""
    wanted = Table(REFERENCE / "hydroelastic_wagner.csv")
    inside = wanted["t"] <= LAST
    return float(np.sqrt(np.mean((np.interp(wanted["t"][inside], *deflection(run)) - wanted["w_x0.30_mid"][inside])**2)))


def deflection_at(run: RunFolder, entry: dict) -> float:
    return float(np.interp(entry["at"], *deflection(run)))


def pressure_a_rms(run: RunFolder, entry: dict) -> float:
    """To the digitised analytical curve over 0.2 to 2 ms, over 8.02 MPa."""
    t, p = pressure(run, "A")
    wanted = Table(REFERENCE / "pressure_A.csv")
    inside = (t >= 2e-4) & (t <= 2e-3)
    return float(np.sqrt(np.mean((p[inside] - np.interp(t[inside], wanted["t"], wanted["p"]))**2)) / 8.02e6)


def pressure_c_peak(run: RunFolder, entry: dict) -> float:
    return float(pressure(run, "C")[1].max())


def pressure_c_impulse(run: RunFolder, entry: dict) -> float:
    """Until 2.2 ms [Pa s]."""
    t, p = pressure(run, "C")
    inside = t <= LAST
    return float(np.sum(0.5 * (p[inside][1:] + p[inside][:-1]) * np.diff(t[inside])))


def arrival(run: RunFolder, entry: dict) -> float:
    """When the pressure at C first passes 5 MPa [s]."""
    t, p = pressure(run, "C")
    return float(t[np.argmax(p > 5e6)])


def force(run: RunFolder, entry: dict) -> float:
    """Mean of the vertical force of both panels over rho V^3 t, from 1.2 to 1.5 ms."""
    table = run.table("coupling/interface.csv")
    inside = (table["t"] >= 1.2e-3) & (table["t"] <= 1.5e-3)
    return float(np.mean(2 * table["force_received_y"][inside] / (1000 * SPEED**3 * table["t"][inside])))


def peak_time(run: RunFolder, entry: dict) -> float:
    """Of the largest pressure at C [s]."""
    t, p = pressure(run, "C")
    return float(t[np.argmax(p)])
