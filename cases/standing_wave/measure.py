# SPDX-License-Identifier: MIT
"""Period and decay of a standing wave from its kinetic energy, fitted over the whole run.

    E_k(t) = exp(-2 d t) (a + b cos 2wt + c sin 2wt)

The period of the wave is 2 pi/w, twice that of the kinetic energy; d is the decay rate of the amplitude. In a fluid of the
kinematic viscosity nu a wave of the wave number k between slip walls decays at d = 2 nu k^2 (Lamb, Hydrodynamics, art. 348),
which turns the numerical decay into an equivalent viscosity.
"""
import math

import numpy as np

WAVE_NUMBER = math.pi                                   # [1/m] of the first mode, L = 1 m
OMEGA = math.sqrt(9.81 * WAVE_NUMBER * math.tanh(0.5 * WAVE_NUMBER))


def misfit(t, energy, omega: float, decay: float) -> float:
    basis = np.exp(-2 * decay * t)[:, None] * np.column_stack((np.ones_like(t), np.cos(2 * omega * t), np.sin(2 * omega * t)))
    factors = np.linalg.lstsq(basis, energy, rcond=None)[0]
    return float(np.sum((energy - basis @ factors) ** 2))


def fit(run) -> tuple[float, float]:
    """(w, d) of the best fit: a grid about the present best, made finer until it does not matter."""
    table = run.table("fluid/energy.csv")
    t, energy = table["t"], table["kinetic"]
    omega, decay, wide_omega, wide_decay = OMEGA, 0.2, 0.1 * OMEGA, 0.2
    for _ in range(12):
        trials = [(omega + a * wide_omega, decay + b * wide_decay) for a in np.linspace(-1, 1, 9) for b in np.linspace(-1, 1, 9)]
        omega, decay = min(trials, key=lambda trial: misfit(t, energy, *trial))
        wide_omega, wide_decay = 0.4 * wide_omega, 0.4 * wide_decay
    return omega, decay


def period(run, entry) -> float:
    return 2 * math.pi / fit(run)[0]


def decay_rate(run, entry) -> float:
    return fit(run)[1]


def equivalent_viscosity(run, entry) -> float:
    return fit(run)[1] / (2 * WAVE_NUMBER**2)
