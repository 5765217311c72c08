# SPDX-License-Identifier: MIT
"""Picture of the vortex: kinetic energy beside the exact decay, and what took it."""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / "tools"), str(HERE)]

import numpy as np  # noqa: E402

from expectations import case_function  # noqa: E402
from figure_style import FLUID, REFERENCE, draw, plt  # noqa: E402
from run_folder import RunFolder  # noqa: E402

RATE = case_function(HERE, "RATE")


def energies(run: RunFolder):
    energy = run.table("fluid/energy.csv")
    if energy is None:
        return None
    figure, (left, right) = plt.subplots(1, 2, figsize=(11.5, 3.3), layout="constrained")
    draw(left, energy["t"], energy["kinetic"], color=FLUID, label="computed")
    left.plot(energy["t"], energy["kinetic"][0] * np.exp(-RATE * energy["t"]), color=REFERENCE, linewidth=1.0, label="exact")
    left.set(title="Kinetic energy", xlabel="t [s]", ylabel="[J/m]")
    left.legend()
    for column, label in (("viscous", "viscosity"), ("dissipation_riemann", "Riemann solver"), ("dissipation_mass_flux", "mass flux"),
                          ("dissipation_walls", "walls")):
        right.plot(energy["t"], energy[column], linewidth=1.2, label=label)
    right.set(title="Lost to", xlabel="t [s]", ylabel="[J/m]")
    right.legend()
    return figure


def pictures(run: RunFolder) -> list[tuple]:
    """(figure, kind, caption) of each picture for the report."""
    return [(energies(run), "svg", "A vortex in a viscous liquid, Re = 100: its kinetic energy and what took it.")]
