# SPDX-License-Identifier: MIT
"""Every way a coupled run can go wrong, through mpirun: exit code, message, time from the cause to the end.

usage: drills.py NAME --programs BIN_FOLDER        (NAME: one of the functions below; "list" prints them)
"""
import os
import shutil
import signal
import sys
import tempfile
from pathlib import Path

from drill_tools import CASE, Run, Segment, drill_main, fluid, side_by_side, solid

SLOW = ("fluid.run.sleep=0.005", "coupling.time.end=1000")  # runs on until something happens


def under_way(programs: Path, fluids: int = 1, solids: int = 1, settings: tuple[str, ...] = SLOW) -> Run:
    run = Run(programs, [fluid(ranks=fluids), solid(ranks=solids)], settings)
    run.wait_for_rows("solid/probes.csv", 5)
    return run


def missing(programs):
    Run(programs, [fluid()]).finish().expect(4, "the participant 'solid' is missing", "mpirun -n 1 fake_fluid", ": -n 1 fake_solid")


def missing_fluid(programs):
    Run(programs, [solid(ranks=2)]).finish().expect(4, "the participant 'fluid' is missing", "'solid' (ranks 0, 1)")


def doubled(programs):
    Run(programs, [fluid(), fluid(), solid()]).finish().expect(2, "the role 'fluid' is doubled")


def mistyped(programs):
    Run(programs, [fluid(), solid("--as", "soild")]).finish().expect(2, "soild", "did you mean 'solid'")


def mistyped_key(programs):
    Run(programs, [fluid(), solid("--set", "solid.piston.stifness=3")]).finish().expect(2, "stifness", "did you mean 'stiffness'")


def missing_file(programs):
    Run(programs, [fluid(), solid(file=CASE.parent / "nowhere.toml")]).finish().expect(2, "nowhere.toml")


def different_files(programs):
    with tempfile.TemporaryDirectory() as folder:
        other = Path(shutil.copytree(CASE.parent, Path(folder) / "other")) / "coupling.toml"
        other.write_text(other.read_text() + "# changed\n")
        Run(programs, [fluid(), solid(file=other)]).finish().expect(2, "different coupling files", str(CASE), str(other))


def different_overrides(programs):
    Run(programs, [fluid("--set", "coupling.time.end=0.2"), solid()]).finish().expect(2, "different coupling files or overrides")


def never_calls_init(programs):
    """The deadline counts as the cause."""
    run = Run(programs, [fluid(), Segment(command=("sleep", "60"))], ("coupling.coupling.handshake_timeout=2",))
    run.finish().expect(4, "'fluid' has waited 2 s in MPI_Init", "of the 2 processes", cause=run.start + 2)


def never_calls_init_first(programs):
    run = Run(programs, [Segment(command=("sleep", "60")), solid(ranks=2)], ("coupling.coupling.handshake_timeout=2",))
    run.finish().expect(4, "'solid' has waited 2 s in MPI_Init", cause=run.start + 2)


def stranger(programs):
    """A program that calls MPI_Init and knows nothing of Rivage."""
    strange = str(programs.parent / "tests" / "bin" / "stranger")
    run = Run(programs, [fluid(), Segment(command=(strange,))], ("coupling.coupling.handshake_timeout=3",))
    run.finish().expect(4, "world rank 1 called MPI_Init but did not introduce itself", cause=run.start + 3)


def killed_solid(programs):
    run = under_way(programs)
    cause = run.kill("fake_solid")
    run.finish().expect(137, "'fluid' (rank 0): the partner 'solid' (rank 1", "vanished at t = ", cause=cause)


def killed_fluid(programs):
    run = under_way(programs)
    cause = run.kill("fake_fluid")
    run.finish().expect(137, "'solid' (rank 1): the partner 'fluid' (rank 0", "vanished at t = ", cause=cause)


