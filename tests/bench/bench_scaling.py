# SPDX-License-Identifier: MIT
"""Scale of the fluid: 1 -> 2 ranks, cost of a particle's step from 1e4 to 1e6 particles, memory a particle, counts of cuts.

usage: bench_scaling.py --programs BIN_FOLDER --tests TEST_BIN_FOLDER

The ranks are compared on the dam break in space with 216,000 particles. The closed tanks are at rest, where neighbour lists are hardly
ever remade, on one rank. Time is that of the timer "step" of rank 0; memory is the peak resident memory of a tank less that of the
smallest, over the particles it has more. Every run is made once: on a busy machine only counts and memory hold.
"""
import argparse
import os
import subprocess
import tempfile
from pathlib import Path

from bench_case import ENVIRONMENT, ROOT, figure, seconds, summary_of

QUIET = ["fluid.output.interval=0", "fluid.output.table_interval=1.0"]
STEP_OVER_DX = 0.6 * 1.23 / 30.0             # [s/m] dt = cfl h / c0 of the tanks
# dx [m] and steps of a tank 0.1 m long and 0.1 m deep, in space also 0.1 m wide: 1e4, 1e5 and 1e6 particles
TANKS = {2: [(0.001, 200), (0.00031623, 40), (0.0001, 10)], 3: [(0.0047, 60), (0.0021544, 12), (0.001, 6)]}
DAM_STEPS, DAM_DT = 20, 0.6 * 1.23 * 0.005 / 35.0
TANK = """[domain]
dimension = {dimension}
gravity = {gravity}
[time]
end = {end}
cfl = 0.6
[resolution]
spacing = {dx}
smoothing_ratio = 1.23
[fluid]
density = 1000.0
sound_speed = 30.0
[[water]]
shape = "box"
low = {low}
high = {high}
[initial]
state = "hydrostatic"
level = 0.1
[[walls]]
name = "tank"
shape = "box"
low = {low}
high = {top}
[output]
interval = 0
table_interval = 1.0
"""


def write_tank(folder: Path, dimension: int, dx: float, steps: int) -> Path:
    """A case of still water whose sides are whole numbers of dx near 0.1 m; the level stays 0.1 m."""
    folder.mkdir(parents=True, exist_ok=True)
    across = dimension - 1
    side = round(0.1 / dx) * dx
    text = TANK.format(dimension=dimension, gravity=[0.0] * across + [-9.81], end=(steps - 0.5) * STEP_OVER_DX * dx, dx=dx,
                       low=[0.0] * dimension, high=[side] * dimension, top=[side] * across + [0.15])
    (folder / "fluid.toml").write_text(text, encoding="utf-8")
    return folder


def step_seconds(fluid: dict) -> float:
    return seconds(fluid["timers"], lambda name: name == "step") / fluid["steps"]


def measure_ranks(programs: Path, out: Path) -> None:
    times = {}
    for ranks in (1, 2):
        fluid = summary_of(ROOT / "cases/dam_break/lobovsky_3d", programs, out, (ranks, 1),
                           [*QUIET, f"fluid.time.end={DAM_STEPS * DAM_DT}"], 200)["fluid"]
        times[ranks] = step_seconds(fluid)
        figure("scaling_dam_break_3d", "particles", fluid["particles"], ranks)
        figure("scaling_dam_break_3d", "steps", fluid["steps"], ranks)
        figure("scaling_dam_break_3d", "s_per_step", times[ranks], ranks)
        figure("scaling_dam_break_3d", "peak_memory_per_rank_MB", fluid["peak_memory_per_rank_MB"], ranks)
    figure("scaling_dam_break_3d", "faster_than_one_rank", times[1] / times[2], 2)


def measure_tanks(programs: Path, folder: Path) -> None:
    for dimension, tanks in TANKS.items():
        bench, smallest = f"scaling_tank_{dimension}d", None
        for dx, steps in tanks:
            case = write_tank(folder / "tank", dimension, dx, steps)
            fluid = summary_of(case, programs, folder / "run", (1, 1), [], 200)["fluid"]
            count, memory = fluid["particles"], fluid["peak_memory_per_rank_MB"]
            smallest = smallest or (count, memory)
            figure(bench, "particles", count, 1)
            figure(bench, "us_per_particle_step", 1e6 * step_seconds(fluid) / count, 1)
            figure(bench, "peak_memory_MB", memory, 1)
            if count > smallest[0]:
                figure(bench, "bytes_per_particle_more", (memory - smallest[1]) * 2**20 / (count - smallest[0]), 1)


def count_cuts(tests: Path) -> None:
    for ranks in (4, 8, 16, 32):
        line = ["mpirun", "--oversubscribe", "--bind-to", "none", "--mca", "mpi_yield_when_idle", "1", "-n", str(ranks),
                str(tests / "count_cuts"), "58"]
        subprocess.run(line, env=os.environ | ENVIRONMENT, stdin=subprocess.DEVNULL, check=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--programs", type=Path, required=True)
    parser.add_argument("--tests", type=Path, required=True)
    told = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="rivage_") as folder:
        measure_ranks(told.programs, Path(folder, "run"))
        measure_tanks(told.programs, Path(folder))
        count_cuts(told.tests)


if __name__ == "__main__":
    main()
