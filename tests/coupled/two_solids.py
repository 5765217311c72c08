# SPDX-License-Identifier: MIT
"""One fluid between two solids: mirror images of each other and of the single gate, on any ranks, each replayed alone.

usage: two_solids.py --programs BIN [unittest's arguments]
"""
import argparse
import os
import subprocess
import sys
import unittest
from pathlib import Path

import numpy as np

from coupled_run import ENVIRONMENT, ROOT, InScratchFolder, run

from run_folder import RunFolder  # noqa: E402  (coupled_run adds cases/tools to the path)

ARGUMENTS = argparse.Namespace()
TWO_GATES, ONE_GATE = ROOT / "cases" / "two_gates", ROOT / "cases" / "elastic_gate_small"
EXACT = ("left.newton.tolerance=1e-12", "right.newton.tolerance=1e-12")    # mirrored answers are alike as far as they are answers
SIDES = {"fluid": "sph_solver", "left": "fem_solver", "right": "fem_solver"}


def tip(found: RunFolder, role: str) -> np.ndarray:
    """Both displacements over time, those of the left gate mirrored."""
    probes = found.table(f"{role}/probes.csv")
    return np.stack([probes["tip.ux"] * (-1 if role == "left" else 1), probes["tip.uy"]])


class TwoSolids(InScratchFolder):
    def run_case(self, case: Path, ranks: tuple[int, int], *sets: str) -> RunFolder:
        out = self.folder / f"{case.name}_{ranks[0]}_{ranks[1]}"
        self.assertEqual(run(case, ARGUMENTS.programs, out, ranks, list(sets)), 0)
        return RunFolder(out)

    def assert_same(self, found: np.ndarray, wanted: np.ndarray, tolerance: float) -> None:
        self.assertEqual(found.shape, wanted.shape)
        self.assertLess(np.abs(found - wanted).max(), tolerance * np.abs(wanted).max())

    def test_both_gates_move_as_one_alone_would(self) -> None:
        """Three ranks of the fluid, two of each solid. In the middle of the water stands no wall, but a plane of symmetry."""
        end = "coupling.time.end=0.01"
        both, one = self.run_case(TWO_GATES, (3, 2), end), self.run_case(ONE_GATE, (1, 1), end)
        self.assert_same(tip(both, "left"), tip(both, "right"), 1e-9)
        self.assert_same(tip(both, "right"), tip(one, "solid"), 1e-3)
        energies, half = both.table("energy_total.csv"), one.table("energy_total.csv")
        self.assert_same(energies["drift"], 2 * half["drift"], 5e-3)
        self.assert_same(tip(self.run_case(TWO_GATES, (1, 1), end), "left"), tip(both, "left"), 1e-9)

    def test_each_interface_has_its_account(self) -> None:
        """Forces arrive as they were sent; what the works lack of each other is the lag's; the fluid's own work is their sum."""
        found = self.run_case(TWO_GATES, (2, 1), "coupling.time.end=0.01", "coupling.output.table_interval=0", *EXACT)
        tables = found.interfaces()
        self.assertEqual(set(tables), {"left", "right"})
        self.assert_same(tables["left"]["force_sent_x"], -tables["right"]["force_sent_x"], 1e-9)
        for table in tables.values():
            gap = table["work_on_fluid"] + table["work_on_solid"]
            self.assert_same(table["lag_work"], gap, 1e-6)
        fluid = found.table("fluid/energy.csv")
        jumps = sum(table["jump_work"] for table in tables.values())
        self.assert_same(fluid["work_by_interface"] - jumps, sum(table["work_on_fluid"] for table in tables.values()), 1e-9)

    def test_each_side_is_replayed_without_the_others(self) -> None:
        sets = ("coupling.time.end=0.003", 'coupling.coupling.record="traffic.h5"')
        recorded = self.run_case(TWO_GATES, (2, 1), *sets)
        for role, program in SIDES.items():
            out = self.folder / f"replayed_{role}"
            line = ["mpirun", "--oversubscribe", "--bind-to", "none", "-n", "2" if role == "fluid" else "1",
                    str(ARGUMENTS.programs / program), str(TWO_GATES / "coupling.toml"), "--as", role, "--set", sets[0],
                    "--out", str(out), "--replay", str(recorded.path / "traffic.h5")]
            done = subprocess.run(line, env=os.environ | ENVIRONMENT, stdin=subprocess.DEVNULL, capture_output=True,
                                  text=True, timeout=120, check=False)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertIn("to the bit", done.stdout)
            self.assertEqual(RunFolder(out).summary()[role]["state_hash"], recorded.summary()[role]["state_hash"])


if __name__ == "__main__":
    PARSER = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    PARSER.add_argument("--programs", type=Path, required=True)
    ARGUMENTS, REST = PARSER.parse_known_args()
    unittest.main(argv=[sys.argv[0], *REST])
