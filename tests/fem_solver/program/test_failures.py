# SPDX-License-Identifier: MIT
"""Numerical failures of fem_solver: exit code 3, and a message that says what happened, where, in which step, and what to try.

usage: test_failures.py --program FEM_SOLVER
"""
import argparse
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ARGUMENTS = argparse.Namespace()

BODY = """
[mesh]
low = [0.0, 0.0]
high = [1.0, 0.5]
cells = [4, 2]
element = "quad8"
[material.rubber]
law = "neo_hookean"
E = 1e6
nu = 0.3
density = 1000
"""
HELD = '[[supports]]\ngroup = "left"\nfix = ["x", "y"]\n'
PUSHED = '[[loads]]\nname = "push"\nkind = "traction"\ngroup = "right"\ntraction = [0.0, {size}]\nfactor = "{factor}"\n'
STATIC = '[analysis]\nkind = "static"\nload_steps = 1\n'
DYNAMIC = "[time]\ndt = {dt}\nend = 1.0\n"


class Failures(unittest.TestCase):
    def expect(self, text: str, *words: str) -> str:
        with tempfile.TemporaryDirectory(prefix="rivage_") as folder:
            file = Path(folder, "solid.toml")
            file.write_text(BODY + text, encoding="utf-8")
            result = subprocess.run([str(ARGUMENTS.program), str(file), "--out", f"{folder}/out"], capture_output=True, text=True,
                                    stdin=subprocess.DEVNULL, timeout=100, check=False)
        said = result.stdout + result.stderr
        self.assertEqual(result.returncode, 3, said)
        for word in words:
            self.assertIn(word, said)
        return said

    def test_a_static_solution_that_does_not_converge(self):
        few = "[newton]\nmax_iterations = 1\n"
        self.expect(HELD + PUSHED.format(size=1e5, factor="1") + STATIC + few, "stride from load factor 0 to 0.5 (load step 1 of 1)",
                    "half of it is tried", "did not converge in 2 iterations", "at node", "reference position (", "displacement (",
                    "load_steps")

    def test_a_step_that_does_not_converge(self):
        few = "[newton]\nmax_iterations = 1\n"
        self.expect(HELD + PUSHED.format(size=1e6, factor="1") + DYNAMIC.format(dt=0.1) + few, "step 1 from t = 0 s", "did not converge",
                    "at node", "reference position (", "smaller time step")

    def test_an_inverted_element_in_statics(self):
        crushed = '[[supports]]\ngroup = "right"\nux = "-1.5*t"\nuy = "0"\n'
        self.expect(HELD + crushed + STATIC, "inside out", "turns element", "det F = ", "reference position (", "refine the mesh")

    def test_an_inverted_element_in_motion(self):
        crushed = '[[supports]]\ngroup = "right"\nux = "-150*t"\nuy = "0"\n'
        self.expect(HELD + crushed + DYNAMIC.format(dt=0.01), "step 1 from t = 0 s", "turns element", "inside out", "reference position (",
                    "smaller time step")

    def test_missing_supports(self):
        self.expect(PUSHED.format(size=1e3, factor="1") + STATIC, "singular matrix", "supports do not hold the body", "load factor",
                    "Add supports")

    def test_a_formula_without_a_value(self):
        self.expect(HELD + PUSHED.format(size=1e3, factor="1/(t - 0.02)") + DYNAMIC.format(dt=0.01), "solid.toml", "1/(t - 0.02)", "t = 0.02",
                    "no finite value", "step 1")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=Path, required=True)
    parser.parse_args(namespace=ARGUMENTS)
    unittest.main(argv=[sys.argv[0]], verbosity=2)
