# SPDX-License-Identifier: MIT
"""The film's thickness under a rigid block against its one-dimensional model, incompressible and without friction:

    h'' (m + rho B^2/(3 h)) = (2 rho B^2/3) h'^2/h^2 - P      h(0) = h0, h'(0) = 0

mass balance u = -x h'/h and the momentum of the column at x, with no pressure at the edge x = B; integrated over the width.

Once there is a jet the pressure does not end at the edge: from a wall above and below to a free surface above, Laplace's equation
gives a pressure as if the channel were longer by (2 ln 2/pi) h. With that length e, B^2/3 becomes (B + e)^2/2 - B^2/6.
"""
import numpy as np
from scipy.integrate import solve_ivp

from convergence import spacing
from run_folder import RunFolder

DENSITY, MASS, HALF_WIDTH, LOAD, START = 1000.0, 5.0, 0.02, 0.25e6, 0.002     # kg/m^3, kg/m^2, m, Pa, m
END = 2 * np.log(2) / np.pi        # [h] what a jet adds to the channel's length
RESOLVED = 4                       # particles across the film, as long as the comparison goes


def model(times: np.ndarray, end: float = 0.0) -> np.ndarray:
    """Thickness of the film [m]; the channel is longer by `end` [h]."""
    def rate(_, state):
        h, v = state
        inertia = DENSITY * ((HALF_WIDTH + end * h)**2 / 2 - HALF_WIDTH**2 / 6)
        return v, (2 * inertia * (v / h)**2 - LOAD) / (MASS + inertia / h)

    return solve_ivp(rate, (0, times[-1]), (START, 0), t_eval=times, rtol=1e-10, atol=1e-14).y[0]


def thickness(run: RunFolder) -> tuple[np.ndarray, np.ndarray, float]:
    """Times, thicknesses [m] and the particles' spacing."""
    probes = run.table("solid/probes.csv")
    return probes["t"], START - probes["piston.u"], spacing(run)


def largest_error(run: RunFolder, entry: dict) -> float:
    """Of the thickness, over the model's, while the film is resolved; with `jet` that of a film with a jet from the start."""
    t, h, dx = thickness(run)
    wanted = model(t, END if entry.get("jet") else 0.0)
    inside = h >= RESOLVED * dx
    return float(np.abs(h[inside] / wanted[inside] - 1).max())


def error_at(run: RunFolder, entry: dict) -> float:
    """Of the thickness over the model's, when it has come down to `thickness`."""
    t, h, _ = thickness(run)
    return float(np.interp(-entry["thickness"], -h, h / model(t, END if entry.get("jet") else 0.0) - 1))


def thickness_at(run: RunFolder, entry: dict) -> float:
    """At the time `at` [m]."""
    t, h, _ = thickness(run)
    return float(np.interp(entry["at"], t, h))


def dissipated(run: RunFolder, entry: dict) -> float:
    """Share of the block's work on the water that the fluid scheme had dissipated, when the film was `thickness`."""
    t, h, _ = thickness(run)
    energy = run.table("fluid/energy.csv")
    lost = sum(energy[f"dissipation_{part}"] for part in ("riemann", "mass_flux", "walls"))
    when = np.interp(-entry["thickness"], -h, t)
    return float(np.interp(when, energy["t"], lost) / np.interp(when, energy["t"], energy["work_by_interface"]))
