# SPDX-License-Identifier: MIT
"""The start of the elastic gate on 1+1 and 2+1 ranks: time, steps, and the shares of the fluid's time, waiting apart.

usage: bench_gate.py --programs BIN_FOLDER --tests TEST_BIN_FOLDER [--end SECONDS]

Times are those of fluid rank 0 and of solid rank 0. With more ranks than cores a halo's or an exchange's time holds waiting for
the core too. `whole_gate_estimate_s` takes as many steps a second to 0.4 s as up to the end of this run, with the same dt.
"""
import argparse
import tempfile
from pathlib import Path

from bench_case import ROOT, figure, seconds, summary_of

WAIT = "interface: wait for the solid"
HALO = ("migration and halo", "halo: wait for the state", "halo: wait for gradients")
PAIRS = ("pass 1: gradients", "pass 1: finish", "pass 2: fluxes")
WHOLE = 0.4          # [s]


def shares(timers: dict) -> dict[str, float]:
    """Seconds of the fluid's parts, without waiting; `exchange` without what the halo does inside it."""
    def part(*names: str) -> float:
        return seconds(timers, lambda name: name in names)

    halo_in_exchange = seconds(timers["exchange"]["inside"], lambda name: name in HALO)
    parts = {
        "pairs": part(*PAIRS),
        "neighbours": part("neighbours", "neighbours in reach"),
        "halo": part(*HALO),
        "walls": seconds(timers, lambda name: name.startswith("walls:") or name.endswith(": walls")),
        "output": part("output"),
        "stage": part("stage"),
        "exchange": timers["exchange"]["seconds"] - seconds(timers["exchange"]["inside"], lambda name: name == WAIT)
                    - halo_in_exchange,
    }
    return parts


def report(bench: str, ranks: int, summary: dict, end: float) -> None:
    fluid, solid = summary["fluid"], summary["solid"]
    steps, waited = fluid["steps"], seconds(fluid["timers"], lambda name: name == WAIT)
    busy = fluid["wall_s"] - waited
    for metric, value in (("wall_s", fluid["wall_s"]), ("steps", steps),
                          ("fluid_ms_per_step", 1e3 * busy / steps),
                          ("solid_ms_per_step", 1e3 * seconds(solid["timers"], lambda name: name == "step") / steps),
                          ("fluid_waits_share_of_wall", waited / fluid["wall_s"]),
                          ("solid_waits_share_of_wall", solid["wait_share"]),
                          ("whole_gate_estimate_s", fluid["wall_s"] * WHOLE / end),
                          ("fluid_peak_memory_MB", fluid["peak_memory_per_rank_MB"]),
                          ("solid_peak_memory_MB", solid["peak_memory_per_rank_MB"])):
        figure(bench, metric, value, ranks)
    parts = shares(fluid["timers"])
    parts["rest"] = busy - sum(parts.values())
    for name, value in parts.items():
        figure(bench, f"fluid_share_{name}", value / busy, ranks)
    besides = sum(parts[name] for name in ("neighbours", "halo", "walls", "output"))
    figure(bench, "fluid_share_neighbours_halo_walls_output", besides / busy, ranks)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--programs", type=Path, required=True)
    parser.add_argument("--tests", type=Path, help="not used")
    parser.add_argument("--end", type=float, default=0.02)
    told = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="rivage_") as folder:
        for fluid_ranks in (1, 2):
            summary = summary_of(ROOT / "cases/elastic_gate", told.programs, Path(folder, "gate"), (fluid_ranks, 1),
                                 [f"coupling.time.end={told.end}"], 200)
            report(f"gate_{fluid_ranks}+1", fluid_ranks + 1, summary, told.end)


if __name__ == "__main__":
    main()
