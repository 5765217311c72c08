# SPDX-License-Identifier: MIT
"""Friction against load on ground that rises along x alone, once the whole sole slides: from load factor 0.6 on, 2.8 mm sideways."""
import numpy as np

from run_folder import RunFolder

FRICTION, SLIDING = 0.5, 0.6


def sliding(run: RunFolder, table: str):
    """The table and which of its rows belong to the slide."""
    rows = run.table(table)
    return rows, rows["t"] >= SLIDING


def friction_error(run: RunFolder, entry: dict) -> float:
    """Largest relative distance of -F_x (friction) over N_z (pressure) from the coefficient."""
    contact, inside = sliding(run, "solid/contact.csv")
    ratio = -contact["back.friction_x"][inside] / contact["back.normal_z"][inside]
    return float(np.abs(ratio / FRICTION - 1).max())


def balance_error(run: RunFolder, entry: dict) -> float:
    """Largest distance of the driven face's force from what the ground gives, over the largest of it."""
    contact, inside = sliding(run, "solid/contact.csv")
    face = run.table("solid/reactions.csv")
    ground = np.array([contact[f"back.normal_{k}"] + contact[f"back.friction_{k}"] for k in "xz"])
    held = np.array([face[f"front.f{k}"] for k in "xz"])
    return float(np.abs(ground + held)[:, inside].max() / np.abs(ground).max())
