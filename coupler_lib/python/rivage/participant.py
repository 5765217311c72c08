# SPDX-License-Identifier: MIT
"""A role of a coupled run, on this rank."""
import atexit
import ctypes
import os
import sys
import traceback
from collections.abc import Iterable
from pathlib import Path

from rivage import library as c
from rivage.sides import Fluid, Solid


class Error(RuntimeError):
    """What the coupling library found wrong; `code` is the exit code that belongs to it."""

    def __init__(self, code: int, message: str):
        super().__init__(message)
        self.code = code


def check(code: int) -> None:
    if code != 0:
        raise Error(code, c.LIBRARY.rivage_last_error().decode())


def version() -> str:
    return c.LIBRARY.rivage_version().decode()


def start_mpi(role: str, timeout: float):
    """mpi4py with MPI running, started under the library's watchdog where it was not running yet."""
    if "mpi4py.MPI" not in sys.modules:
        import mpi4py
        mpi4py.rc.initialize = False
    from mpi4py import MPI
    if not MPI.Is_initialized():
        check(c.LIBRARY.rivage_mpi_start(role.encode(), timeout))
    return MPI


class Participant:
    """Joins the run of coupling.toml in a role. As a context: an exception within ends the whole run with its message. Without one
    call leave() last.

    arguments: the words that follow the file in the command line, sys.argv[2:]: "coupling.time.end=0.1" or "--set",
    "coupling.time.end=0.1" for overrides, which must be those of the partners; "--as", "ROLE" in the place of role; "--out", "FOLDER".
    world: an mpi4py communicator of all ranks of the run, MPI.COMM_WORLD by default.
    """

    def __init__(self, role: str, coupling_file: str | os.PathLike, arguments: Iterable[str] = (), world=None,
                 start_timeout: float = 30.0):
        self.mpi = start_mpi(role, start_timeout)
        self.file = Path(coupling_file)
        texts = [text.encode() for text in arguments]
        handle = ctypes.c_void_p()
        world = world if world is not None else self.mpi.COMM_WORLD
        try:
            check(c.LIBRARY.rivage_join(world.py2f(), role.encode(), os.fsencode(coupling_file),
                                        (ctypes.c_char_p * len(texts))(*texts), len(texts), ctypes.byref(handle)))
        except Error as error:      # all ranks know, and world rank 0 has said it
            self.mpi.Finalize()
            raise SystemExit(error.code) from None
        self.handle = handle
        self.arguments = [text.decode() for text in texts]
        self.role: str = c.LIBRARY.rivage_role(handle).decode()
        self.out: str | None = c.LIBRARY.rivage_output_dir(handle).decode() or None
        self.sides: list[Solid | Fluid] = []
        atexit.register(self.end_forgotten)

    @property
    def comm(self):
        """mpi4py communicator of the ranks of this role."""
        return self.mpi.Comm.f2py(c.LIBRARY.rivage_comm(self.handle))

    @property
    def end_time(self) -> float:
        return c.LIBRARY.rivage_end_time(self.handle)

    @property
    def table_interval(self) -> float:
        return c.LIBRARY.rivage_table_interval(self.handle)

    @property
    def serial(self) -> bool:
        """Whether the solid steps after the fluid, with the load of the same step."""
        return bool(c.LIBRARY.rivage_is_serial(self.handle))

    @property
    def impedance_share(self) -> float:
        """Of rho c, that the solid answers to within its step (coupling.impedance_factor)."""
        return c.LIBRARY.rivage_impedance_share(self.handle)

    @property
    def solid_every(self) -> int:
        return c.LIBRARY.rivage_solid_every(self.handle)

    @property
    def stop_requested(self) -> bool:
        return bool(c.LIBRARY.rivage_stop_requested(self.handle))

    def request_stop(self) -> None:
        c.LIBRARY.rivage_request_stop(self.handle)

    def solid(self, dimension: int, node_ids, reference, facets, facet_ids=None) -> Solid:
        """The solid's end: its wet facets, each a row of 2 to 4 indices into the nodes. Collective over the role's ranks."""
        self.sides.append(Solid(self, check, dimension, node_ids, reference, facets, facet_ids))
        return self.sides[-1]

    def fluid(self, dimension: int, impedance: float, partner: str | None = None, pressure_limit: float = float("inf"),
              output_dir: str | os.PathLike | None = None) -> Fluid:
        """The fluid's end of the interface with `partner` (None: the only solid). Collective over the role's ranks."""
        self.sides.append(Fluid(self, check, dimension, impedance, partner, pressure_limit, output_dir))
        return self.sides[-1]

    def fail(self, message: str, code: int = 3) -> None:
        """Ends the run on every rank of every participant, with one message."""
        c.LIBRARY.rivage_fail(self.handle, code, message.encode())

    def leave(self) -> None:
        """The end in order; exits with code 5 where the run was stopped on request."""
        for side in self.sides:
            side.close()
        code = c.LIBRARY.rivage_leave(self.handle)
        self.handle = None
        if code == 5:
            raise SystemExit(code)
        check(code)

    def end_forgotten(self) -> None:
        """At the end of a program that has not left."""
        if self.handle is not None and not self.mpi.Is_finalized():
            whole = self.sides and all(side.answered_last for side in self.sides)
            self.leave() if whole else self.fail("the program ended before the run did")

    def __enter__(self) -> "Participant":
        return self

    def __exit__(self, kind, error, trace) -> None:
        if kind is None:
            self.leave()
        elif isinstance(error, Error):
            self.fail(str(error), error.code)
        else:       # also of sys.exit and Ctrl-C: the partners must not wait for a solver that has gone
            frames = traceback.extract_tb(trace)
            own = [frame for frame in frames if Path(frame.filename).parent != Path(__file__).parent] or frames
            self.fail(f"{kind.__name__}: {error} ({Path(own[-1].filename).name}, line {own[-1].lineno})")
