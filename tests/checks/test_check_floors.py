# SPDX-License-Identifier: MIT
"""The floor check finds what it is for: each test plants one violation in a small tree that is clean otherwise."""
import tempfile
import unittest
from pathlib import Path

from check_floors import check

CLEAN = {
    "coupler_lib/layers.txt": "foundation\ncoupling base\nsession\n",
    "coupler_lib/foundation/check.hpp": "#include <mpi.h>\n",
    "coupler_lib/base/log.hpp": '#include <spdlog/spdlog.h>\n#include "coupler_lib/foundation/check.hpp"\n',
    "coupler_lib/coupling/surface.hpp": '#include "coupler_lib/foundation/check.hpp"\n',
    "coupler_lib/session/session.hpp": '#include "coupler_lib/base/log.hpp"\n',
    "sph_solver/layers.txt": "numerics\nstate walls\ntime\n",
    "sph_solver/numerics/kernel.hpp": "#include <Eigen/Dense>\n",
    "sph_solver/numerics/kernel.cpp": '#include "kernel.hpp"\n',
    "sph_solver/state/particles.hpp": '#include "sph_solver/numerics/kernel.hpp"\n',
    "sph_solver/walls/wall.hpp": '#include "coupler_lib/coupling/surface.hpp"\n',
    "sph_solver/time/step.hpp": '#include "sph_solver/state/particles.hpp"\n',
    "sph_solver/main.cpp": '#include "sph_solver/time/step.hpp"\n',
    "fem_solver/layers.txt": "element\n",
    "fem_solver/element/shape.hpp": "",
}


class FloorCheck(unittest.TestCase):
    def findings(self, planted: dict[str, str]) -> list[str]:
        with tempfile.TemporaryDirectory() as name:
            root = Path(name).resolve()
            for path, text in (CLEAN | planted).items():
                (root / path).parent.mkdir(parents=True, exist_ok=True)
                (root / path).write_text(text, encoding="utf-8")
            return check(root)

    def expect(self, planted: dict[str, str], place: str, words: str) -> None:
        found = self.findings(planted)
        self.assertEqual(len(found), 1, found)
        self.assertTrue(found[0].startswith(place), found)
        self.assertIn(words, found[0])

    def test_clean_tree_passes(self):
        self.assertEqual(self.findings({}), [])

    def test_upwards(self):
        self.expect({"sph_solver/numerics/kernel.hpp": '#pragma once\n#include "sph_solver/time/step.hpp"\n'},
                    "sph_solver/numerics/kernel.hpp:2:", "upwards")

    def test_sideways(self):
        self.expect({"sph_solver/state/particles.hpp": '#include "sph_solver/walls/wall.hpp"\n'},
                    "sph_solver/state/particles.hpp:1:", "sideways")

    def test_sideways_by_a_relative_path(self):
        self.expect({"sph_solver/state/particles.hpp": '#include "../walls/wall.hpp"\n'},
                    "sph_solver/state/particles.hpp:1:", "sideways")

    def test_solvers_never_see_each_other(self):
        self.expect({"sph_solver/time/step.hpp": '#include "fem_solver/element/shape.hpp"\n'},
                    "sph_solver/time/step.hpp:1:", "sph_solver must not include fem_solver")
        self.expect({"coupler_lib/session/session.hpp": '#include "sph_solver/numerics/kernel.hpp"\n'},
                    "coupler_lib/session/session.hpp:1:", "coupler_lib must not include sph_solver")

    def test_coupling_needs_foundation_and_mpi_alone(self):
        self.expect({"coupler_lib/coupling/surface.hpp": '#include "coupler_lib/base/log.hpp"\n'},
                    "coupler_lib/coupling/surface.hpp:1:", "sideways")
        self.expect({"coupler_lib/coupling/surface.hpp": "#include <toml++/toml.h>\n"},
                    "coupler_lib/coupling/surface.hpp:1:", "MPI alone")

    def test_folder_without_a_floor(self):
        self.expect({"sph_solver/extra/file.hpp": ""}, "", "no floor for the folder extra")

    def test_include_of_a_missing_file(self):
        self.expect({"sph_solver/walls/wall.hpp": '#include "sph_solver/walls/gone.hpp"\n'},
                    "sph_solver/walls/wall.hpp:1:", "there is no file")


if __name__ == "__main__":
    unittest.main()
