# SPDX-License-Identifier: MIT
"""What the benches make of a run's timers and of Google Benchmark's file."""
import json
import sys
import tempfile
import tomllib
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

from bench_case import seconds  # noqa: E402
from bench_gate import shares  # noqa: E402
from bench_scaling import STEP_OVER_DX, write_tank  # noqa: E402
from run_benches import ratios  # noqa: E402


def timer(time: float, **inside) -> dict:
    return {"seconds": time, "calls": 1} | ({"inside": inside} if inside else {})


TIMERS = {
    "output": timer(2.0),
    "exchange": timer(10.0, **{"interface: wait for the solid": timer(6.0), "interface: send": timer(0.5),
                               "migration and halo": timer(3.0, **{"halo: wait for the state": timer(1.0)})}),
    "step": timer(50.0, **{"neighbours": timer(4.0), "neighbours in reach": timer(5.0), "halo: wait for gradients": timer(0.25),
                           "walls: find planes": timer(1.0), "pass 1: walls": timer(2.0), "pass 1: gradients": timer(8.0),
                           "pass 2: fluxes": timer(20.0), "stage": timer(3.0)}),
}


class Benches(unittest.TestCase):
    def test_what_is_inside_a_counted_timer_is_counted_once(self):
        self.assertEqual(seconds(TIMERS, lambda name: "halo" in name), 3.25)

    def test_shares_are_disjoint(self):
        self.assertEqual(shares(TIMERS), {"pairs": 28.0, "neighbours": 9.0, "halo": 3.25, "walls": 3.0, "output": 2.0, "stage": 3.0,
                                          "exchange": 1.0})

    def test_a_baseline_is_compared_with_the_same_arguments(self):
        runs = [{"name": "gate_factorisation_kept/4/40", "real_time": 2.0}, {"name": "gate_factorised_anew/4/40", "real_time": 5.0},
                {"name": "gate_factorised_anew/4/64", "real_time": 9.0}]
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "google.json")
            path.write_text(json.dumps({"benchmarks": runs}), encoding="utf-8")
            found = [json.loads(line) for line in ratios(path)]
        self.assertEqual([(figure["bench"], figure["value"]) for figure in found], [("gate_factorisation_kept/4/40", 2.5)])

    def test_a_tank_ends_within_its_last_step(self):
        with tempfile.TemporaryDirectory() as folder:
            tank = tomllib.loads((write_tank(Path(folder), 3, 0.0021544, 12) / "fluid.toml").read_text(encoding="utf-8"))
        dt = STEP_OVER_DX * tank["resolution"]["spacing"]
        self.assertTrue(11 * dt < tank["time"]["end"] < 12 * dt)
        self.assertEqual(round((tank["water"][0]["high"][0] / 0.0021544) ** 3), 46**3)


if __name__ == "__main__":
    unittest.main()
