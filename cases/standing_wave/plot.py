# SPDX-License-Identifier: MIT
"""Pictures of the standing wave: kinetic energy beside the fitted decay, level at the left wall."""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / "tools"), str(HERE)]

import numpy as np  # noqa: E402

from expectations import case_function  # noqa: E402
from figure_style import FLUID, REFERENCE, draw, plt  # noqa: E402
from run_folder import RunFolder  # noqa: E402

AMPLITUDE, OMEGA, LEVEL = 0.005, 5.316553, 0.5              # [m], [rad/s], [m]


def wave(run: RunFolder):
    energy, probes = run.table("fluid/energy.csv"), run.table("fluid/probes.csv")
    if energy is None or probes is None:
        return None
    t = energy["t"]
    omega, decay = case_function(HERE, "fit")(run)
    figure, (left, right) = plt.subplots(1, 2, figsize=(11.5, 3.3), layout="constrained")
    draw(left, t, energy["kinetic"], color=FLUID, label="computed")
    left.plot(t, energy["kinetic"][0] * np.exp(-2 * decay * t), color=REFERENCE, linewidth=1.0,
              label=f"decay fitted, d = {decay:.3g} 1/s")
    left.set(title=f"Kinetic energy, fitted period {2 * np.pi / omega:.4f} s", xlabel="t [s]", ylabel="[J/m]")
    left.legend()
    draw(right, probes["t"], 1000 * (probes["left.front"] - LEVEL), color=FLUID, label="computed, highest particle + dx/2")
    right.plot(t, 1000 * AMPLITUDE * np.sin(OMEGA * t), color=REFERENCE, linewidth=1.0, label="linear wave")
    right.set(title="Level beside the left wall", xlabel="t [s]", ylabel="[mm]")
    right.legend()
    return figure


def pictures(run: RunFolder) -> list[tuple]:
    """(figure, kind, caption) of each picture for the report."""
    return [(wave(run), "svg", "First standing wave of a closed tank, amplitude one per cent of the depth.")]
