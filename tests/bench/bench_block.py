# SPDX-License-Identifier: MIT
"""An implicit step of a cube of about 100,000 unknowns with GAMG and MUMPS on 1 and 2 ranks, and with Eigen's sparse LU on one.

usage: bench_block.py --tests TEST_BIN_FOLDER [--cells N]

Eigen's LU (`sparse`) does not run on two ranks, and its fill in space is so large that it gets a time limit: where it ends the run,
this is said, and a small cube compares the three solvers.
"""
import argparse
import json
import os
import shlex
import subprocess
import sys
from pathlib import Path

from bench_case import ENVIRONMENT

COLUMNS = ("order_and_factorise_s", "kept_step_s", "newton_iterations_per_kept_step", "peak_memory_per_rank_MB")
SMALL = 14           # cells along a side: 10,125 unknowns
LIMIT = 40           # [s] of the sparse LU


def run(program: Path, method: str, cells: int, ranks: int, limit: float | None) -> dict[str, float] | None:
    """The metrics of one run, whose JSON lines are printed; None when it has not ended within the limit."""
    line = ["mpirun", "--bind-to", "none", "--oversubscribe", "-n", str(ranks), str(program), method, str(cells)]
    with subprocess.Popen(line, env=os.environ | ENVIRONMENT, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True) as process:
        try:
            printed, _ = process.communicate(timeout=limit)
        except subprocess.TimeoutExpired:
            process.terminate()          # mpirun ends its ranks
            process.communicate()
            return None
    print(printed, end="", flush=True)
    if process.returncode != 0:
        sys.exit(f"bench: '{shlex.join(line)}' ended with code {process.returncode}")
    return {figure["metric"]: figure["value"] for figure in map(json.loads, printed.splitlines())}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--programs", type=Path, help="not used")
    parser.add_argument("--tests", type=Path, required=True)
    parser.add_argument("--cells", type=int, default=32)
    told = parser.parse_args()
    plan = [(method, SMALL, ranks) for method, ranks in (("sparse", 1), ("mumps", 1), ("mumps", 2), ("gamg", 1), ("gamg", 2))]
    plan += [(method, told.cells, ranks) for method, ranks in (("gamg", 1), ("gamg", 2), ("mumps", 1), ("mumps", 2), ("sparse", 1))]
    table = []
    for method, cells, ranks in plan:
        print(f"bench: {method}, {cells}^3 hexa8, {3 * (cells + 1)**3} unknowns, ranks {ranks}", flush=True)
        found = run(told.tests / "bench_block", method, cells, ranks, LIMIT if method == "sparse" else None)
        values = [f"{found[name]:>32g}" for name in COLUMNS] if found else [f" more than {LIMIT} s, stopped"]
        table.append(f"{method:7} {3 * (cells + 1)**3:>9} {ranks:>5}" + "".join(values))
        if ranks == 1 and method == "sparse":
            table.append(f"{method:7} {3 * (cells + 1)**3:>9}     2 does not run on several ranks")
    print("solver   unknowns ranks" + "".join(f"{name:>32}" for name in COLUMNS), *table, sep="\n")


if __name__ == "__main__":
    main()
