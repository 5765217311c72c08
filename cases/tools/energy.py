# SPDX-License-Identifier: MIT
"""The energy of the fluid and its solids together, from the energy.csv of each.

    drift(t) = (E_f + E_s - W_external)(t) - the same at 0

E_f = kinetic + potential + internal of the particles that are left, plus what the removed ones took along;
E_s = kinetic + strain + potential; W_external: the work of walls on the fluid, of supports and of loads on the solid.
What passes through the interface cancels, but for its mismatch, which therefore is part of the drift.
"""
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from run_folder import RunFolder, Table

DISSIPATIONS = {"fluid": (("dissipation_riemann", "Riemann solver"), ("dissipation_mass_flux", "mass flux"),
                          ("dissipation_walls", "walls"), ("viscous", "viscous")),
                "solid": (("numerical_dissipation", "HHT"), ("damping", "damping"), ("material", "material"),
                          ("contact", "contact"), ("friction", "friction"))}


@dataclass
class EnergySum:
    """Energies of the coupled system over time [J], [J/m] in 2D."""
    t: np.ndarray
    fluid: np.ndarray
    solid: np.ndarray
    external: np.ndarray
    unit: str

    @property
    def total(self) -> np.ndarray:
        return self.fluid + self.solid

    @property
    def drift(self) -> np.ndarray:
        balance = self.total - self.external
        return balance - balance[0]


def fluid_energy(table: Table) -> np.ndarray:
    return table["kinetic"] + table["potential"] + table["internal"] + table.get("outflow_energy")


def solid_energy(table: Table) -> np.ndarray:
    return table["kinetic"] + table["strain"] + table["potential"]


def energy_sum(run: RunFolder) -> EnergySum | None:
    """All energies at the fluid's instants (the solids' interpolated there); None where no file is there."""
    fluid = run.table("fluid/energy.csv")
    solids = [table for side in run.solids() or ["solid"] if (table := run.table(f"{side}/energy.csv")) is not None]
    if fluid is None and not solids:
        return None
    first = fluid if fluid is not None else solids[0]
    t = first["t"]
    zero = np.zeros(len(t))
    external = zero + (fluid.get("work_by_walls") if fluid is not None else 0)
    in_solids = zero.copy()
    for solid in solids:
        in_solids += np.interp(t, solid["t"], solid_energy(solid))
        for name in ("work_supports", "work_loads"):
            external = external + np.interp(t, solid["t"], solid.get(name))
    return EnergySum(t, fluid_energy(fluid) if fluid is not None else zero, in_solids, external,
                     first.unit("kinetic") or "J")


def write_energy_total(run: RunFolder) -> EnergySum | None:
    """Writes energy_total.csv into the run, unless it is there already or one side's energies are missing."""
    energies = energy_sum(run)
    path: Path = run.path / "energy_total.csv"
    if energies is None or path.exists() or not run.solids() or any(
            run.table(f"{side}/energy.csv") is None for side in ("fluid", *run.solids())):
        return energies
    columns = ("fluid", "solid", "total", "external_work", "drift")
    header = "t[s]," + ",".join(f"{name}[{energies.unit}]" for name in columns)
    rows = np.column_stack((energies.t, energies.fluid, energies.solid, energies.total, energies.external,
                            energies.drift))
    np.savetxt(path, rows, delimiter=",", header=header, comments="", fmt="%.12g")
    return energies