def killed_while_computing(programs):
    """The survivor is in the middle of a step of 20 s, far from any exchange."""
    busy = Run(programs, [fluid(), solid()], ("fluid.run.sleep=20", "coupling.time.end=1000"))
    busy.wait_for_rows("coupling/interface.csv", 2)
    cause = busy.kill("fake_solid")
    busy.finish().expect(137, "the partner 'solid' (rank 1", "vanished at t = ", cause=cause)


def killed_among_many(programs):
    run = under_way(programs, fluids=2, solids=2)
    cause = run.kill("fake_solid", which=1)
    run.finish().expect(137, "the partner 'solid' (rank 3", "vanished at t = ", cause=cause)


def segmentation_fault(programs):
    run = under_way(programs)
    cause = run.kill("fake_solid", how=signal.SIGSEGV)
    run.finish().expect(139, "the partner 'solid' (rank 1", "vanished at t = ", cause=cause)


def acted_out(programs, role, kind, code, *pieces, fluids=1, solids=1, settings=()):
    """A fault of the configuration at step 10; the run reaches it at once."""
    run = Run(programs, [fluid(ranks=fluids), solid(ranks=solids)], (f'{role}.fault.kind="{kind}"', f"{role}.fault.step=10", *settings))
    run.finish().expect(code, *pieces)


def throws_solid(programs):
    acted_out(programs, "solid", "throw", 3, "'solid' (rank 1", "step 10", "the fault that was asked for")


def throws_fluid(programs):
    acted_out(programs, "fluid", "throw", 3, "'fluid' (rank 0", "step 10", "the fault that was asked for")


def throws_among_many(programs):
    acted_out(programs, "solid", "throw", 3, "'solid' (rank 3", "the fault that was asked for", fluids=2, solids=2,
              settings=("solid.fault.rank=1",))


def nan_solid(programs):
    acted_out(programs, "solid", "nan", 3, "'solid' (rank 1", "the motion of wet node 0 of facet 0 (reference (1, 0)) is not a number",
              settings=('solid.fault.moment="exchange"',))


def nan_fluid(programs):
    acted_out(programs, "fluid", "nan", 3, "'fluid' (rank 0", "the pressure on wet facet 0 at (1, ", "is not a number",
              settings=('fluid.pressure.kind="sine"',))


def silent_solid(programs):
    acted_out(programs, "solid", "silent", 4, "'fluid' (rank 0", "for the motion from 'solid' (rank 1", "since t = ", "is silent",
              settings=("coupling.coupling.silence_timeout=1",))


def silent_fluid(programs):
    acted_out(programs, "fluid", "silent", 4, "'solid' (rank 1", "for the load from 'fluid' (rank 0", "is silent",
              settings=("coupling.coupling.silence_timeout=1",))


def leaves_early(programs):
    acted_out(programs, "solid", "leave", 4, "'fluid' (rank 0", "from 'solid' (rank 1", "has ended its run early")


def asked_to_stop(programs):
    def one(program: str, how: signal.Signals) -> None:
        run = under_way(programs, fluids=2)
        cause = run.kill(program, which=-1, how=how)
        run.finish().expect(5, cause=cause, messages=0)
    side_by_side(one, [("fake_solid", signal.SIGTERM), ("fake_fluid", signal.SIGTERM), ("fake_fluid", signal.SIGUSR1)])


def unhurt(programs):
    """The same programs without a fault end in order."""
    Run(programs, [fluid(ranks=2), solid(ranks=2)]).finish().expect(0, within=60, messages=0)


def own_solid(programs):
    """The example of docs/coupling.md, in either place; killed, it is missed as any other."""
    own = Segment(command=(str(programs.parent / "tests" / "bin" / "own_solid"),))
    for segments in ([fluid(), own], [own, fluid(ranks=2)]):
        run = Run(programs, segments).finish()
        run.expect(0, messages=0)
        assert (run.out / "coupling" / "interface.csv").read_text().count("\n") == 102
        assert (run.out / "summary.json").exists()
    run = Run(programs, [fluid(), own], ('fluid.fault.kind="throw"', "fluid.fault.step=10"))
    run.finish().expect(3, "'fluid' (rank 0", "the fault that was asked for")


