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

# name: commands, each as (ranks, program) or a Python script of this folder that starts what it needs; a program of one rank
# is started without mpirun and uses Google Benchmark
BENCHES = {
    "sph": [(1, "bench_sph_evaluation"), (1, "bench_neighbours")],
    "fem": [(1, "bench_fem"), "bench_block.py"],
    "coupler": [(2, "bench_coupler"), (4, "bench_coupler")],
    "gate": ["bench_gate.py"],
    "scaling": ["bench_scaling.py"],
}
BASELINES = {"gate_factorisation_kept": "gate_factorised_anew"}       # with the same arguments, in the same run
GOOGLES_OWN = {"family_index", "per_family_instance_index", "repetitions", "repetition_index", "threads", "iterations"}


def command_of(entry, tests: Path, results: Path) -> list[str]:
    if isinstance(entry, str):
        return [sys.executable, str(Path(__file__).parent / entry), "--programs", str(tests.parents[1] / "bin"), "--tests", str(tests)]
    ranks, program = entry[0], tests / entry[1]
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


def ratios(results: Path) -> list[str]:
    """How many times slower the baseline is than what it is the baseline of, one JSON line each."""
    times = {bench["name"]: bench["real_time"] for bench in json.loads(results.read_text(encoding="utf-8"))["benchmarks"]
             if bench.get("run_type") != "aggregate"}
    figures = []
    for name, time in times.items():
        family, *rest = name.split("/")
        baseline = "/".join([BASELINES.get(family, ""), *rest])
        if baseline in times:
            figures.append(json.dumps({"bench": name, "metric": f"times_faster_than_{BASELINES[family]}",
                                       "value": round(times[baseline] / time, 3), "ranks": 1}) + "\n")
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
        for entry in (entry for name in arguments.names or BENCHES for entry in BENCHES[name]):
            results.unlink(missing_ok=True)
            figures += run(command_of(entry, arguments.programs, results))
            if results.exists():
                compared = ratios(results)
                print("".join(compared), end="", flush=True)
                figures += googles_figures(results) + compared
    if arguments.json:
        arguments.json.write_text("".join(figures))
    return 0


if __name__ == "__main__":
    sys.exit(main())
