"""The functions of libburin.so, burin/host/c/burin.h, with the structs that they take.

Every call releases the interpreter's lock, so that brushes written in Python can take it on the library's threads, and
other threads of Python run meanwhile.
"""

from __future__ import annotations

import ctypes
import os
from collections.abc import Callable
from ctypes import POINTER, c_char_p, c_int32, c_uint32, c_uint64, c_void_p
from pathlib import Path
from typing import Any

from ._structs import (
    Array as Array,
    BrushDescriptor as BrushDescriptor,
    Chart as Chart,
    Event as Event,
    GroupEvent as GroupEvent,
    LibraryOptions as LibraryOptions,
    LogFunction as LogFunction,
    MeshArrays as MeshArrays,
    MeshValues as MeshValues,
    ParamInfo as ParamInfo,
    Patch as Patch,
    ProgressFunction as ProgressFunction,
    Range as Range,
    RecordedSample as RecordedSample,
    RecordedStroke as RecordedStroke,
    RecorderCamera as RecorderCamera,
    RecorderOptions as RecorderOptions,
    RecordingStroke as RecordingStroke,
    Refinement as Refinement,
    RunFunction as RunFunction,
    Sample as Sample,
    SessionInfo as SessionInfo,
    Sized as Sized,
    Snap as Snap,
    Snapped as Snapped,
    StepInfo as StepInfo,
    Stroke as Stroke,
    Text as Text,
    VersionInfo as VersionInfo,
    has as has,
)
from .errors import raise_status

MAJOR = 0
"""The version of the interface that this package is made for, that of libburin.so.0."""

OK = 1
ERROR = 2

FLOAT32, FLOAT64, UINT32, UINT64 = 1, 2, 3, 4


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
    "burin_session_take_patch": [c_void_p, POINTER(Patch)],
    "burin_session_begin": [c_void_p, POINTER(Stroke)],
    "burin_session_add": [c_void_p, c_void_p, c_uint64, POINTER(Event)],
    "burin_session_end": [c_void_p],
    "burin_session_cancel": [c_void_p],
    "burin_session_undo": [c_void_p],
    "burin_session_redo": [c_void_p],
    "burin_session_limit_undo": [c_void_p, c_uint64],
    "burin_session_hide": [c_void_p, c_void_p, c_uint64],
    "burin_session_take_step": [c_void_p, POINTER(c_void_p)],
    "burin_session_apply_step": [c_void_p, c_void_p],
    "burin_group_create": [c_void_p, c_uint64, POINTER(c_void_p)],
    "burin_group_begin": [c_void_p, POINTER(Stroke)],
    "burin_group_add": [c_void_p, c_void_p, c_uint64, POINTER(GroupEvent)],
    "burin_group_end": [c_void_p],
    "burin_group_cancel": [c_void_p],
    "burin_group_undo": [c_void_p],
    "burin_group_redo": [c_void_p],
    "burin_step_get_info": [c_void_p, POINTER(StepInfo)],
    "burin_step_save": [c_void_p, c_void_p, c_uint64],
    "burin_step_load": [c_char_p, c_uint64, POINTER(c_void_p)],
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
    "burin_session_read_solid": [c_void_p, c_uint64, POINTER(c_void_p)],
    "burin_session_read_bent_mesh": [c_void_p, c_uint64, POINTER(c_void_p)],
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
    "burin_step_destroy": (None, [c_void_p]),
    "burin_group_destroy": (None, [c_void_p]),
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
    try:
        for name, takes in _WITH_STATUS.items():
            _declare(getattr(library, name), c_int32, [*takes, POINTER(Text)])
        for name, (returns, takes) in _WITHOUT_STATUS.items():
            _declare(getattr(library, name), returns, takes)
    except AttributeError as fault:
        raise ImportError(f"{fault}; the library is older than this package") from None
    return library


def _declare(function: Any, returns: Any, takes: list[Any]) -> None:
    function.restype, function.argtypes = returns, takes


lib = _load()


class ErrorText:
    """A buffer for one line that explains why a call failed."""

    def __init__(self) -> None:
        self._buffer = ctypes.create_string_buffer(2000)
        self.text = Text(len(self._buffer), ctypes.addressof(self._buffer))

    def __str__(self) -> str:
        return self._buffer.value.decode(errors="replace")


def call(name: str, *args: Any, cause_of: Callable[[str], BaseException | None] | None = None) -> None:
    """Calls a function that returns a status. Raises its text as Error or one of its kinds. `cause_of` tells which exception
    of Python a text is of."""
    error = ErrorText()
    status = getattr(lib, name)(*args, error.text)
    if status != OK:
        text = str(error)
        raise_status(status, text, cause_of(text) if cause_of else None)


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
