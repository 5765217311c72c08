# SPDX-License-Identifier: MIT
"""Figures taken from a run are the right ones, and a figure outside its band is a miss."""
import math
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "cases" / "tools"))

from energy import energy_sum, write_energy_total  # noqa: E402
from expectations import Finding, angular_frequency, check, measure  # noqa: E402
from run_folder import RunFolder, Table  # noqa: E402
from synthetic_run import write_tables  # noqa: E402


class Operations(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = Path(cls.folder.name)
        (cls.path / "solid").mkdir()
        t = np.linspace(0, 1, 11)
        rows = "\n".join(f"{time:.3f},{time * (1 - time):.6f},{2 - time:.3f}" for time in t)
        (cls.path / "solid/probes.csv").write_text(f"t[s],tip.ux[m],tip.uy[m]\n{rows}\n1.1,0.3", encoding="utf-8")

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def figure(self, **entry) -> float:
        common = {"file": "solid/probes.csv", "column": "tip.ux", "folder": self.path}
        return measure(RunFolder(self.path), common | entry)

    def test_each_operation(self):
        self.assertAlmostEqual(self.figure(operation="max"), 0.25)
        self.assertAlmostEqual(self.figure(operation="time_of_max"), 0.5)
        self.assertAlmostEqual(self.figure(operation="min", column="tip.uy"), 1.0)
        self.assertAlmostEqual(self.figure(operation="last", column="tip.uy[m]"), 1.0)
        self.assertAlmostEqual(self.figure(operation="value_at", at=0.25, column="tip.uy"), 1.75)
        self.assertAlmostEqual(self.figure(operation="mean", column="tip.uy"), 1.5)
        self.assertAlmostEqual(self.figure(operation="max", until=0.2), 0.16)
        self.assertAlmostEqual(self.figure(operation="max_abs", over=0.5), 0.5)
        self.assertAlmostEqual(self.figure(operation="max", over={"column": "tip.uy", "operation": "max"}), 0.125)
        self.assertAlmostEqual(self.figure(operation="relative_spread", column=["tip.uy", "t"]), 0.0)

    def test_time_beyond_the_run_is_an_error_not_an_extrapolation(self):
        with self.assertRaisesRegex(ValueError, "the run ends at"):
            self.figure(operation="value_at", at=2.0)

    def test_rms_to_a_reference_curve(self):
        (self.path / "curve.csv").write_text("# source\nt[s],x[mm]\n0,2001\n0.5,1501\n1,1001\n", encoding="utf-8")
        reference = {"file": "curve.csv", "column": "x", "scale": 1e-3}
        self.assertAlmostEqual(self.figure(operation="rms_to_reference", column="tip.uy", reference=reference), 1e-3)
        self.assertAlmostEqual(self.figure(operation="largest_distance", column="tip.uy", reference=reference), 1e-3)

    def test_distance_to_another_run(self):
        other = self.path / "other/solid"
        other.mkdir(parents=True)
        (other / "probes.csv").write_text("t[s],tip.ux[m]\n0,0\n0.5,0.3\n1,0.02\n", encoding="utf-8")
        reference = {"run": "other", "file": "solid/probes.csv", "column": "tip.ux"}
        self.assertAlmostEqual(self.figure(operation="largest_distance", reference=reference, beside=self.path), 0.05)

    def test_a_line_cut_short_is_left_out(self):
        self.assertEqual(len(Table(self.path / "solid/probes.csv")), 11)


class Frequency(unittest.TestCase):
    def test_exact_piston_over_two_periods(self):
        exact = Table(ROOT / "cases/piston_column/reference/piston_column_c50.csv")
        inside = exact["t"] <= 0.502
        self.assertAlmostEqual(angular_frequency(exact["t"][inside], exact["x"][inside]) / 25.054, 1.0, delta=5e-4)

    def test_offset_and_a_second_mode(self):
        t = np.linspace(0, 3, 3001)
        x = 5 + np.cos(7 * t) + 0.05 * np.cos(40 * t)
        self.assertAlmostEqual(angular_frequency(t, x), 7.0, delta=0.01)


class Judgement(unittest.TestCase):
    def passed(self, found, **entry) -> bool:
        return Finding("case", {"quantity": "q"} | entry, found).passed

    def test_bands(self):
        self.assertTrue(self.passed(1.01, value=1.0, tolerance=0.02))
        self.assertFalse(self.passed(1.03, value=1.0, tolerance=0.02))
        self.assertFalse(self.passed(-1.03, value=-1.0, tolerance=0.02))
        self.assertTrue(self.passed(1.03, value=1.0, tolerance=0.05, kind="absolute"))
        self.assertFalse(self.passed(0.2, high=0.1))
        self.assertFalse(self.passed(math.nan, high=0.1))
        self.assertFalse(self.passed(None, high=0.1))

    def test_missing_file_is_a_miss_with_a_reason(self):
        with tempfile.TemporaryDirectory() as name:
            findings = check(RunFolder(Path(name)), ROOT / "cases/elastic_gate/linear")
        self.assertTrue(findings)
        self.assertFalse(any(finding.passed for finding in findings))
        self.assertIn("missing", findings[0].reason)


class Energies(unittest.TestCase):
    def test_drift_of_the_synthetic_run(self):
        with tempfile.TemporaryDirectory() as name:
            run = RunFolder(Path(name))
            write_tables(run.path)
            written = write_energy_total(run)
            table = Table(run.path / "energy_total.csv")
        self.assertEqual(written.drift[0], 0.0)
        np.testing.assert_allclose(table["drift"], written.drift, atol=1e-10)
        np.testing.assert_allclose(table["total"], written.fluid + written.solid, rtol=1e-10)

    def test_no_tables_no_sum(self):
        with tempfile.TemporaryDirectory() as name:
            self.assertIsNone(energy_sum(RunFolder(Path(name))))


if __name__ == "__main__":
    unittest.main()
