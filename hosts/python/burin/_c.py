"""The C interface of libburin.so, burin/host/c/burin.h and the headers that it includes, for ctypes.

Every call releases the interpreter's lock, so that brushes written in Python can take it on the library's threads, and
other threads of Python run meanwhile.
"""

from __future__ import annotations

import ctypes
import os
from ctypes import (
    CFUNCTYPE,
    POINTER,
    Structure,
    c_char_p,
    c_double,
    c_float,
    c_int32,
    c_uint32,
    c_uint64,
    c_void_p,
)
from pathlib import Path
from typing import Any

from .errors import raise_status

MAJOR = 0
"""The version of the interface that this package is made for, that of libburin.so.0."""

OK = 1
ERROR = 2

FLOAT32, FLOAT64, UINT32, UINT64 = 1, 2, 3, 4


class Sized(Structure):
    """A struct that begins with its size. It is zeroed, and knows its size."""

    def __init__(self, *args: Any, **members: Any) -> None:
        super().__init__(ctypes.sizeof(type(self)), *args, **members)


class Text(Sized):
    _fields_ = [("struct_size", c_uint32), ("capacity", c_uint32), ("data", c_void_p)]


class VersionInfo(Sized):
    _fields_ = [
        ("struct_size", c_uint32),
        ("major", c_uint32),
        ("minor", c_uint32),
        ("abi_major", c_uint32),
        ("abi_minor", c_uint32),
        ("reserved", c_uint32),
        ("text", c_char_p),
    ]


LogFunction = CFUNCTYPE(None, c_void_p, c_int32, c_char_p)
ProgressFunction = CFUNCTYPE(c_int32, c_void_p, c_char_p, c_double)


class LibraryOptions(Sized):
    _fields_ = [("struct_size", c_uint32), ("reserved", c_uint32), ("log", LogFunction), ("user", c_void_p)]


class ParamInfo(Sized):
    _fields_ = [
        ("struct_size", c_uint32),
        ("type", c_int32),
        ("id", c_char_p),
        ("name", c_char_p),
        ("help", c_char_p),
        ("unit", c_int32),
        ("hard_min", c_float),
        ("hard_max", c_float),
        ("soft_min", c_float),
        ("soft_max", c_float),
        ("default_number", c_float),
        ("default_colour", c_float * 4),
        ("default_file", c_char_p),
        ("choices", POINTER(c_char_p)),
        ("default_knots", POINTER(c_float)),
        ("default_knot_count", c_uint32),
        ("dynamic", c_uint32),
        ("default_text", c_char_p),
    ]


class BrushDescriptor(Sized):
    _fields_ = [
        ("struct_size", c_uint32),
        ("param_count", c_uint32),
        ("id", c_char_p),
        ("name", c_char_p),
        ("vendor", c_char_p),
        ("version", c_char_p),
        ("help", c_char_p),
        ("features", POINTER(c_char_p)),
        ("params", POINTER(POINTER(ParamInfo))),
        ("inputs_read", c_uint64),
        ("outputs_written", c_uint64),
        ("overlap", c_int32),
        ("reserved", c_uint32),
        ("rim_slope", c_float),
        ("reserved2", c_uint32),
    ]


def has(struct: Structure, member: str) -> bool:
    """Whether a struct that the library or a plugin filled is large enough to hold a member."""
    descriptor = getattr(type(struct), member)
    return bool(struct.struct_size >= descriptor.offset + descriptor.size)


class MeshArrays(Sized):
    _fields_ = [
        ("struct_size", c_uint32),
        ("position_type", c_int32),
        ("positions", c_void_p),
        ("vertex_count", c_uint64),
        ("position_stride", c_uint64),
        ("corners", c_void_p),
        ("face_count", c_uint64),
        ("face_stride", c_uint64),
        ("corner_type", c_int32),
        ("face_size", c_uint32),
        ("face_sizes", c_void_p),
        ("order", c_int32),
        ("reserved", c_uint32),
    ]


class SessionInfo(Sized):
    _fields_ = [
        ("struct_size", c_uint32),
        ("stroke_open", c_uint32),
        ("vertex_count", c_uint64),
        ("triangle_count", c_uint64),
        ("undo_count", c_uint64),
        ("redo_count", c_uint64),
        ("undo_bytes", c_uint64),
    ]


class Stroke(Sized):
    _fields_ = [
        ("struct_size", c_uint32),
        ("fields", c_uint32),
        ("settings", POINTER(c_char_p)),
        ("seed", c_uint64),
    ]


