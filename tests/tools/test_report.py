# SPDX-License-Identifier: MIT
"""The report is one self-contained page, and it bears a run folder that is incomplete or cut off."""
import re
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "cases" / "tools"))

from report import write_report  # noqa: E402
from synthetic_run import write_run  # noqa: E402

GATE = ROOT / "cases" / "elastic_gate"


class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        write_run(Path(cls.folder.name) / "whole")

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def page(self, spoil=lambda run: None, case: Path = GATE) -> str:
        with tempfile.TemporaryDirectory() as name:
            run = Path(name) / "run"
            shutil.copytree(Path(self.folder.name) / "whole", run)
            spoil(run)
            return write_report(run, case).read_text(encoding="utf-8")

    def test_whole_run(self):
        text = self.page()
        self.assertEqual(len(re.findall("<img ", text)), 6)     # snapshots, tip, levels, energies, interface, waits
        self.assertNotIn("Missing in the run folder", text)
        self.assertIn("tip_ux_peak[m]", text)
        self.assertIn("0f3c9a51", text)

    def test_nothing_is_loaded_from_elsewhere(self):
        text = self.page()
        self.assertEqual(re.findall(r'(?:src|href)="(?!data:)', text), [])
        self.assertNotIn("<script", text)

    def test_missing_files_are_named(self):
        for lost in (("coupling/interface.csv", "solid/probes.csv"),
                     ("solid/energy.csv", "fluid/fields.h5", "summary.json")):
            text = self.page(lambda run, lost=lost: [(run / name).unlink() for name in lost])
            for name in lost:
                self.assertIn(name, text)

    def test_empty_folder(self):
        self.assertIn("Missing in the run folder", self.page(empty))

    def test_files_cut_off_by_a_kill(self):
        def cut(run: Path) -> None:
            for name in ("fluid/energy.csv", "solid/probes.csv", "fluid/fields.h5", "summary.json"):
                data = (run / name).read_bytes()
                (run / name).write_bytes(data[: len(data) * 2 // 3])
        self.assertIn("<img ", self.page(cut))

    def test_case_without_pictures_shows_its_probes(self):
        with tempfile.TemporaryDirectory() as name:
            self.assertIn("<img ", self.page(case=Path(name)))


def empty(run: Path) -> None:
    shutil.rmtree(run)
    run.mkdir()


if __name__ == "__main__":
    unittest.main()
