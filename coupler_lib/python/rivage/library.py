# SPDX-License-Identifier: MIT
"""librivage.so and the types that cross into it; nobody but this package needs it."""
import ctypes
import os
from ctypes import POINTER, c_char_p, c_double, c_int, c_int32, c_int64, c_void_p
from pathlib import Path

import numpy as np

REAL, LONG, INT = POINTER(c_double), POINTER(c_int64), POINTER(c_int32)


class CWindow(ctypes.Structure):
    _fields_ = [("step", c_int64), ("time", c_double), ("dt", c_double), ("last", c_int32), ("stop_requested", c_int32)]


class FluidReport(ctypes.Structure):
    _fields_ = [*((name, c_double) for name in ("kinetic", "potential", "internal", "external_work", "outflow", "dissipated")),
                ("force", c_double * 3), ("moment", c_double * 3),
                *((name, c_double) for name in ("work_on_solid", "path_work", "jump_work", "wait"))]


class SolidReport(ctypes.Structure):
    _fields_ = [("force", c_double * 3), ("moment", c_double * 3),
                *((name, c_double) for name in ("work", "displacement_max", "kinetic", "strain", "potential", "external_work",
                                                "dissipated", "wait"))]


# Name: result, arguments.
FUNCTIONS = {
    "rivage_last_error": (c_char_p, []),
    "rivage_version": (c_char_p, []),
    "rivage_mpi_start": (c_int, [c_char_p, c_double]),
    "rivage_join": (c_int, [c_int, c_char_p, c_char_p, POINTER(c_char_p), c_int, POINTER(c_void_p)]),
    "rivage_leave": (c_int, [c_void_p]),
    "rivage_fail": (None, [c_void_p, c_int, c_char_p]),
    **{f"rivage_{name}": (c_int, [c_void_p]) for name in ("comm", "rank", "size", "is_serial", "solid_every", "stop_requested")},
    **{f"rivage_{name}": (c_double, [c_void_p]) for name in ("end_time", "table_interval", "impedance_share")},
    **{f"rivage_{name}": (c_char_p, [c_void_p]) for name in ("role", "output_dir")},
    "rivage_request_stop": (None, [c_void_p]),
    "rivage_solid_open": (c_int, [c_void_p, c_int, c_int64, LONG, REAL, c_int64, LONG, INT, POINTER(c_void_p)]),
    "rivage_solid_receive": (c_int, [c_void_p, POINTER(CWindow)]),
    **{f"rivage_solid_{name}": (REAL, [c_void_p]) for name in ("force", "pressure", "wall_velocity")},
    "rivage_solid_impedance": (c_double, [c_void_p]),
    "rivage_solid_fluid_report": (c_int, [c_void_p, POINTER(FluidReport)]),
    "rivage_solid_predict": (c_int, [c_void_p, REAL, c_double]),
    "rivage_solid_send": (c_int, [c_void_p, REAL, REAL, REAL, POINTER(SolidReport)]),
    "rivage_solid_close": (c_int, [c_void_p]),
    "rivage_fluid_open": (c_int, [c_void_p, c_char_p, c_int, c_double, c_double, c_char_p, POINTER(c_void_p)]),
    "rivage_fluid_send": (c_int, [c_void_p, POINTER(CWindow), REAL, REAL, REAL, REAL, REAL, REAL, POINTER(FluidReport)]),
    "rivage_fluid_receive": (c_int, [c_void_p, POINTER(SolidReport)]),
    "rivage_fluid_nodes": (c_int64, [c_void_p]),
    "rivage_fluid_facets": (c_int64, [c_void_p]),
    **{f"rivage_fluid_{name}": (LONG, [c_void_p]) for name in ("node_ids", "facet_ids")},
    "rivage_fluid_facet_nodes": (INT, [c_void_p]),
    **{f"rivage_fluid_{name}": (REAL, [c_void_p]) for name in ("position", "velocity", "acceleration")},
    "rivage_fluid_stop_agreed": (c_int, [c_void_p]),
    "rivage_fluid_close": (c_int, [c_void_p]),
}


def load() -> ctypes.CDLL:
    """The library beside this package's build, or where RIVAGE_LIBRARY says, or on the loader's path."""
    path = os.environ.get("RIVAGE_LIBRARY") or next(
        (str(folder / "librivage.so") for folder in (Path(__file__).parent, Path(__file__).parents[2] / "lib")
         if (folder / "librivage.so").exists()), "librivage.so")
    library = ctypes.CDLL(path, mode=ctypes.RTLD_GLOBAL)
    for name, (result, arguments) in FUNCTIONS.items():
        function = getattr(library, name)
        function.restype, function.argtypes = result, arguments
    return library


LIBRARY = load()


def as_array(values, dtype, shape: tuple[int, ...], name: str) -> np.ndarray:
    """A contiguous array of this type, copied only where it is none. Raises ValueError on a wrong shape."""
    array = np.ascontiguousarray(values, dtype=dtype)
    if array.shape != shape:
        raise ValueError(f"{name} has the shape {array.shape}, but {shape} is wanted")
    return array


def pointer(array: np.ndarray | None, kind=REAL):
    return array.ctypes.data_as(kind) if array is not None else None


def view(address, shape: tuple[int, ...], dtype=np.float64) -> np.ndarray:
    """The library's memory as a read-only array; empty where there is none."""
    if not address or 0 in shape:
        return np.zeros(shape, dtype=dtype)
    array = np.ctypeslib.as_array(address, shape=shape)
    array.flags.writeable = False
    return array
