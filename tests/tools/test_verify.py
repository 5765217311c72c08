# SPDX-License-Identifier: MIT
"""Verification's plan, its convergence tables and its page, without a solver."""
import importlib.util
import json
import math
import sys
import tempfile
import tomllib
import unittest
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "cases" / "tools"))

from check_expectations import line  # noqa: E402
from convergence import extrapolated, followed, rates  # noqa: E402
from expectations import Finding, check  # noqa: E402
from launch import run_tests  # noqa: E402
from run_folder import RunFolder  # noqa: E402
from verify_page import BEGIN, END, write_page  # noqa: E402
from verify_plan import CASES, find_cases, plan, title  # noqa: E402


def write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def write_run(path: Path, dx: float, value: float) -> RunFolder:
    write(path / "used_config.toml", f"[fluid.resolution]\nspacing = {dx}\n")
    write(path / "fluid/probes.csv", f"t[s],a.x[m]\n0,0\n1,{value}\n")
    return RunFolder(path)


class Scratch(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = Path(self.folder.name)

    def tearDown(self):
        self.folder.cleanup()


class Plan(Scratch):
    def test_every_case_has_a_plan_and_its_expectations_name_runs_of_it(self):
        for folder in find_cases([]):
            names = {run.name for run in plan(folder)}
            self.assertTrue(names, title(folder))
            expected = folder / "expect.toml"
            text = expected.read_text(encoding="utf-8") if expected.exists() else ""
            content = tomllib.loads(text)
            for entry in content.get("expect", []) + content.get("convergence", []):
                wanted = entry.get("run", entry.get("runs", []))
                for name in [wanted] if isinstance(wanted, str) else wanted:
                    self.assertIn(name, names, f"{title(folder)}: {entry['quantity']}")

    def test_variants_are_cases_of_their_own(self):
        for name in ("case/fluid.toml", "case/inclined/fluid.toml", "case/reference/data.csv"):
            write(self.path / name, "")
        self.assertEqual([folder.name for folder in find_cases([str(self.path / "case")])], ["case", "inclined"])
        self.assertEqual([run.name for run in plan(self.path / "case")], ["as it stands"])
        with self.assertRaisesRegex(ValueError, "no case"):
            find_cases([str(self.path / "nothing")])

    def test_runs_as_declared(self):
        write(self.path / "verify.toml", '[[run]]\nname = "fine"\n[[run]]\nname = "coarse"\nset = ["a.b=1"]\nfluid_ranks = 2\n')
        fine, coarse = plan(self.path)
        self.assertTrue(fine.as_it_stands)
        self.assertFalse(coarse.as_it_stands)
        self.assertEqual(fine.inputs, ".")
        self.assertEqual(coarse.ranks, (2, 1))
        write(self.path / "verify.toml", '[[run]]\nname = "fine"\nsets = []\n')
        with self.assertRaisesRegex(ValueError, "sets"):
            plan(self.path)

    def test_a_group_stands_for_its_cases(self):
        names = [title(folder) for folder in find_cases(["solid"])]
        self.assertIn("gate_static", names)
        self.assertIn("solid_tests", names)
        self.assertNotIn("dam_break", names)

    def test_a_run_may_be_tests_of_a_test_program(self):
        write(self.path / "verify.toml", '[[run]]\nname = "t"\ntest_program = "test_x"\nfilter = "A.*"\n')
        (run,) = plan(self.path)
        self.assertEqual((run.test_program, run.filter, run.as_it_stands), ("test_x", "A.*", False))
        program = self.path / "test_x"
        write(program, '#!/bin/sh\nout=${2#*json:}\n'
              """echo '{"testsuites":[{"testsuite":[{"name":"a","figure_e":"1e-3"},{"name":"b","figure_e":"-2e-3"}]}]}' > "$out"\n""")
        program.chmod(0o755)
        self.assertEqual(run_tests(program, run.filter, self.path / "out"), 0)
        self.assertEqual(RunFolder(self.path / "out").summary()["recorded"], {"figure_e": -2e-3})  # the worst of both


class Convergence(Scratch):
    def test_orders_and_ratios(self):
        dx, exact_second_order = [0.4, 0.2, 0.1], [1 + 0.16, 1 + 0.04, 1 + 0.01]
        for value in rates(dx, exact_second_order, 1.0, "order") + rates(dx, exact_second_order, None, "order"):
            self.assertAlmostEqual(value, 2.0)
        self.assertAlmostEqual(rates(dx, exact_second_order, None, "ratio")[0], 4.0)

    def test_a_table_over_runs(self):
        runs = {name: write_run(self.path / name, dx, value) for name, dx, value in
                (("coarse", 0.4, 0.3), ("middle", 0.2, 0.1), ("fine", 0.1, 0.05))}
        entry = {"quantity": "q", "file": "fluid/probes.csv", "column": "a.x", "operation": "last", "exact": 0.0, "show": "order",
                 "runs": ["coarse", "middle", "fine"], "low": 1.2}
        finding = followed("case", entry, runs)
        self.assertAlmostEqual(finding.value, 1.0)
        self.assertFalse(finding.passed)
        self.assertIn("dx = 0.2 m: 0.1; dx = 0.1 m: 0.05; order 1.58, 1.00", finding.detail)
        self.assertIn("no run finest", followed("case", entry | {"runs": ["coarse", "finest"]}, runs).reason)


    def test_three_figures_are_extrapolated_where_they_converge(self):
        self.assertAlmostEqual(extrapolated([1 + 3 * dx**1.5 for dx in (0.4, 0.2, 0.1)]), 1.0)
        self.assertIsNone(extrapolated([1.0, 1.1, 1.3]))     # diverging
        self.assertIsNone(extrapolated([1.0, 1.2, 1.1]))     # to and fro
        self.assertIsNone(extrapolated([1.0, 1.1]))


class Expectations(Scratch):
    def test_a_run_meets_only_what_is_meant_for_it(self):
        write(self.path / "case/expect.toml", '[[expect]]\nquantity = "always"\nfunction = "answer"\nhigh = 50\n'
              '[[expect]]\nquantity = "coarse"\nfunction = "answer"\nrun = ["coarse", "other"]\nlow = 50\nmiss = "it is 42"\n'
              '[[expect]]\nquantity = "both"\nfunction = "answer"\nrun = ["as it stands", "fine"]\nlow = 50\n')
        write(self.path / "case/measure.py", "def answer(run, entry):\n    return 42\n")
        run = RunFolder(self.path)
        self.assertEqual([f.entry["quantity"] for f in check(run, self.path / "case")], ["always", "both"])
        self.assertEqual(len(check(run, self.path / "case", ("fine", "as it stands"))), 2)   # one run by two names: once
        (coarse,) = check(run, self.path / "case", ("coarse",))
        self.assertEqual(coarse.value, 42)
        self.assertEqual(coarse.as_record()["cause"], "it is 42")
        self.assertIn("MISS", line(coarse))

    def test_a_variant_uses_its_case_s_functions(self):
        write(self.path / "case/measure.py", "def answer(run, entry):\n    return entry['at']\n")
        write(self.path / "case/steep/expect.toml", '[[expect]]\nquantity = "q"\nfunction = "answer"\nat = 3\n')
        self.assertEqual(check(RunFolder(self.path), self.path / "case/steep")[0].value, 3)


class Page(Scratch):
    def record(self, case, found, **entry):
        return Finding(case, {"quantity": "q[m]", "source": "s"} | entry, found).as_record() | {"run": "r", "dx": 0.1, "wall_s": 2.0}

    def test_hand_written_text_survives_and_misses_come_first(self):
        write(self.path / "verification.md", f"before\n{BEGIN}\nold\n{END}\nafter\n")
        write_page(self.path, [self.record("a", 1.2, value=1.0, tolerance=0.1, miss="too coarse"), self.record("b", 0.1, high=0.2)])
        text = (self.path / "verification.md").read_text(encoding="utf-8")
        self.assertTrue(text.startswith("before\n") and text.endswith("\nafter\n"))
        self.assertIn("2 figures, 1 misses", text)
        self.assertIn("| a | q[m] | 1.2 | 1 | +20 % | 10 % | 0.1 | too coarse |", text)
        self.assertLess(text.index("too coarse"), text.index("Single runs"))

    def test_a_run_of_one_case_leaves_the_others(self):
        write(self.path / "verification.md", f"{BEGIN}\n{END}\n")
        write_page(self.path, [self.record("a", 1.0, high=2), self.record("b", 1.0, high=2)])
        write_page(self.path, [self.record("b", 3.0, high=2)])
        records = [json.loads(text) for text in (self.path / "verification_results.jsonl").read_text().splitlines()]
        self.assertEqual([(record["case"], record["value"]) for record in records], [("a", 1.0), ("b", 3.0)])
        self.assertTrue(math.isclose(records[1]["wall_s"], 2.0))

    def test_one_run_of_a_case_leaves_its_others(self):
        write(self.path / "verification.md", f"{BEGIN}\n{END}\n")
        coarse, fine = (self.record("a", 1.0, high=2) | {"run": run} for run in ("coarse", "fine"))
        write_page(self.path, [coarse, fine, self.record("b", 1.0, high=2)])
        write_page(self.path, [fine | {"value": 1.5}], some_runs=True)
        records = [json.loads(text) for text in (self.path / "verification_results.jsonl").read_text().splitlines()]
        self.assertEqual([(record["case"], record["run"], record["value"]) for record in records],
                         [("a", "coarse", 1.0), ("a", "fine", 1.5), ("b", "r", 1.0)])

    def test_a_cause_found_later_comes_from_expect_toml(self):
        docs = self.path / "docs"
        write(docs / "verification.md", f"{BEGIN}\n{END}\n")
        write_page(docs, [self.record("a", 3.0, high=2)])
        self.assertIn("not found yet", (docs / "verification.md").read_text(encoding="utf-8"))
        write(self.path / "cases/a/expect.toml", '[[expect]]\nquantity = "q[m]"\nhigh = 2\nmiss = "the lattice is stiff"\n')
        write_page(docs, [])
        self.assertIn("the lattice is stiff", (docs / "verification.md").read_text(encoding="utf-8"))


class Functions(unittest.TestCase):
    def test_standing_wave_fit_finds_what_it_was_given(self):
        spec = importlib.util.spec_from_file_location("measure", CASES / "standing_wave/measure.py")
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        t = np.linspace(0, 6, 1201)

        class Run:
            def table(self, name):
                return {"t": t, "kinetic": np.exp(-2 * 0.05 * t) * (1 + np.cos(2 * 5.3 * t))}
        omega, decay = module.fit(Run())
        self.assertAlmostEqual(omega, 5.3, delta=1e-4)
        self.assertAlmostEqual(decay, 0.05, delta=1e-4)


if __name__ == "__main__":
    unittest.main()
