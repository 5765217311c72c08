# SPDX-License-Identifier: MIT
"""The command that starts a case: programs of the build, Python scripts and modules, one solver alone."""
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "cases" / "tools"))

from launch import CROWDED, mpirun_line  # noqa: E402

SHARED = """
[participants.fluid]
program = "rivage.fake_fluid"
arguments = ["constant", "--pressure", "1000"]
[participants.solid]
program = "{solid}"
file = "solid.toml"
"""


class Launch(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.case = Path(scratch.name)

    def line(self, text: str, ranks=(1, 1), cores=2, name="coupling.toml") -> list[str]:
        (self.case / name).write_text(text, encoding="utf-8")
        return mpirun_line(self.case, Path("/build/bin"), Path("out"), ranks, ["coupling.time.end=1"], cores)

    def test_a_module_and_a_program(self):
        shared, end = str(self.case / "coupling.toml"), ["--out", "out", "--set", "coupling.time.end=1"]
        self.assertEqual(self.line(SHARED.format(solid="fem_solver")), [
            "mpirun", "-n", "1", "-x", "PYTHONPATH=/build/python", "/usr/bin/python3", "-m", "rivage.fake_fluid", shared, "constant",
            "--pressure", "1000", "--as", "fluid", *end, ":", "-n", "1", "/build/bin/fem_solver", shared, "--as", "solid", *end])

    def test_a_script_and_an_executable_lie_beside_the_file(self):
        for program, before in (("gate.py", "/usr/bin/python3"), ("./plate", "PYTHONPATH=/build/python")):
            line = self.line(SHARED.format(solid=program))
            self.assertEqual(line[line.index(str(self.case / program)) - 1], before)
            self.assertNotIn("-m", line[line.index(":"):])

    def test_a_solver_alone_on_crowded_cores(self):
        line = self.line("", ranks=(3, 1), name="fluid.toml")
        self.assertEqual(line[:len(CROWDED) + 4], ["mpirun", *CROWDED, "-n", "3", "/build/bin/sph_solver"])

    def test_what_is_missing_is_said(self):
        for text, words in (("", "no \\[participants.NAME\\] table"), ("[participants.solid]\nfile = 'a'", "solid\\] names no program")):
            with self.assertRaisesRegex(ValueError, words):
                self.line(text)


if __name__ == "__main__":
    unittest.main()
