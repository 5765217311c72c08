# SPDX-License-Identifier: MIT
"""Calibrates the rubber's loss: prints softening_r. It is a fit to the measured tip, not a measurement of the rubber.

usage: calibrate.py R=RUN R=RUN                          (two finished runs of this case, each with its softening_r)

Least squares of x at 0.20, 0.24 and 0.28 s, the first times of unloading; the tip is taken as linear in 1/r between the two runs.
On the rise the law loses nothing, so what ../calibrate.py fitted stays. y and later times are not looked at.
"""
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "tools"))

from run_folder import RunFolder, Table  # noqa: E402

FIRST, LAST = 0.20, 0.28                         # of the measured times that are fitted [s]


def distance(run: Path) -> np.ndarray:
    """The tip's distance from the measured one at the fitted times [mm]."""
    measured = Table(HERE.parent / "reference" / "antoci_gate_experiment.csv")
    fitted = (measured["t"] > FIRST - 1e-9) & (measured["t"] < LAST + 1e-9)
    probes = RunFolder(run).table("solid/probes.csv")
    return 1000 * np.interp(measured["t"][fitted], probes["t"], probes["tip.ux"]) - measured["x_tip"][fitted]


def main() -> None:
    if len(sys.argv) != 3:
        raise SystemExit(__doc__)
    (first, far), (second, near) = ((1 / float(r), distance(Path(run))) for r, run in (word.split("=", 1) for word in sys.argv[1:]))
    slope = (near - far) / (second - first)
    print(f"softening_r = {1 / (first - far @ slope / (slope @ slope)):.3g}")


if __name__ == "__main__":
    main()
