# SPDX-License-Identifier: MIT
"""Both sides compute at the same time: a fake fluid and a fake solid that each sleep 20 ms take at most 25 ms a step.

usage: overlap.py --programs BIN_FOLDER
"""
import argparse
import csv
import statistics
import sys
from pathlib import Path

from drill_tools import Run, fluid, solid

SLEEP, LIMIT, STEPS = 0.020, 0.025, 150


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--programs", type=Path, required=True)
    programs = parser.parse_args().programs
    settings = (f"fluid.run.sleep={SLEEP}", f"solid.run.sleep={SLEEP}", f"coupling.time.end={1e-3 * STEPS}")
    run = Run(programs, [fluid(), solid()], settings).finish()
    assert run.code == 0, run.text
    with (run.out / "fluid" / "probes.csv").open() as file:
        wall = [float(row["wall[s]"]) for row in csv.DictReader(file)]
    steps = [later - earlier for earlier, later in zip(wall, wall[1:])]
    median = statistics.median(steps)
    print(f"{len(steps)} steps: median {1e3 * median:.2f} ms, shortest {1e3 * min(steps):.2f} ms, longest {1e3 * max(steps):.2f} ms")
    assert len(steps) == STEPS
    assert SLEEP <= median <= LIMIT, f"a step takes {1e3 * median:.2f} ms; both sides sleep 20 ms, so they do not overlap"
    return 0


if __name__ == "__main__":
    sys.exit(main())