def one_segment(programs):
    """As under `srun --multi-prog`: every rank has the same appnum, a wrapper picks the program by rank."""
    pick = f'if [ "$OMPI_COMM_WORLD_RANK" = 1 ]; then exec {programs}/fake_solid "$@"; else exec {programs}/fake_fluid "$@"; fi'
    with tempfile.TemporaryDirectory() as folder:
        wrapped = ("sh", "-c", pick, "sh", str(CASE), "--out", folder)
        Run(programs, [Segment(ranks=3, command=wrapped)]).finish().expect(0, within=60, messages=0)
        assert (Path(folder) / "coupling" / "interface.csv").read_text().count("\n") == 102


# Signals at every moment of a run, to the fluid and to the solid: what mpirun returns, and what the survivor says.
SIGNALS = {"kill": (137, "vanished at t = "), "crash": (139, "vanished at t = ")}
MOMENTS = ("start", "exchange", "step", "end")


def signalled(programs, moment: str, kind: str) -> None:
    def one(role: str, other: str) -> None:
        run = Run(programs, [fluid(), solid()], (f'{role}.fault.kind="{kind}"', f'{role}.fault.moment="{moment}"', f"{role}.fault.step=10"))
        code, piece = SIGNALS[kind]
        run.finish().expect(code, f"the partner '{role}' (rank {0 if role == 'fluid' else 1}", piece, f"'{other}' (rank")
    side_by_side(one, [("solid", "fluid"), ("fluid", "solid")])


def signal_drills() -> dict:
    def drill(moment: str, kind: str):
        return lambda programs: signalled(programs, moment, kind)
    return {f"{kind}_at_{moment}": drill(moment, kind) for moment in MOMENTS for kind in SIGNALS}


def terminated(programs):
    """SIGTERM to one process while all live is a request to stop, whenever it comes before the end."""
    def one(role: str, moment: str) -> None:
        fault = (f'{role}.fault.kind="terminate"', f'{role}.fault.moment="{moment}"', f"{role}.fault.step=10")
        Run(programs, [fluid(), solid()], (*fault, *SLOW)).finish().expect(5, messages=0)
    side_by_side(one, [("solid", "start"), ("fluid", "exchange"), ("solid", "exchange"), ("fluid", "step")])


def throws_at_any_moment(programs):
    def one(role: str, moment: str) -> None:
        acted_out(programs, role, "throw", 3, f"'{role}' (rank", "the fault that was asked for", settings=(f'{role}.fault.moment="{moment}"',))
    side_by_side(one, [(role, moment) for role in ("fluid", "solid") for moment in MOMENTS])


def leaves_at_any_moment(programs):
    def one(role: str, other: str, moment: str) -> None:
        acted_out(programs, role, "leave", 4, f"'{other}' (rank", f"from '{role}' (rank", "has ended its run early",
                  settings=(f'{role}.fault.moment="{moment}"',))
    pairs = (("fluid", "solid"), ("solid", "fluid"))
    side_by_side(one, [(*pair, moment) for pair in pairs for moment in ("start", "exchange", "step")])


def stopped_process(programs):
    """SIGSTOP: the process lives and will never answer; nothing is left of it in the end."""
    def one(role: str, other: str) -> None:
        acted_out(programs, role, "stop", 4, f"'{other}' (rank", f"from '{role}' (rank", "is silent",
                  settings=(f'{role}.fault.moment="step"', "coupling.coupling.silence_timeout=1"))
    side_by_side(one, [("fluid", "solid"), ("solid", "fluid")])


def waits_of_every_style(programs):
    for style in ("auto", "spin", "yield"):
        run = Run(programs, [fluid(), solid()], (f'coupling.coupling.wait="{style}"',)).finish()
        run.expect(0, "waits: ", within=60, messages=0)


if __name__ == "__main__":
    sys.exit(drill_main(globals(), __doc__, signal_drills()))
