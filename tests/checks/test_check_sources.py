# SPDX-License-Identifier: MIT
"""The source check finds a missing licence, a file that is too long and an unfinished place."""
import unittest

from check_sources import LONGEST, check_text

LICENCE = "// SPDX-License-Identifier: MIT\n"


class SourceCheck(unittest.TestCase):
    def test_a_file_in_order(self):
        self.assertEqual(check_text("a.cpp", LICENCE + "int a;\n"), [])

    def test_findings(self):
        self.assertIn("a.cpp:1: the first line", check_text("a.cpp", "int a;\n")[0])
        self.assertIn("a.cpp:301: longer", check_text("a.cpp", LICENCE + "\n" * LONGEST)[0])
        self.assertIn("a.cpp:2: unfinished", check_text("a.cpp", LICENCE + "// TO" + "DO later\n")[0])


if __name__ == "__main__":
    unittest.main()
