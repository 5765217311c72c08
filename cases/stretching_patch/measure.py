# SPDX-License-Identifier: MIT
"""Figures of the stretching patch beside the exact answer of an incompressible fluid, reference/patch_exact.csv."""
from pathlib import Path

import numpy as np

from run_folder import Table

EXACT = Table(Path(__file__).resolve().parent / "reference" / "patch_exact.csv")
RINGING = 0.26                                               # [s] period of the compressible disc's ringing, 3.83 Hz
COLUMNS = {"major": ("water.semi_axis_1", "b_y"), "minor": ("water.semi_axis_2", "a_x")}


def axis_error(run, entry) -> float:
    """Relative error of the semi-axis entry["axis"] at the time entry["at"]."""
    ours, exact = COLUMNS[entry["axis"]]
    probes = run.table("fluid/probes.csv")
    if probes["t"][-1] < entry["at"]:
        raise ValueError(f"the run ends at t = {probes['t'][-1]:.4g} s")
    return float(np.interp(entry["at"], probes["t"], probes[ours]) / np.interp(entry["at"], EXACT["t"], EXACT[exact]) - 1)


def energy_loss(run, entry) -> float:
    """Energy lost until entry["at"] over the kinetic energy at the start."""
    table = run.table("fluid/energy.csv")
    if table["t"][-1] < entry["at"]:
        raise ValueError(f"the run ends at t = {table['t'][-1]:.4g} s")
    total = table["kinetic"] + table["internal"]
    return float((total[0] - np.interp(entry["at"], table["t"], total)) / table["kinetic"][0])


def energy_gain(run, entry) -> float:
    """Largest rise of the total energy above any earlier value, over the kinetic energy at the start."""
    table = run.table("fluid/energy.csv")
    total = table["kinetic"] + table["internal"]
    return float((total - np.minimum.accumulate(total)).max() / table["kinetic"][0])


def centre_pressure_error(run, entry) -> float:
    """Pressure in the centre, averaged over one ringing period about entry["at"], against the exact one so averaged."""
    probes = run.table("fluid/probes.csv")
    times = np.linspace(entry["at"] - RINGING / 2, entry["at"] + RINGING / 2, 521)
    ours = np.trapz(np.interp(times, probes["t"], probes["centre.pressure"]), times)
    return float(ours / np.trapz(np.interp(times, EXACT["t"], EXACT["p_centre"]), times) - 1)
