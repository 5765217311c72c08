# SPDX-License-Identifier: MIT
"""The water's momentum against what it was given: no gravity, so

    P(t) + (what left took along) = impulse of the walls
"""
import numpy as np

from run_folder import RunFolder


def momentum_error(run: RunFolder, entry: dict) -> float:
    """Largest distance of the two sides, over the largest impulse."""
    table = run.table("fluid/energy.csv")
    given = np.array([table[f"impulse_of_walls_{axis}"] + table[f"impulse_of_interface_{axis}"] for axis in "xyz"])
    kept = np.array([table[f"momentum_{axis}"] + table[f"outflow_momentum_{axis}"] for axis in "xyz"])
    return float(np.abs(kept - given).max() / np.abs(given).max())
