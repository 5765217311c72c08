# SPDX-License-Identifier: MIT
"""The check of joined builds finds the same private name in two sources of a folder, and nothing else."""
import contextlib
import io
import tempfile
import unittest
from pathlib import Path

from check_unity import main, private_names

SOURCE = """// namespace { int commented; }
#define LOUD 1
namespace fem {
namespace {

using Rows = std::vector<int>;
constexpr double pi[2] = {3.14, "namespace { int quoted; }"[0]};
template<int D, class T> struct Table : Base<T> { int member; void inside(); };
std::vector<int> sums(const Rows& rows)
{
    int local = 0;
    return {local};
}

TEST(Suite, Case) { EXPECT_EQ(1, 1); }

} // namespace

static int quiet(int a) { return a; }
void Open::method() { int b; }
double free_to_all(double x) { return x; }
} // namespace fem
"""


def findings(files: dict[str, str]) -> str:
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            path = Path(folder, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        with contextlib.redirect_stdout(io.StringIO()) as out:
            status = main(Path(folder))
        return out.getvalue().strip() if status else ""


class UnityCheck(unittest.TestCase):
    def test_private_names_and_their_lines(self):
        self.assertEqual(private_names(SOURCE), {"LOUD": 2, "Rows": 6, "pi": 7, "Table": 8, "sums": 9, "Suite.Case": 15,
                                                 "quiet": 19})

    def test_overloads_of_two_sources_are_found(self):
        one, other = "namespace {\nint size(int a) { return a; }\n}\n", "namespace {\nint size(long a) { return 2; }\n}\n"
        self.assertEqual(findings({"fem_solver/a/x.cpp": one, "fem_solver/a/y.cpp": other}),
                         "fem_solver/a/y.cpp:2: size is private to fem_solver/a/x.cpp:2 too")

    def test_other_folders_and_programs_of_one_source_are_free(self):
        one = "namespace {\nint size;\n}\n"
        self.assertEqual(findings({"fem_solver/a/x.cpp": one, "fem_solver/b/x.cpp": one}), "")
        self.assertEqual(findings({"tests/bench/x.cpp": one, "tests/bench/y.cpp": one}), "")


if __name__ == "__main__":
    unittest.main()
