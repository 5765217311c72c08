# SPDX-License-Identifier: MIT
"""The files of docs/cluster as far as they can be tried without Slurm.

usage: cluster_files.py NAME --programs BIN_FOLDER        (NAME: one of the functions below; "list" prints them)
"""
import os
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

from drill_tools import ENVIRONMENT, drill_main

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / "docs" / "cluster"
SCRIPT, PROGRAMS, RANKS = FOLDER / "rivage.sbatch", FOLDER / "elastic_gate.conf", FOLDER / "rankfile"
SBATCH = {"job-name", "ntasks", "cpus-per-task", "time", "output"}


def lines(path: Path) -> list[str]:
    return [line for line in path.read_text().splitlines() if line and not line.startswith("#")]


def program_of_rank() -> dict[int, str]:
    """What srun --multi-prog makes of the list: "0-2 program arguments"; every rank once."""
    found = {}
    for line in lines(PROGRAMS):
        ranks, command = line.split(maxsplit=1)
        for part in ranks.split(","):
            first, last = (part.split("-") * 2)[:2]
            for rank in range(int(first), int(last) + 1):
                assert rank not in found, f"rank {rank} has two programs"
                found[rank] = command
    return found


def run(command: list[str], **others) -> str:
    print(shlex.join(command), flush=True)
    done = subprocess.run(command, cwd=ROOT, env=os.environ | ENVIRONMENT, capture_output=True, text=True, timeout=60, check=False, **others)
    print(done.stdout + done.stderr)
    assert done.returncode == 0, f"it ended with code {done.returncode}"
    return done.stdout


def cluster_script(programs):
    """Syntax, options, paths; the same ranks, case and folder for mpirun as in the list for srun."""
    text = SCRIPT.read_text()
    run(["bash", "-n", str(SCRIPT)])
    options = dict(re.findall(r"^#SBATCH --([a-z-]+)=(\S+)$", text, re.M))
    assert set(options) == SBATCH and len(options) == text.count("#SBATCH"), options
    wanted = program_of_rank()
    assert sorted(wanted) == list(range(int(options["ntasks"])))
    values = dict(re.findall(r"^(bin|case|out)=(\S+)$", text, re.M))
    assert (ROOT / values["case"]).is_file()
    assert re.search(r"--multi-prog (\S+)", text[text.index("srun --mpi=pmix"):])[1] == str(PROGRAMS.relative_to(ROOT))
    segments = re.findall(r'-n (\d+) (\w+) "\$case" --out "\$out"', text)
    by_mpirun = [f"{program} {values['case']} --out {values['out']}" for ranks, program in segments for _ in range(int(ranks))]
    assert by_mpirun == [wanted[rank] for rank in sorted(wanted)], by_mpirun
    assert all((programs / program).is_file() for _, program in segments)


def cluster_programs(programs):
    """The list through a wrapper that picks the program by rank, in one segment as srun does: all meet and agree."""
    wanted = program_of_rank()
    cases = " ".join(f"{rank}) exec {programs}/{command} --check ;;" for rank, command in wanted.items())
    text = run(["mpirun", "--oversubscribe", "--bind-to", "none", "-n", str(len(wanted)), "sh", "-c",
                f"case $OMPI_COMM_WORLD_RANK in {cases} esac"])
    assert "the data flow is complete" in text


def cluster_rankfile(programs):
    """mpirun takes the rankfile, with this machine in the place of the job's first node; where it has the cores named."""
    slots = [int(re.fullmatch(r"rank \d+=\+n0 slot=(\d+)", line)[1]) for line in lines(RANKS)]
    assert [line.split("=")[0] for line in lines(RANKS)] == [f"rank {rank}" for rank in range(len(slots))]
    if not set(slots) <= os.sched_getaffinity(0):
        print(f"cores {slots} are not all here: syntax only")
        return
    drill = Path(__file__).resolve().parent / "drill_case" / "coupling.toml"
    with tempfile.TemporaryDirectory() as out:
        here = Path(out) / "rankfile"
        here.write_text(RANKS.read_text().replace("=+n0", "=localhost"))
        run(["mpirun", "--rankfile", str(here), "-n", "1", str(programs / "fake_fluid"), str(drill), "--out", out, ":",
             "-n", "1", str(programs / "fake_solid"), str(drill), "--out", out])


if __name__ == "__main__":
    sys.exit(drill_main(globals(), __doc__))
