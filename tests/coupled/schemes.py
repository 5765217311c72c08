# SPDX-License-Identifier: MIT
"""Every scheme of the exchange on the piston, whose answer is exact, and multi-rate on several ranks.

usage: schemes.py --programs BIN [unittest's arguments]
"""
import argparse
import json
import sys
import unittest
from pathlib import Path

from coupled_run import ROOT, InScratchFolder, run

from expectations import angular_frequency  # noqa: E402  (coupled_run adds cases/tools to the path)
from run_folder import RunFolder  # noqa: E402

ARGUMENTS = argparse.Namespace()
PISTON = ROOT / "cases" / "piston_column"
GATE = ROOT / "cases" / "elastic_gate_small"


class Schemes(InScratchFolder):
    def run_case(self, name: str, case: Path, ranks: tuple[int, int], *sets: str) -> RunFolder:
        out = self.folder / name
        self.assertEqual(run(case, ARGUMENTS.programs, out, ranks, list(sets)), 0)
        return RunFolder(out)

    def piston(self, scheme: str, every: int = 1) -> tuple[float, float]:
        """Angular frequency over the exact one, and interface work mismatch over the largest work."""
        found = self.run_case(f"{scheme}_{every}", PISTON, (1, 1), f"coupling.coupling.scheme={scheme}",
                              f"coupling.coupling.solid_every={every}")
        probes, works = found.table("solid/probes.csv"), found.table("coupling/interface.csv")
        mismatch = abs(works["work_on_fluid"] + works["work_on_solid"]).max() / abs(works["work_on_solid"]).max()
        return angular_frequency(probes["t"], probes["piston.u"]) / 25.054, mismatch

    def test_parallel_schemes_meet_the_frequency(self) -> None:
        for scheme, limit in (("parallel", 0.06), ("parallel_impedance", 0.12), ("parallel_extrapolated", 0.002)):
            frequency, mismatch = self.piston(scheme)
            self.assertAlmostEqual(frequency, 1, delta=1e-3, msg=scheme)
            self.assertLess(mismatch, limit, scheme)

    def test_serial_keeps_the_work(self) -> None:
        frequency, mismatch = self.piston("serial")
        self.assertAlmostEqual(frequency, 1, delta=1e-3)
        self.assertLess(mismatch, 0.01)

    def test_multi_rate_meets_the_frequency(self) -> None:
        frequency, mismatch = self.piston("serial", every=2)
        self.assertAlmostEqual(frequency, 1, delta=2e-3)
        self.assertLess(mismatch, 0.05)
        windows = RunFolder(self.folder / "serial_2")
        fluid = json.loads((self.folder / "serial_2" / "fluid" / "summary.json").read_text(encoding="utf-8"))
        self.assertEqual(len(windows.table("coupling/interface.csv")["t"]) - 1, fluid["steps"] // 2)

    def test_multi_rate_is_the_same_on_several_ranks(self) -> None:
        hashes = set()
        for ranks in ((1, 1), (3, 1)):
            name = f"gate_{ranks[0]}"
            self.run_case(name, GATE, ranks, "coupling.time.end=0.006", "coupling.coupling.scheme=serial",
                          "coupling.coupling.solid_every=2")
            solid = json.loads((self.folder / name / "solid" / "summary.json").read_text(encoding="utf-8"))
            hashes.add((solid["state_hash"], solid["loads_hash"]))
            works = RunFolder(self.folder / name).table("coupling/interface.csv")
            gap = works["work_on_fluid"] + works["work_on_solid"]       # but for forces that change within a window
            self.assertLess(abs(works["lag_work"] - gap).max(), 0.05 * abs(works["work_on_solid"]).max())
        self.assertEqual(len(hashes), 1)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--programs", type=Path, required=True)
    ARGUMENTS, rest = parser.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest])
