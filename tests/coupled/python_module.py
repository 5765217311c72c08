# SPDX-License-Identifier: MIT
"""What the Python module does without a run: a participant's own file with its overrides, the tables that a solid leaves.

usage: python_module.py --build FOLDER [unittest's arguments]
"""
import sys
import types
import unittest
from pathlib import Path

import numpy as np

from coupled_run import InScratchFolder

BUILD = Path(sys.argv.pop(sys.argv.index("--build") + 1)).resolve()
sys.argv.remove("--build")
sys.path.insert(0, str(BUILD / "python"))

import rivage  # noqa: E402

SHARED = '[participants.solid]\nprogram = "gate.py"\nfile = "solid.toml"\n[participants.bare]\nprogram = "gate.py"\n'
OWN = '[material]\nE = 1.0\nlaw = "elastic"\n'


class OwnFile(InScratchFolder):
    def read(self, *overrides: str, role: str = "solid") -> dict:
        (self.folder / "coupling.toml").write_text(SHARED, encoding="utf-8")
        (self.folder / "solid.toml").write_text(OWN, encoding="utf-8")
        return rivage.read_own_file(self.folder / "coupling.toml", role, overrides)

    def test_the_role_s_overrides_and_no_others(self) -> None:
        self.assertEqual(self.read(), {"material": {"E": 1.0, "law": "elastic"}})
        changed = self.read("solid.material.E=2e6", "solid.material.law=rubber", "fluid.material.E=3", "coupling.time.end=1")
        self.assertEqual(changed, {"material": {"E": 2e6, "law": "rubber"}})

    def test_what_is_wrong_is_named(self) -> None:
        for words, overrides, role in (("material.nu", ["solid.material.nu=0.4"], "solid"), ("gravity.y", ["solid.gravity.y=1"], "solid"),
                                       ("names no file", [], "bare"), ("names no file", [], "nobody")):
            with self.assertRaisesRegex(rivage.Error, words) as caught:
                self.read(*overrides, role=role)
            self.assertEqual(caught.exception.code, 2)
        (self.folder / "solid.toml").write_text("[material", encoding="utf-8")
        with self.assertRaisesRegex(rivage.Error, "solid.toml"):
            rivage.read_own_file(self.folder / "coupling.toml", "solid")


class Normals(unittest.TestCase):
    def test_into_the_body_and_as_long_as_the_facet_is_large(self) -> None:
        corners = np.array([[0, 0, 0], [2, 0, 0], [2, 1, 0], [0, 1, 0]], float)     # counterclockwise seen from +z, outside
        for dimension, facet, wanted in ((3, [0, 1, 2, 3], (0, 0, -2)), (3, [0, 1, 2, -1], (0, 0, -1)), (2, [1, 0, -1, -1], (0, -2))):
            side = types.SimpleNamespace(facets=np.array([facet]), reference=corners[:, :dimension])
            np.testing.assert_allclose(rivage.Solid.inward(side, corners[:, :dimension])[0], wanted)


class Tables(InScratchFolder):
    def rows(self, interval: float) -> list[str]:
        """Of probes.csv, after ten windows of 0.03 s."""
        me = types.SimpleNamespace(role="gate", table_interval=interval, out=self.folder)
        tables = rivage.SolidTables(me, ["tip.ux[m]"])
        for step in range(-1, 10):
            tables.write(rivage.Window(step, 0.03 * max(step, 0), 0.03, step == 9), [step], kinetic=2.0, work=3.0)
        return (self.folder / "gate/probes.csv").read_text(encoding="utf-8").splitlines()

    def test_a_row_at_the_first_window_at_or_after_each_interval_and_at_the_end(self) -> None:
        self.assertEqual(self.rows(0.1), ["t[s],tip.ux[m]", "0,0", "0.12,4", "0.21,7", "0.27,9"])
        energies = (self.folder / "gate/energy.csv").read_text(encoding="utf-8").splitlines()
        self.assertEqual(energies[0], "t[s],kinetic[J/m],strain[J/m],potential[J/m],work_interface[J/m],work_loads[J/m],"
                                      "numerical_dissipation[J/m]")
        self.assertEqual(energies[1], "0,2,0,0,3,0,0")

    def test_every_window_where_no_interval_is_given(self) -> None:
        self.assertEqual(len(self.rows(0.0)), 11)

    def test_nothing_without_a_folder(self) -> None:
        rivage.SolidTables(types.SimpleNamespace(role="gate", table_interval=0.1, out=None), []).write(rivage.Window(0, 0, 1), [])
        self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    unittest.main()
