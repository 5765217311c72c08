# SPDX-License-Identifier: MIT
"""Runs sph_solver alone on several numbers of ranks: the final states, the energy table and the probes must be the same to the last bit.

usage: test_ranks.py SPH_SOLVER FLUID.toml RANKS ...
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path


def run(solver: str, case: Path, ranks: int, folder: Path) -> dict:
    command = ["mpirun", "--oversubscribe", "--bind-to", "none", "-n", str(ranks), solver, str(case), "--out", str(folder)]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, text=True, timeout=300)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)} ended with {done.returncode}:\n{done.stdout}")
    return json.loads((folder / "fluid" / "summary.json").read_text())


def compare(reference: Path, other: Path) -> list[str]:
    return [name for name in ("energy.csv", "probes.csv")
            if (reference / "fluid" / name).read_bytes() != (other / "fluid" / name).read_bytes()]


def check_figures(figures: dict, case: Path) -> list[str]:
    wrong = []
    if figures["mass_error"] > 1e-12:
        wrong.append(f"mass is not kept: {figures['mass_error']}")
    if figures["deepest_penetration_dx"] > 0.05:
        wrong.append(f"a particle sits {figures['deepest_penetration_dx']} dx deep in a wall")
    if case.stem == "dam_break" and figures["particles_gone"] == 0:
        wrong.append("nothing has left over the end of the floor")
    return wrong


def main() -> int:
    solver, case, rank_counts = sys.argv[1], Path(sys.argv[2]), [int(count) for count in sys.argv[3:]]
    wrong = []
    with tempfile.TemporaryDirectory() as scratch:
        folders = {ranks: Path(scratch) / str(ranks) for ranks in rank_counts}
        figures = {ranks: run(solver, case, ranks, folder) for ranks, folder in folders.items()}
        wrong += check_figures(figures[1], case)
        for ranks in rank_counts[1:]:
            if figures[ranks]["state_hash"] != figures[1]["state_hash"]:
                wrong.append(f"state_hash on {ranks} ranks is {figures[ranks]['state_hash']}, alone {figures[1]['state_hash']}")
            wrong += [f"{name} differs on {ranks} ranks" for name in compare(folders[1], folders[ranks])]
        for ranks, one in figures.items():
            print(ranks, {key: one[key] for key in ("particles", "steps", "rebuilds", "state_hash", "parallel")})
    print("\n".join(wrong) or "the same to the last bit")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
