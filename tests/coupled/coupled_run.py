# SPDX-License-Identifier: MIT
"""The tests' way to a case: cases/tools on the path, its launcher, and a folder for what it writes."""
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "cases" / "tools"))

from launch import ENVIRONMENT, mpirun_line, run  # noqa: E402, F401


class InScratchFolder(unittest.TestCase):
    """Tests that write into `folder`, each into an empty one that goes with it."""

    def setUp(self) -> None:
        scratch = tempfile.TemporaryDirectory(prefix="rivage_")
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)
