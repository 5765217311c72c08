# SPDX-License-Identifier: MIT
"""What a column of a table does not show."""
import numpy as np


def asymmetry(run, entry) -> float:
    """Largest difference of one tip from the other's mirror image over the largest displacement."""
    left, right = run.table("left/probes.csv"), run.table("right/probes.csv")
    gap = np.hypot(left["tip.ux"] + right["tip.ux"], left["tip.uy"] - right["tip.uy"])
    return float(gap.max() / np.hypot(right["tip.ux"], right["tip.uy"]).max())
