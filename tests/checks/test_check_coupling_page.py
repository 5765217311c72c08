# SPDX-License-Identifier: MIT
"""The check of docs/coupling.md finds what it is for: each test plants one fault in a small tree that is clean otherwise."""
import tempfile
import unittest
from pathlib import Path

from check_coupling_page import faults

SOURCE = 'base::require_input(fits, "the fork does not fit", name,\n    " its socket: turn it");\n'
PAGE = "| 2 | `does not fit… its socket` | turn it |\n```cpp\n#include <one>\n```\n"
EXAMPLE = "// a comment\n#include <one>\n"
MODULE = """raise Error(2, f"the cup '{name}' is not on its saucer")\n"""
OWN_PAGE = "| 2 | `is not on its saucer` | put it there |\n"


class CouplingPage(unittest.TestCase):
    def findings(self, source: str = SOURCE, page: str = PAGE, example: str = EXAMPLE, module: str = MODULE,
                 own_page: str = OWN_PAGE) -> list[str]:
        with tempfile.TemporaryDirectory() as name:
            root = Path(name)
            for path, text in (("coupler_lib/coupling/fork.cpp", source), ("docs/coupling.md", page), ("tests/coupled/own_solid.cpp", example),
                               ("coupler_lib/python/rivage/cup.py", module), ("docs/couple_your_own_solver.md", own_page)):
                (root / path).parent.mkdir(parents=True, exist_ok=True)
                (root / path).write_text(text, encoding="utf-8")
            return faults(root)

    def test_a_clean_tree_has_no_findings(self):
        self.assertEqual(self.findings(), [])

    def test_an_error_that_the_page_lacks(self):
        found = self.findings(source=SOURCE + 'throw base::Error(code, "the spoon is (much) too large");\n')
        self.assertEqual(len(found), 1)
        self.assertIn("the spoon is (much) too large", found[0])

    def test_an_error_of_the_module_that_its_page_lacks(self):
        found = self.findings(module=MODULE + "raise ValueError('there is no milk left')\n")
        self.assertEqual(len(found), 1)
        self.assertIn("couple_your_own_solver.md lacks the error 'there is no milk left'", found[0])
        self.assertIn("no source says", self.findings(module="")[0])

    def test_a_phrase_that_no_source_says(self):
        found = self.findings(page=PAGE + "| 3 | `the knife is blunt` | grind it |\n")
        self.assertEqual(len(found), 1)
        self.assertIn("the knife is blunt", found[0])

    def test_an_example_that_is_not_the_program(self):
        self.assertIn("example", self.findings(example=EXAMPLE + "int main() {}\n")[0])


if __name__ == "__main__":
    unittest.main()
