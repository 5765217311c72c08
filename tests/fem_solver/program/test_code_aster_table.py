# SPDX-License-Identifier: MIT
"""docs/for_code_aster_users.md: each key and value that its left columns name is one that `fem_solver --help-config` knows.

usage: test_code_aster_table.py --program FEM_SOLVER --page PAGE
"""
import argparse
import re
import subprocess
import sys
import unittest
from pathlib import Path

ARGUMENTS = argparse.Namespace()


def known_keys(text: str) -> dict[str, str]:
    """"table.key" of the solid's own file with the line that tells its type, default and choices."""
    keys, table = {}, ""
    for line in text.splitlines():
        if line.startswith("#") and keys:
            break                                       # coupling.toml's keys follow
        if header := re.match(r"\[+([^]]+)\]+", line):
            table = header[1]
        elif key := re.match(r"  (\w+) +(.*)", line):
            keys[f"{table}.{key[1]}"] = key[2]
    return keys


def named(page: str) -> list[tuple[str, str | None]]:
    """The (key, value or None) of the left column of every row."""
    cells = [line.split("|")[1] for line in page.splitlines() if line.startswith("| ")]
    code = [text for cell in cells for text in re.findall(r"`([^`]*)`", cell) if text != "solid.toml"]
    return [(key.strip(), value.strip() or None) for key, _, value in (text.partition("=") for text in code)]


class Table(unittest.TestCase):
    def setUp(self):
        help_text = subprocess.run([str(ARGUMENTS.program), "--help-config"], capture_output=True, text=True, check=True).stdout
        self.known, self.named = known_keys(help_text), named(ARGUMENTS.page.read_text(encoding="utf-8"))

    def test_every_key_exists_and_every_value_is_a_choice(self):
        self.assertGreater(len(self.named), 50)
        for key, value in self.named:
            self.assertIn(key, self.known, f"{key} is no key of solid.toml")
            if value and value.startswith('"'):
                self.assertIn(value.strip('"'), re.split(r"[,| ]+", self.known[key]), f"{value} is no choice of {key}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=Path, required=True)
    parser.add_argument("--page", type=Path, required=True)
    parser.parse_args(namespace=ARGUMENTS)
    unittest.main(argv=[sys.argv[0]], verbosity=2)