class Sample(Sized):
    _fields_ = [
        ("struct_size", c_uint32),
        ("pressure", c_float),
        ("time", c_double),
        ("position", c_double * 3),
        ("direction", c_double * 3),
        ("tilt_x", c_float),
        ("tilt_y", c_float),
        ("twist", c_float),
        ("reserved", c_uint32),
    ]


class Event(Sized):
    _fields_ = [("struct_size", c_uint32), ("outcome", c_int32), ("drawn", c_uint64)]


class Range(Structure):
    _fields_ = [("begin", c_uint64), ("end", c_uint64)]


class Array(Sized):
    """burin_target and burin_source, which are alike."""

    _fields_ = [("struct_size", c_uint32), ("type", c_int32), ("data", c_void_p), ("stride", c_uint64)]


class Chart(Sized):
    _fields_ = [
        ("struct_size", c_uint32),
        ("closed", c_uint32),
        ("count", c_uint64),
        ("length", c_double),
        ("vertex", c_void_p),
        ("sheet", c_void_p),
        ("t", c_void_p),
        ("d", c_void_p),
    ]


class Snap(Sized):
    _fields_ = [
        ("struct_size", c_uint32),
        ("line", c_int32),
        ("radius", c_double),
        ("scale", c_double),
        ("significance", c_double),
        ("view", c_double * 3),
        ("view_is_eye", c_uint32),
        ("fixed_ends", c_uint32),
        ("values", c_void_p),
    ]


class Snapped(Sized):
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("samples", c_void_p),
        ("sample_count", c_uint64),
        ("share", c_double),
        ("significance", c_double),
        ("mean_move", c_double),
    ]


class RecordingStroke(Sized):
    _fields_ = [
        ("struct_size", c_uint32),
        ("fields", c_uint32),
        ("settings", POINTER(c_char_p)),
        ("seed", c_uint64),
        ("samples", c_void_p),
        ("sample_count", c_uint64),
    ]


class Refinement(Sized):
    _fields_ = [
        ("struct_size", c_uint32),
        ("levels", c_uint32),
        ("target_triangles", c_uint64),
        ("weld", c_double),
    ]


class MeshValues(Sized):
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("colours", c_void_p),
        ("masks", c_void_p),
        ("origin", c_double * 3),
    ]


class RecorderCamera(Structure):
    _fields_ = [("view", c_double * 16), ("projection", c_double * 16), ("width", c_int32), ("height", c_int32)]


class RecorderOptions(Sized):
    _fields_ = [
        ("struct_size", c_uint32),
        ("space", c_int32),
        ("path", c_char_p),
        ("device", c_char_p),
        ("camera", POINTER(RecorderCamera)),
    ]


class RecordedStroke(Sized):
    _fields_ = [("struct_size", c_uint32), ("fields", c_uint32), ("settings", c_char_p)]


class RecordedSample(Sized):
    _fields_ = [
        ("struct_size", c_uint32),
        ("pressure", c_float),
        ("time", c_double),
        ("position", c_double * 3),
        ("tilt_x", c_float),
        ("tilt_y", c_float),
        ("twist", c_float),
        ("reserved", c_uint32),
    ]


# The functions that return a status: what they take before the buffer for the text of an error.
_WITH_STATUS: dict[str, list[Any]] = {
    "burin_get_version": [POINTER(VersionInfo)],
    "burin_library_create": [POINTER(LibraryOptions), POINTER(c_void_p)],
    "burin_library_load": [c_void_p, c_char_p],
    "burin_library_reload": [c_void_p, c_char_p],
    "burin_library_add": [c_void_p, c_char_p, c_void_p],
    "burin_session_create": [c_void_p, POINTER(MeshArrays), POINTER(c_void_p)],
    "burin_session_get_info": [c_void_p, POINTER(SessionInfo)],
    "burin_session_read_map": [c_void_p, c_int32, c_void_p, c_uint64],
    "burin_session_read_triangles": [c_void_p, c_void_p, c_uint64],
    "burin_session_begin": [c_void_p, POINTER(Stroke)],
    "burin_session_add": [c_void_p, c_void_p, c_uint64, POINTER(Event)],
    "burin_session_end": [c_void_p],
    "burin_session_cancel": [c_void_p],
    "burin_session_undo": [c_void_p],
    "burin_session_redo": [c_void_p],
    "burin_session_limit_undo": [c_void_p, c_uint64],
    "burin_session_set_progress": [c_void_p, ProgressFunction, c_void_p],
    "burin_session_replay": [c_void_p, c_char_p, POINTER(c_char_p)],
    "burin_session_hash": [c_void_p, POINTER(c_uint64)],
    "burin_session_update": [c_void_p, c_int32, c_uint64, c_void_p, c_uint64, POINTER(c_uint64)],
    "burin_session_write": [c_void_p, c_int32, POINTER(Range), POINTER(Array)],
    "burin_session_read": [c_void_p, c_int32, POINTER(Range), POINTER(Array)],
    "burin_session_chart": [c_void_p, POINTER(Chart)],
    "burin_session_snap": [c_void_p, POINTER(Snap), c_void_p, c_uint64, c_uint32, POINTER(Snapped)],
    "burin_recording_read": [c_char_p, POINTER(c_void_p)],
    "burin_recording_get_stroke": [c_void_p, c_uint64, POINTER(RecordingStroke)],
    "burin_triangles_read": [c_char_p, POINTER(Refinement), POINTER(c_void_p)],
    "burin_triangles_refine": [POINTER(MeshArrays), POINTER(Refinement), POINTER(c_void_p)],
    "burin_triangles_get": [c_void_p, POINTER(MeshArrays), POINTER(MeshValues)],
    "burin_mesh_write": [c_char_p, POINTER(MeshArrays), POINTER(MeshValues)],
    "burin_recorder_begin": [c_void_p, POINTER(RecordedStroke)],
    "burin_recorder_add": [c_void_p, POINTER(RecordedSample)],
    "burin_recorder_end": [c_void_p],
}

