# SPDX-License-Identifier: MIT
"""Runs the benchmarks and collects what they print: one JSON object a line, as {"bench": ..., "metric": ..., "value": ...}.

usage: run_benches.py [NAME ...] --programs BIN_FOLDER [--json FILE]       (NAME: one of BENCHES; without: all of them)
"""
import argparse
import json
import os
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

ENVIRONMENT = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMP_NUM_THREADS": "1"}

# name: commands, each as (ranks, program); a program of one rank is started without mpirun and uses Google Benchmark
BENCHES = {
    "sph": [(1, "bench_sph_evaluation"), (1, "bench_neighbours")],
    "fem": [(1, "bench_fem")],
    "coupler": [(2, "bench_coupler"), (4, "bench_coupler")],
}
GOOGLES_OWN = {"family_index", "per_family_instance_index", "repetitions", "repetition_index", "threads", "iterations"}


def command_of(ranks: int, program: Path, results: Path) -> list[str]:
    if ranks == 1:
        return [str(program), f"--benchmark_out={results}", "--benchmark_out_format=json"]
    shared = ["--oversubscribe", "--mca", "mpi_yield_when_idle", "1"] if ranks > (os.cpu_count() or 1) else []
    return ["mpirun", "--bind-to", "none", *shared, "-n", str(ranks), str(program)]


def googles_figures(results: Path) -> list[str]:
    """Every number that Google Benchmark measured, one JSON line each; times in the unit that it names."""
    figures = []
    for bench in json.loads(results.read_text(encoding="utf-8"))["benchmarks"]:
        for metric, value in bench.items():
            if not isinstance(value, (int, float)) or metric in GOOGLES_OWN:
                continue
            name = f"{metric}_{bench['time_unit']}" if metric.endswith("_time") else metric
            figures.append(json.dumps({"bench": bench["name"], "metric": name, "value": value, "ranks": 1}) + "\n")
    return figures


def run(command: list[str]) -> list[str]:
    """Prints what the bench prints as it comes. Returns its JSON lines."""
    print(shlex.join(command), flush=True)
    figures = []
    with subprocess.Popen(command, env=os.environ | ENVIRONMENT, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          text=True) as process:
        for line in process.stdout:
            print(line, end="", flush=True)
            if line.startswith('{"bench"'):
                figures.append(line)
    if process.returncode != 0:
        sys.exit(f"run_benches: '{shlex.join(command)}' ended with code {process.returncode}")
    return figures


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", metavar="NAME", help=", ".join(BENCHES))
    parser.add_argument("--programs", type=Path, required=True)
    parser.add_argument("--json", type=Path)
    arguments = parser.parse_args()
    unknown = [name for name in arguments.names if name not in BENCHES]
    if unknown:
        parser.error(f"no bench '{unknown[0]}'; there are {', '.join(BENCHES)}")
    figures = []
    with tempfile.TemporaryDirectory(prefix="rivage_") as folder:
        results = Path(folder, "google.json")
        for ranks, program in (command for name in arguments.names or BENCHES for command in BENCHES[name]):
            figures += run(command_of(ranks, arguments.programs / program, results))
            figures += googles_figures(results) if ranks == 1 else []
    if arguments.json:
        arguments.json.write_text("".join(figures))
    return 0


if __name__ == "__main__":
    sys.exit(main())
