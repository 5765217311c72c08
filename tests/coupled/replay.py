# SPDX-License-Identifier: MIT
"""Record and replay: each side alone on the recording gives the bits of the coupled run; changed input is noticed; cut and
wrong recordings are named.

usage: replay.py --programs BIN [unittest's arguments]
"""
import argparse
import json
import os
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

from coupled_run import ENVIRONMENT, ROOT, InScratchFolder

ARGUMENTS = argparse.Namespace()
GATE = ROOT / "cases" / "elastic_gate_small" / "coupling.toml"
FAKES = ROOT / "tests" / "coupled" / "drill_case" / "coupling.toml"
PROGRAMS = {GATE: {"fluid": "sph_solver", "solid": "fem_solver"}, FAKES: {"fluid": "fake_fluid", "solid": "fake_solid"}}


def start(line: list[str]) -> subprocess.Popen:
    return subprocess.Popen(line, env=os.environ | ENVIRONMENT, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, text=True)


def finish(process: subprocess.Popen) -> tuple[int, str]:
    said, _ = process.communicate(timeout=120)
    return process.returncode, said


def mpirun(*segments: tuple[int, list[str]]) -> list[str]:
    line = ["mpirun", "--oversubscribe", "--bind-to", "none", "--mca", "mpi_yield_when_idle", "1"]
    for k, (ranks, command) in enumerate(segments):
        line += ([":"] if k > 0 else []) + ["-n", str(ranks), *command]
    return line


def options(sets: tuple[str, ...], out: Path) -> list[str]:
    return ["--out", str(out)] + [word for key in sets for word in ("--set", key)]


def side(case: Path, role: str) -> list[str]:
    return [str(ARGUMENTS.programs / PROGRAMS[case][role]), str(case)]


def recording(case: Path, out: Path, ranks: dict[str, int], *sets: str) -> list[str]:
    sets += ('coupling.coupling.record="traffic.h5"',)
    return mpirun(*((ranks[role], side(case, role) + options(sets, out)) for role in ("fluid", "solid")))


def summary(out: Path, role: str) -> dict:
    return json.loads((out / role / "summary.json").read_text(encoding="utf-8"))


class Replay(InScratchFolder):
    def record(self, case: Path, ranks: dict[str, int], *sets: str) -> Path:
        out = self.folder / "recorded"
        code, said = finish(start(recording(case, out, ranks, *sets)))
        self.assertEqual(code, 0, said)
        return out

    def replay(self, case: Path, role: str, recorded: Path, ranks: int, *sets: str) -> tuple[int, str, Path]:
        out = self.folder / f"replayed_{role}"
        line = mpirun((ranks, side(case, role) + options(sets, out) + ["--replay", str(recorded / "traffic.h5")]))
        return *finish(start(line)), out

    def both_sides_repeat(self, case: Path, ranks: dict[str, int], *sets: str) -> None:
        recorded = self.record(case, ranks, *sets)
        for role in ("fluid", "solid"):
            code, said, out = self.replay(case, role, recorded, ranks[role], *sets)
            self.assertEqual(code, 0, said)
            self.assertIn("to the bit", said)
            then, now = summary(recorded, role), summary(out, role)
            self.assertFalse(now["replay_differs"])
            self.assertGreater(now["replayed_packets"], 50)
            for key in ("state_hash", "loads_hash"):
                self.assertEqual(then.get(key), now.get(key), key)

    def test_the_gate_repeats_to_the_bit(self) -> None:
        self.both_sides_repeat(GATE, {"fluid": 1, "solid": 1}, "coupling.time.end=0.005")

    def test_the_gate_on_two_fluid_ranks_repeats_to_the_bit(self) -> None:
        self.both_sides_repeat(GATE, {"fluid": 2, "solid": 1}, "coupling.time.end=0.005")

    def test_the_fakes_repeat_to_the_bit(self) -> None:
        self.both_sides_repeat(FAKES, {"fluid": 2, "solid": 2})

    def test_a_stiffer_solid_is_seen_to_differ(self) -> None:
        recorded = self.record(GATE, {"fluid": 1, "solid": 1}, "coupling.time.end=0.003")
        code, said, out = self.replay(GATE, "solid", recorded, 1, "coupling.time.end=0.003", "solid.material.rubber.E=13e6")
        self.assertEqual(code, 0, said)
        self.assertIn("differs from the recording from step", said)
        self.assertTrue(summary(out, "solid")["replay_differs"])

    def test_a_killed_run_is_replayed_as_far_as_it_went(self) -> None:
        out = self.folder / "killed"
        process = start(recording(GATE, out, {"fluid": 1, "solid": 1}, "coupling.time.end=0.1"))
        file = out / "traffic.solid.fluid.0.h5"
        until = time.monotonic() + 60
        while time.monotonic() < until and not (file.exists() and file.stat().st_size > 1_500_000):
            time.sleep(0.05)
        for line in subprocess.run(["ps", "-eo", "pid,args"], capture_output=True, text=True, check=True).stdout.splitlines():
            if str(out) in line and ("fem_solver" in line or "sph_solver" in line) and "mpirun" not in line:
                os.kill(int(line.split()[0]), signal.SIGKILL)
        finish(process)
        code, said, _ = self.replay(GATE, "solid", out, 1, "coupling.time.end=0.1")
        self.assertEqual(code, 4, said)
        self.assertIn("ends after", said)
        self.assertIn("cut short", said)

    def test_what_cannot_be_replayed_is_named(self) -> None:
        recorded = self.record(FAKES, {"fluid": 1, "solid": 2})
        code, said, _ = self.replay(FAKES, "solid", recorded, 1)
        self.assertEqual(code, 2, said)
        self.assertIn("recorded by 2 ranks", said)
        code, said, _ = self.replay(FAKES, "fluid", self.folder / "nowhere", 1)
        self.assertEqual(code, 2, said)
        self.assertIn("cannot read the recording", said)
        (recorded / "traffic.fluid.solid.0.h5").write_bytes(b"no recording at all" * 100)
        code, said, _ = self.replay(FAKES, "fluid", recorded, 1)
        self.assertEqual(code, 2, said)
        self.assertIn("cannot read the recording", said)
        (recorded / "traffic.solid.fluid.0.h5").rename(recorded / "traffic.fluid.solid.0.h5")
        code, said, _ = self.replay(FAKES, "fluid", recorded, 1)
        self.assertEqual(code, 2, said)
        self.assertIn("holds the traffic of 'solid'", said)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--programs", type=Path, required=True)
    ARGUMENTS, rest = parser.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest])
