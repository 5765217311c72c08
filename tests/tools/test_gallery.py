# SPDX-License-Identifier: MIT
"""The gallery's page is the one that gallery.py writes, and its links lead somewhere."""
import re
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "cases/tools"))

from gallery import DOCS, page  # noqa: E402


class Gallery(unittest.TestCase):
    def test_page_is_up_to_date(self):
        self.assertEqual((DOCS / "gallery.md").read_text(encoding="utf-8"), page(), "run cases/tools/gallery.py")

    def test_links_lead_somewhere(self):
        for link in re.findall(r"\]\(((?!http)[^)#]+)", page()):
            self.assertTrue((DOCS / link).exists(), link)


if __name__ == "__main__":
    unittest.main()
