# SPDX-License-Identifier: MIT
"""Runs what verification asks of the cases, judges it, and writes docs/verification.md's tables.

usage: verify.py [CASE ...] [--programs BIN_FOLDER] [--run NAME ...] [--json FILE] [--out FOLDER] [--keep-page] [--test] [--page]

Nothing is cached: every run is made anew, under runs/verify. Without a case: all of them; a group's name (`solid`) stands for its cases. `--run` makes only the runs of that
name, whose rows alone are renewed then; `--test` the small siblings alone, for ctest; `--page` runs nothing and renews the page, with the causes of misses as they
stand in expect.toml now. Ends with 1 when a judged figure misses, 2 for bad input.
"""
import argparse
import json
import re
import shutil
import sys
import time
import tomllib
from pathlib import Path

from check_expectations import line
from convergence import check_convergence, spacing
from energy import write_energy_total
from expectations import Finding, check, is_meant
from launch import run as launch, run_tests as launch_tests
from run_folder import RunFolder
from verify_page import write_page
from verify_plan import CASES, PlannedRun, find_cases, group_of, plan, title

ROOT = Path(__file__).resolve().parents[2]


def made(planned: PlannedRun, programs: Path, out: Path) -> tuple[RunFolder, dict]:
    """Makes a run in a fresh folder; returns it with what every record of it carries."""
    shutil.rmtree(out, ignore_errors=True)
    start = time.monotonic()
    if planned.test_program:
        code = launch_tests(programs.parent / "tests/bin" / planned.test_program, planned.filter, out)
    else:
        code = launch((planned.folder / planned.inputs).resolve(), programs, out, planned.ranks, planned.settings, timeout=None)
    run = RunFolder(out)
    write_energy_total(run)
    facts = {"run": planned.name, "wall_s": round(time.monotonic() - start, 1), "exit_code": code}
    sides = [part for part in run.summary().values() if isinstance(part, dict) and "ranks" in part]
    facts["ranks"] = "+".join(str(part["ranks"]) for part in sides)
    facts["commit"] = next((part["commit"] for part in sides if "commit" in part), "")
    try:
        facts["dx"] = spacing(run)
    except (OSError, KeyError, ValueError):
        pass
    return run, facts


def judged_run(planned: PlannedRun, run: RunFolder, facts: dict) -> list[Finding]:
    """The findings of one run; one that ended badly misses everything that is expected of it."""
    name = title(planned.folder)
    findings = check(run, planned.folder, planned.names, name)
    if facts["exit_code"] != 0:
        for finding in findings:
            finding.value, finding.reason = None, f"the run ended with exit code {facts['exit_code']}"
        findings = findings or [Finding(name, {"quantity": "exit_code", "high": 0}, float(facts["exit_code"]))]
    return findings


def is_awaited(planned: PlannedRun) -> bool:
    """Whether expect.toml asks anything of a run of that name."""
    path = planned.folder / "expect.toml"
    entries = tomllib.loads(path.read_text(encoding="utf-8")).get("expect", []) if path.exists() else []
    return any(is_meant(entry, planned.names) for entry in entries)


def verify_case(folder: Path, chosen, arguments) -> list[dict]:
    """Makes the runs of one case and prints a line a figure; the records of all its figures."""
    records, runs = [], {}
    group = {"group": group_of(folder)} if group_of(folder) else {}

    def take(findings: list[Finding], facts: dict) -> None:
        for finding in findings:
            print(line(finding), flush=True)
            records.append(finding.as_record() | facts | group)

    for planned in chosen:
        out = arguments.out / title(folder) / re.sub(r"[^\w.+-]+", "_", planned.name)
        print(f"== {title(folder)}: {planned.name}", flush=True)
        run, facts = made(planned, arguments.programs, out)
        runs[planned.name] = run
        take(judged_run(planned, run, facts), facts)
    if not (arguments.test or arguments.names):
        take(check_convergence(folder, title(folder), runs), {"run": "all"})
    return records


def parse() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("cases", nargs="*")
    parser.add_argument("--programs", type=Path, default=ROOT / "build/release/bin")
    parser.add_argument("--run", action="append", default=[], dest="names")
    parser.add_argument("--json", type=Path)
    parser.add_argument("--out", type=Path, default=ROOT / "runs/verify")
    parser.add_argument("--keep-page", action="store_true", help="leave docs/verification.md as it is")
    parser.add_argument("--page", action="store_true", help="run nothing, renew docs/verification.md")
    parser.add_argument("--test", action="store_true", help="the small siblings alone; the page stays as it is")
    return parser.parse_args()


def main() -> int:
    arguments = parse()
    if arguments.page:
        write_page(ROOT / "docs", [])
        return 0
    try:
        work = []
        for folder in find_cases(arguments.cases):
            chosen = [planned for planned in plan(folder) if planned.test == arguments.test
                      and (is_awaited(planned) or not planned.test)
                      and (not arguments.names or planned.name in arguments.names)]
            work += [(folder, chosen)] if chosen else []
    except ValueError as error:
        print(f"verify: {error}", file=sys.stderr)
        return 2
    if not work:
        print("verify: no run has that name", file=sys.stderr)
        return 2
    records = []
    for folder, chosen in work:
        records += verify_case(folder, chosen, arguments)
        if arguments.json:
            arguments.json.write_text("".join(json.dumps(record) + "\n" for record in records), encoding="utf-8")
        if not (arguments.keep_page or arguments.test) and folder.is_relative_to(CASES):
            write_page(ROOT / "docs", records, some_runs=bool(arguments.names))
    if not records:
        print("verify: nothing is expected of these runs", file=sys.stderr)
        return 2
    misses = [record for record in records if record["judged"] and not record["pass"]]
    print(f"{len(records)} figures, {len(misses)} misses" + "".join(f"\n  {m['case']}: {m['quantity']}" for m in misses))
    return 1 if misses else 0


if __name__ == "__main__":
    sys.exit(main())
