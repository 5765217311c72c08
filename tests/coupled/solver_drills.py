# SPDX-License-Identifier: MIT
"""Ways a coupled run can go wrong, with sph_solver and fem_solver themselves on the small elastic gate.

usage: solver_drills.py NAME --programs BIN_FOLDER        (NAME: one of the functions below; "list" prints them)
"""
import os
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

from drill_tools import ENVIRONMENT, Run, Segment, drill_main

CASE = Path(__file__).resolve().parents[2] / "cases" / "elastic_gate_small" / "coupling.toml"
TWO_GATES = CASE.parents[1] / "two_gates" / "coupling.toml"
EVERY_STEP = ("coupling.output.table_interval=0",)


def fluid() -> Segment:
    return Segment("sph_solver", file=CASE)


def solid() -> Segment:
    return Segment("fem_solver", file=CASE)


def under_way(programs: Path, settings: tuple[str, ...] = ()) -> Run:
    run = Run(programs, [fluid(), solid()], (*EVERY_STEP, *settings))
    run.wait_for_rows("coupling/interface.csv", 10)
    return run


def solver_missing(programs):
    Run(programs, [fluid()]).finish().expect(4, "the participant 'solid' is missing", ": -n 1 fem_solver")


def solver_doubled(programs):
    Run(programs, [fluid(), solid(), fluid()]).finish().expect(2, "the role 'fluid' is doubled", "'fluid' (ranks 0, 2)")


def one_of_two_solids_missing(programs):
    run = Run(programs, [Segment("sph_solver", 2, TWO_GATES), Segment("fem_solver", 1, TWO_GATES, ("--as", "right"))])
    run.finish().expect(4, "the participant 'left' is missing", "mpirun -n 2 sph_solver", ": -n 1 fem_solver", "--as left", "--as right")


def one_of_two_solids_killed(programs):
    """The fluid and the solid that lives end with it."""
    run = Run(programs, [Segment("sph_solver", 1, TWO_GATES), *(Segment("fem_solver", 1, TWO_GATES, ("--as", role)) for role in ("left", "right"))],
              EVERY_STEP)
    run.wait_for_rows("coupling/interface.right.csv", 10)
    cause = run.kill("fem_solver", word="right")
    run.finish().expect(137, "the partner 'right' (rank", "vanished at t = ", cause=cause)


def solver_mistyped_group(programs):
    run = Run(programs, [fluid(), solid()], ('solid.interface.groups=["lefft"]',))
    run.finish().expect(2, "'solid' (rank 1", "lefft")


def solver_killed(programs):
    """Once with the solid, once with the fluid, in the middle of computing."""
    for program, role in (("fem_solver", "solid"), ("sph_solver", "fluid")):
        run = under_way(programs)
        cause = run.kill(program)
        run.finish().expect(137, f"the partner '{role}' (rank", "vanished at t = ", cause=cause)


def solver_stops_answering(programs):
    run = under_way(programs, ("coupling.coupling.silence_timeout=2",))
    cause = run.kill("fem_solver", how=signal.SIGSTOP)
    run.finish().expect(4, "'fluid' (rank 0", "for the motion from 'solid' (rank 1", "is silent", cause=cause, within=7)


def solver_does_not_converge(programs):
    run = Run(programs, [fluid(), solid()], ("solid.newton.max_iterations=1", "solid.newton.tolerance=1e-15"))
    run.finish().expect(3, "'solid' (rank 1", within=20)


def solver_asked_to_stop(programs):
    run = under_way(programs)
    cause = run.kill("fem_solver", how=signal.SIGUSR1)
    run.finish().expect(5, cause=cause, messages=0)


def solver_one_segment(programs):
    """As under `srun --multi-prog`: every rank has the same appnum, a wrapper picks the program by rank."""
    pick = f'if [ "$OMPI_COMM_WORLD_RANK" = 2 ]; then exec {programs}/fem_solver "$@"; else exec {programs}/sph_solver "$@"; fi'
    with tempfile.TemporaryDirectory() as folder:
        wrapped = ("sh", "-c", pick, "sh", str(CASE), "--out", folder, "--set", "coupling.time.end=0.002")
        Run(programs, [Segment(ranks=3, command=wrapped)]).finish().expect(0, within=60, messages=0)
        assert (Path(folder) / "summary.json").exists()


def check(program: Path, *settings: str) -> tuple[int, str]:
    """--check without mpirun: exit code and everything printed."""
    line = [str(program), str(CASE), "--check", *(word for setting in settings for word in ("--set", setting))]
    done = subprocess.run(line, env=os.environ | ENVIRONMENT, capture_output=True, text=True, timeout=60, check=False)
    print(done.stdout, done.stderr)
    return done.returncode, done.stdout + done.stderr


FLOW = ("fluid -> solid: force [N/m]", "solid -> fluid: velocity [m/s]", "solid brings the surface 'left': 40 facets",
        "fluid sets the step, dt = 6.15e-05 s", "rho c dt / m = 0.335", "the data flow is complete")


def solver_check_without_mpirun(programs):
    for program in ("sph_solver", "fem_solver"):
        code, text = check(programs / program)
        assert code == 0 and all(piece in text for piece in FLOW), f"{program} lacks {[p for p in FLOW if p not in text]}"
        code, text = check(programs / program, 'solid.interface.groups=["lefft"]')
        assert code == 2 and "'lefft'" in text, f"{program} does not name the group"
        code, text = check(programs / program, "solid.end=1")
        assert code == 2 and "end" in text, f"{program} does not name the key"


def solver_check_under_mpirun(programs):
    run = Run(programs, [Segment("sph_solver", ranks=2, file=CASE, arguments=("--check",)), Segment("fem_solver", file=CASE, arguments=("--check",))])
    run.finish().expect(0, *FLOW, messages=0)
    assert not run.out.exists()


if __name__ == "__main__":
    sys.exit(drill_main(globals(), __doc__))
