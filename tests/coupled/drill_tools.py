# SPDX-License-Identifier: MIT
"""Starts programs under one mpirun, makes them fail, and judges how the run ended."""
import argparse
import inspect
import os
import shlex
import signal
import subprocess
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

CASE = Path(__file__).resolve().parent / "drill_case" / "coupling.toml"
ENVIRONMENT = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMP_NUM_THREADS": "1"}
LONGEST = 5.0  # [s] from the cause to the end of the whole run


@dataclass
class Segment:
    """One part of an mpirun command; `arguments` follow the shared file, `command` replaces program and file."""
    program: str = ""
    ranks: int = 1
    file: Path = CASE
    arguments: tuple[str, ...] = ()
    command: tuple[str, ...] = ()


def fluid(*arguments: str, **others) -> Segment:
    return Segment("fake_fluid", arguments=arguments, **others)


def solid(*arguments: str, **others) -> Segment:
    return Segment("fake_solid", arguments=arguments, **others)


class Run:
    """A started mpirun whose processes can be found, hurt and waited for."""

    def __init__(self, programs: Path, segments: list[Segment], settings: tuple[str, ...] = ()):
        self.folder = tempfile.TemporaryDirectory(prefix="rivage_drill_")
        self.out = Path(self.folder.name) / "out"
        line = ["mpirun", "--oversubscribe", "--bind-to", "none", "--mca", "mpi_yield_when_idle", "1"]
        overrides = [word for setting in settings for word in ("--set", setting)]
        for index, segment in enumerate(segments):
            own = [str(programs / segment.program), str(segment.file), "--out", str(self.out), *overrides, *segment.arguments]
            line += [":"] * (index > 0) + ["-n", str(segment.ranks), *(segment.command or own)]
        print(shlex.join(line), flush=True)
        self.programs = {segment.program for segment in segments if segment.program} | {"fake_fluid", "fake_solid"}
        self.start = time.monotonic()
        self.process = subprocess.Popen(line, env=os.environ | ENVIRONMENT, stdin=subprocess.DEVNULL, text=True,
                                        stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self.code, self.text, self.end = None, "", 0.0

    def pids(self, program: str, word: str = "") -> list[int]:
        """Process ids of this run's ranks of a program, found by the output folder, and a word, on their command line."""
        found = []
        for entry in Path("/proc").iterdir():
            try:
                words = (entry / "cmdline").read_bytes().split(b"\0") if entry.name.isdigit() else []
            except OSError:
                continue
            if words and words[0].decode().endswith("/" + program) and {str(self.out).encode(), word.encode() or words[0]} <= set(words):
                found.append(int(entry.name))
        return sorted(found)

    def wait_for_rows(self, table: str, rows: int) -> None:
        """Until a table of the output folder has so many lines: the run is under way."""
        path = self.out / table
        until = time.monotonic() + 30
        while not path.exists() or path.read_text().count("\n") < rows:
            if time.monotonic() > until or self.process.poll() is not None:
                self.finish(1)
                raise AssertionError(f"the run did not get under way:\n{self.text}")
            time.sleep(0.01)

    def kill(self, program: str, which: int = 0, how: signal.Signals = signal.SIGKILL, word: str = "") -> float:
        """Sends a signal to one rank. Returns the time."""
        os.kill(self.pids(program, word)[which], how)
        return time.monotonic()

    def finish(self, timeout: float = 60) -> "Run":
        try:
            self.text = self.process.communicate(timeout=timeout)[0]
        except subprocess.TimeoutExpired:
            self.process.terminate()
            self.text = self.process.communicate()[0] + "\n(it had to be ended: it hung)"
        self.end = time.monotonic()
        self.code = self.process.returncode
        return self

    def messages(self) -> list[str]:
        return [line for line in self.text.splitlines() if line.startswith("rivage: ")]

    def expect(self, code: int, *pieces: str, cause: float | None = None, within: float = LONGEST, messages: int = 1) -> None:
        """Checks exit code, the one message and its pieces, the time since the cause, and that nothing is left running."""
        elapsed = self.end - (self.start if cause is None else cause)
        print(self.text)
        print(f"exit code {self.code} after {elapsed:.2f} s")
        faults = []
        if self.code != code:
            faults.append(f"exit code {self.code}, not {code}")
        if len(self.messages()) != messages:
            faults.append(f"{len(self.messages())} messages, not {messages}")
        faults += [f"the message lacks {piece!r}" for piece in pieces if piece not in "\n".join(self.text.splitlines())]
        if elapsed > within:
            faults.append(f"it took {elapsed:.2f} s, more than {within} s")
        for program in sorted(self.programs):
            if self.pids(program):
                faults.append(f"{program} is still running")
        assert not faults, "; ".join(faults)


def side_by_side(drill, cases: list[tuple]) -> None:
    """One drill for each case, four at a time: they mostly sleep. The first failure is raised."""
    with ThreadPoolExecutor(max_workers=4) as pool:
        for done in [pool.submit(drill, *case) for case in cases]:
            done.result()


def drill_main(namespace: dict, doc: str, more: dict | None = None) -> int:
    """The command line of a file of drills: its functions with the one argument `programs`, and `more`."""
    drills = {name: value for name, value in namespace.items()
              if inspect.isfunction(value) and value.__module__ == "__main__" and [*inspect.signature(value).parameters] == ["programs"]}
    drills |= more or {}
    parser = argparse.ArgumentParser(description=doc.splitlines()[0])
    parser.add_argument("name", choices=[*drills, "list"])
    parser.add_argument("--programs", type=Path)
    arguments = parser.parse_args()
    if arguments.name == "list":
        print("\n".join(drills))
        return 0
    begin = time.monotonic()
    drills[arguments.name](arguments.programs)
    print(f"{arguments.name}: as it should be, {time.monotonic() - begin:.1f} s in all")
    return 0
