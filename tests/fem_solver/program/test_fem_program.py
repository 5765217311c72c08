# SPDX-License-Identifier: MIT
"""fem_solver as a user runs it, alone: the static gate against its expect.toml, a short dynamic run, bad input.

usage: test_fem_program.py --program FEM_SOLVER --case CASE_FOLDER
"""
import argparse
import csv
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "cases" / "tools"))

from check_expectations import judge  # noqa: E402

ARGUMENTS = argparse.Namespace()


def run(folder: str, *options: str) -> subprocess.CompletedProcess:
    line = [str(ARGUMENTS.program), str(ARGUMENTS.case / "solid.toml"), "--out", folder]
    for option in options:
        line += ["--set", option]
    return subprocess.run(line, capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=100, check=False)


def read(path: Path) -> list[dict]:
    with path.open(encoding="utf-8") as file:
        return list(csv.DictReader(file))


class FemProgram(unittest.TestCase):
    def setUp(self) -> None:
        scratch = tempfile.TemporaryDirectory(prefix="rivage_")
        self.addCleanup(scratch.cleanup)
        self.out = scratch.name

    def test_static_gate_hits_its_references(self) -> None:
        result = run(self.out)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(judge(Path(self.out), ARGUMENTS.case), 0)
        self.assertTrue(Path(self.out, "solid", "fields.xdmf").exists())

    def test_short_dynamic_run(self) -> None:
        result = run(self.out, "solid.analysis.kind=dynamic", "solid.time.dt=1e-4", "solid.time.end=2e-3",
                     "solid.mesh.cells=[2, 20]")
        self.assertEqual(result.returncode, 0, result.stderr)
        rows = read(Path(self.out, "solid", "energy.csv"))
        self.assertEqual(len(rows), 21)
        self.assertAlmostEqual(float(rows[-1]["t[s]"]), 2e-3, places=12)
        work = float(rows[-1]["work_loads[J/m]"])
        self.assertGreater(work, 0)
        self.assertLess(abs(float(rows[-1]["balance_error[J/m]"])), 1e-8 * work)
        summary = json.loads(Path(self.out, "solid", "summary.json").read_text(encoding="utf-8"))
        self.assertEqual(summary["steps"], 20)

    def test_a_dynamic_run_may_start_in_equilibrium(self) -> None:
        coarse = "solid.mesh.cells=[2, 20]"
        run(f"{self.out}/static", coarse)
        result = run(f"{self.out}/dynamic", coarse, "solid.analysis.kind=dynamic", "solid.time.dt=1e-3", "solid.time.end=5e-3",
                     "solid.analysis.initial_equilibrium=true")
        self.assertEqual(result.returncode, 0, result.stderr)
        tips = [[float(row["tip.ux[m]"]) for row in read(Path(self.out, kind, "solid", "probes.csv"))]
                for kind in ("static", "dynamic")]
        for tip in tips[1]:
            self.assertAlmostEqual(tip, tips[0][-1], delta=1e-8)

    def test_same_input_gives_the_same_bits(self) -> None:
        hashes = []
        for name in ("first", "second"):
            folder = f"{self.out}/{name}"
            run(folder, "solid.mesh.cells=[2, 10]")
            hashes.append(json.loads(Path(folder, "solid", "summary.json").read_text(encoding="utf-8"))["state_hash"])
        self.assertEqual(hashes[0], hashes[1])

    def test_bad_input_ends_with_code_2(self) -> None:
        for option, word in (("solid.mesh.celsl=[2, 20]", "celsl"), ("solid.material.rubber.nu=0.5", "nu"),
                             ("solid.analysis.kind=dynamic", "[time] dt")):
            result = run(self.out, option)
            self.assertEqual(result.returncode, 2, option)
            self.assertIn(word, result.stdout + result.stderr)

    def test_no_convergence_ends_with_code_3(self) -> None:
        result = run(self.out, "solid.newton.max_iterations=1", "solid.mesh.cells=[2, 20]")
        self.assertEqual(result.returncode, 3)
        self.assertIn("at node", result.stdout + result.stderr)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=Path, required=True)
    parser.add_argument("--case", type=Path, required=True)
    parser.parse_args(namespace=ARGUMENTS)
    unittest.main(argv=[sys.argv[0]], verbosity=2)