# The others: what they return and take.
_WITHOUT_STATUS: dict[str, tuple[Any, list[Any]]] = {
    "burin_library_destroy": (None, [c_void_p]),
    "burin_library_brush_count": (c_uint64, [c_void_p]),
    "burin_library_brush": (POINTER(BrushDescriptor), [c_void_p, c_uint64]),
    "burin_library_refused_count": (c_uint64, [c_void_p]),
    "burin_library_refused": (c_char_p, [c_void_p, c_uint64]),
    "burin_session_destroy": (None, [c_void_p]),
    "burin_session_values": (c_void_p, [c_void_p, c_int32]),
    "burin_recording_destroy": (None, [c_void_p]),
    "burin_recording_stroke_count": (c_uint64, [c_void_p]),
    "burin_recording_device": (c_char_p, [c_void_p]),
    "burin_triangles_destroy": (None, [c_void_p]),
    "burin_recorder_open": (c_void_p, [POINTER(RecorderOptions), POINTER(Text)]),
    "burin_recorder_close": (None, [c_void_p]),
}


def library_file() -> str:
    """The libburin.so.0 that is loaded: what the environment variable BURIN_LIBRARY names, else one beside this package's
    own files, else the one that the system's loader finds."""
    named = os.environ.get("BURIN_LIBRARY")
    if named:
        return named
    beside = Path(__file__).with_name("libburin.so.0")
    return str(beside) if beside.exists() else "libburin.so.0"


def _load() -> ctypes.CDLL:
    try:
        library = ctypes.CDLL(library_file())
    except OSError as fault:
        raise ImportError(
            f"{fault}; install the package libburin0, or let BURIN_LIBRARY name the file libburin.so.0"
        ) from None
    for name, takes in _WITH_STATUS.items():
        function = getattr(library, name)
        function.restype = c_int32
        function.argtypes = [*takes, POINTER(Text)]
    for name, (returns, takes) in _WITHOUT_STATUS.items():
        function = getattr(library, name)
        function.restype = returns
        function.argtypes = takes
    return library


lib = _load()


class ErrorText:
    """A buffer for one line that explains why a call failed."""

    def __init__(self) -> None:
        self._buffer = ctypes.create_string_buffer(2000)
        self.text = Text(len(self._buffer), ctypes.addressof(self._buffer))

    def __str__(self) -> str:
        return self._buffer.value.decode(errors="replace")


def call(name: str, *args: Any, cause: BaseException | None = None) -> None:
    """Calls a function that returns a status. Raises its text as Error or one of its kinds."""
    error = ErrorText()
    status = getattr(lib, name)(*args, error.text)
    if status != OK:
        raise_status(status, str(error), cause)


def texts(lines: list[str]) -> Any:
    """An array of UTF-8 texts, ended by a null pointer."""
    return (c_char_p * (len(lines) + 1))(*(line.encode() for line in lines), None)


def strings(array: Any) -> tuple[str, ...]:
    """The texts of an array that a null pointer ends."""
    found: list[str] = []
    while array and array[len(found)] is not None:
        found.append(array[len(found)].decode())
    return tuple(found)


def version() -> str:
    """The version of the library that is loaded. Raises ImportError if it is not of the major version of this package."""
    info = VersionInfo()
    call("burin_get_version", info)
    if info.major != MAJOR:
        raise ImportError(f"{library_file()} has version {info.major} of the C interface, not {MAJOR}")
    return str(info.text.decode())
