"""The structs of burin/host/c/burin.h and of the headers that it includes, for ctypes."""

from __future__ import annotations

import ctypes
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
from typing import Any

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
TaskFunction = CFUNCTYPE(None, c_void_p, c_uint64)
RunFunction = CFUNCTYPE(None, c_void_p, TaskFunction, c_void_p, c_uint64)
ProgressFunction = CFUNCTYPE(c_int32, c_void_p, c_char_p, c_double)


class LibraryOptions(Sized):
    _fields_ = [
        ("struct_size", c_uint32),
        ("isolate", c_uint32),
        ("log", LogFunction),
        ("user", c_void_p),
        ("brush_process", c_char_p),
        ("load_seconds", c_double),
        ("call_seconds", c_double),
        ("batch_seconds", c_double),
        ("memory", c_uint64),
        ("run", RunFunction),
        ("run_user", c_void_p),
        ("run_threads", c_uint32),
        ("reserved", c_uint32),
    ]


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
        ("refines", c_uint32),
        ("transform", c_void_p),
        ("hidden", c_void_p),
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
        ("undo_dropped", c_uint64),
        ("generation", c_uint64),
        ("has_colours", c_uint32),
        ("has_masks", c_uint32),
        ("solid_count", c_uint64),
        ("bent_mesh_count", c_uint64),
    ]


class Patch(Sized):
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("kept_vertices", c_uint64),
        ("vertex_count", c_uint64),
        ("removed_count", c_uint64),
        ("removed", c_void_p),
        ("added_count", c_uint64),
        ("added", c_void_p),
    ]


class GroupEvent(Sized):
    _fields_ = [
        ("struct_size", c_uint32),
        ("outcome", c_int32),
        ("drawn", c_uint64),
        ("session", c_uint64),
    ]


class StepInfo(Sized):
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("bytes", c_uint64),
        ("saved_bytes", c_uint64),
        ("vertex_count", c_uint64),
        ("painted_count", c_uint64),
    ]


class Stroke(Sized):
    _fields_ = [
        ("struct_size", c_uint32),
        ("fields", c_uint32),
        ("settings", POINTER(c_char_p)),
        ("seed", c_uint64),
        ("path", c_void_p),
        ("path_count", c_uint64),
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
        ("barrel", c_uint32),
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
        ("least_angle", c_double),
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
        ("tool", c_char_p),
        ("eraser", c_uint32),
        ("reserved", c_uint32),
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
        ("uv", c_void_p),
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
    _fields_ = [
        ("struct_size", c_uint32),
        ("fields", c_uint32),
        ("settings", c_char_p),
        ("tool", c_char_p),
        ("eraser", c_uint32),
        ("reserved", c_uint32),
    ]


class RecordedSample(Sized):
    _fields_ = [
        ("struct_size", c_uint32),
        ("pressure", c_float),
        ("time", c_double),
        ("position", c_double * 3),
        ("tilt_x", c_float),
        ("tilt_y", c_float),
        ("twist", c_float),
        ("barrel", c_uint32),
    ]
