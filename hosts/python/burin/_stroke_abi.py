"""The structs of burin/abi/stroke.h and param.h, which brushes get."""

from __future__ import annotations

from ctypes import POINTER, Structure, c_char_p, c_double, c_uint32, c_uint64, c_void_p


class FloatArray(Structure):
    """burin_floats, and burin_indices and burin_floats_out, which are laid out alike."""

    _fields_ = [("data", c_void_p), ("stride", c_uint32), ("reserved", c_uint32)]


class Vectors(Structure):
    _fields_ = [("x", FloatArray), ("y", FloatArray), ("z", FloatArray)]


class Colours(Structure):
    _fields_ = [("r", FloatArray), ("g", FloatArray), ("b", FloatArray), ("a", FloatArray)]


class ParamValue(Structure):
    _fields_ = [
        ("number", FloatArray),
        ("colour", FloatArray * 4),
        ("text", c_char_p),
        ("knots", c_void_p),
        ("knot_count", c_uint32),
        ("reserved", c_uint32),
    ]


class Params(Structure):
    _fields_ = [("struct_size", c_uint32), ("count", c_uint32), ("values", POINTER(ParamValue))]


class ContextStruct(Structure):
    _fields_ = [
        ("struct_size", c_uint32),
        ("pass_", c_uint32),
        ("flags", c_uint64),
        ("pen_present", c_uint64),
        ("seed", c_uint64),
        ("length", c_double),
        ("radius_min", c_double),
        ("radius_max", c_double),
        ("object_scale", c_double),
        ("dab_t", c_double),
    ]


class PlanStruct(Structure):
    _fields_ = [("struct_size", c_uint32), ("passes", c_uint32), ("end_influence", c_double)]


class BatchStruct(Structure):
    _fields_ = [
        ("struct_size", c_uint32),
        ("count", c_uint32),
        ("params", POINTER(Params)),
        ("t", FloatArray),
        ("d", FloatArray),
        ("radius", FloatArray),
        ("stretch", FloatArray),
        ("footprint_t", FloatArray),
        ("footprint_d", FloatArray),
        ("position", Vectors),
        ("normal", Vectors),
        ("e1", Vectors),
        ("mean_curvature", FloatArray),
        ("laplacian", Vectors),
        ("displacement", Vectors),
        ("mask", FloatArray),
        ("colour", Colours),
        ("sheet", FloatArray),
        ("visit_count", FloatArray),
        ("node_id", FloatArray),
        ("symmetry", FloatArray),
        ("pressure", FloatArray),
        ("tilt_x", FloatArray),
        ("tilt_y", FloatArray),
        ("twist", FloatArray),
        ("speed", FloatArray),
        ("time", FloatArray),
        ("foot", Vectors),
        ("foot_normal", Vectors),
        ("fine_position", Vectors),
        ("fine_normal", Vectors),
        ("fine_mean_curvature", FloatArray),
        ("end_distance", FloatArray),
    ]


class OutputsStruct(Structure):
    _fields_ = [
        ("struct_size", c_uint32),
        ("count", c_uint32),
        ("along", FloatArray),
        ("across", FloatArray),
        ("up", FloatArray),
        ("mask", FloatArray),
        ("colour", FloatArray * 4),
    ]
