"""Brushes in Python as the plugin ABI has them: descriptors, a factory, and the functions that the library calls.

The library calls them on its own threads; ctypes takes the interpreter's lock for each call. Objects that the library
knows by an address are kept in tables until it lets them go.
"""

from __future__ import annotations

import ctypes
import itertools
import traceback
from collections.abc import Sequence
from ctypes import CFUNCTYPE, POINTER, Structure, c_char_p, c_double, c_float, c_int32, c_uint32, c_void_p
from typing import TYPE_CHECKING, Any

from . import _c
from ._evaluation import Batch, Start
from ._stroke_abi import BatchStruct, ContextStruct, OutputsStruct, Params, PlanStruct
from .brushinfo import INPUTS, OUTPUTS, OVERLAPS, UNITS
from .errors import InvalidArgument

if TYPE_CHECKING:
    from .brush import Brush, Param

_Destroy = CFUNCTYPE(None, c_void_p)
_GetExtension = CFUNCTYPE(c_void_p, c_void_p, c_char_p)
_Begin = CFUNCTYPE(c_int32, c_void_p, c_void_p, c_void_p, c_void_p, POINTER(c_void_p), c_void_p)
_Evaluate = CFUNCTYPE(c_int32, c_void_p, c_void_p, c_void_p, c_void_p, c_void_p, c_void_p)
_End = CFUNCTYPE(None, c_void_p, c_void_p)
_Create = CFUNCTYPE(c_void_p, c_void_p, c_void_p, c_char_p, c_void_p)


class _BrushStruct(_c.Sized):
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("self", c_void_p),
        ("destroy", _Destroy),
        ("get_extension", _GetExtension),
        ("begin", _Begin),
        ("evaluate", _Evaluate),
        ("end", _End),
    ]


class _FactoryStruct(_c.Sized):
    _fields_ = [
        ("struct_size", c_uint32),
        ("brush_count", c_uint32),
        ("brushes", POINTER(POINTER(_c.BrushDescriptor))),
        ("create", _Create),
    ]


class _Instance:
    """A brush that the library has made, with the states of its open strokes."""

    def __init__(self, brush: Brush, factory: Factory, order: dict[str, int]) -> None:
        self.brush = brush
        self.factory = factory
        self.order = order
        self.strokes: dict[int, Any] = {}
        self.struct = _BrushStruct(0, None, *_FUNCTIONS)


_instances: dict[int, _Instance] = {}
_factories: dict[int, Factory] = {}
_stroke_keys = itertools.count(1)


def _fail(error: int | None, factory: Factory, fault: BaseException) -> int:
    """Gives the last line of an exception's traceback to the library."""
    line = traceback.format_exception_only(type(fault), fault)[-1].strip()
    factory.faults[line] = fault
    if error:
        text = _c.Text.from_address(error)
        if text.data and text.capacity:
            line_bytes = line.encode()[: text.capacity - 1].decode(errors="ignore").encode() + b"\0"
            ctypes.memmove(text.data, line_bytes, len(line_bytes))
    return _c.ERROR


def _destroy(brush: int) -> None:
    del _instances[brush]


def _get_extension(_brush: int, _id: bytes) -> None:
    return None


def _begin(brush: int, context: int, params: int, plan: int, stroke: Any, error: int | None) -> int:
    instance = _instances[brush]
    try:
        start = Start(ContextStruct.from_address(context), Params.from_address(params), instance.order)
        state = instance.brush.begin(start)
        to_be = PlanStruct.from_address(plan)
        to_be.passes, to_be.end_influence = start.passes, start.end_influence
        key = next(_stroke_keys)
        instance.strokes[key] = state
        stroke[0] = key
        return _c.OK
    except BaseException as fault:  # none may cross the ABI
        return _fail(error, instance.factory, fault)


def _evaluate(brush: int, stroke: int, context: int, batch: int, outputs: int, error: int | None) -> int:
    instance = _instances[brush]
    try:
        instance.brush.evaluate(
            Batch(
                BatchStruct.from_address(batch),
                OutputsStruct.from_address(outputs),
                ContextStruct.from_address(context),
                instance.order,
                instance.strokes[stroke],
            )
        )
        return _c.OK
    except BaseException as fault:
        return _fail(error, instance.factory, fault)


def _end(brush: int, stroke: int) -> None:
    instance = _instances[brush]
    instance.brush.end(instance.strokes.pop(stroke))


def _create(factory: int, _host: int, brush_id: bytes, error: int | None) -> int | None:
    made_by = _factories[factory]
    try:
        instance = made_by.make(brush_id.decode())
        address = ctypes.addressof(instance.struct)
        _instances[address] = instance
        return address
    except BaseException as fault:
        _fail(error, made_by, fault)
        return None


_FUNCTIONS = (
    _Destroy(_destroy),
    _GetExtension(_get_extension),
    _Begin(_begin),
    _Evaluate(_evaluate),
    _End(_end),
)
_CREATE = _Create(_create)


def _bits(names: Sequence[str], known: Sequence[str], what: str) -> int:
    bits = 0
    for name in names:
        if name not in known:
            raise InvalidArgument(f"{what}: there is no {name!r}, but {', '.join(known)}")
        bits |= 1 << known.index(name)
    return bits


def _number(names: Sequence[str], name: str, what: str) -> int:
    if name not in names[1:]:
        raise InvalidArgument(f"{what}: there is no {name!r}, but {', '.join(names[1:])}")
    return names.index(name)


class Factory:
    """The brushes of one or more classes. It must live until the library is destroyed."""

    def __init__(self, brushes: Sequence[type[Brush]]) -> None:
        self._classes = {brush.id: brush for brush in brushes}
        self.faults: dict[str, BaseException] = {}
        """What brushes raised, by the lines that the library got."""
        self._kept: list[object] = []
        descriptors = [ctypes.pointer(self._descriptor(brush)) for brush in brushes]
        array = (POINTER(_c.BrushDescriptor) * len(brushes))(*descriptors)
        self._struct = _FactoryStruct(len(brushes), array, _CREATE)
        self.address = ctypes.addressof(self._struct)
        self._kept += [descriptors, array]
        _factories[self.address] = self

    def make(self, brush_id: str) -> _Instance:
        brush = self._classes[brush_id]
        return _Instance(brush(), self, {param.id: index for index, param in enumerate(brush.params())})

    def take_fault(self, text: str) -> BaseException | None:
        """What a brush raised that a text of the library has. Forgets what any raised: tracebacks keep what they show."""
        faults, self.faults = self.faults, {}
        return next((fault for line, fault in faults.items() if line in text), None)

    def release(self) -> None:
        """Forgets the factory, once its library is destroyed."""
        del _factories[self.address]

    def _descriptor(self, brush: type[Brush]) -> _c.BrushDescriptor:
        params = [self._param(param) for param in brush.params()]
        array = (POINTER(_c.ParamInfo) * len(params))(*(ctypes.pointer(param) for param in params))
        features = _c.texts(list(brush.features))
        self._kept += [params, array, features]
        return _c.BrushDescriptor(
            len(params),
            brush.id.encode(),
            (brush.name or brush.__name__).encode(),
            brush.vendor.encode(),
            brush.version.encode(),
            brush.help.encode() or None,
            features,
            array,
            _bits(brush.inputs, INPUTS, f"brush {brush.id}: inputs"),
            _bits(brush.outputs, OUTPUTS, f"brush {brush.id}: outputs"),
            _number(OVERLAPS, brush.overlap, f"brush {brush.id}: overlap"),
        )

    def _param(self, param: Param[Any]) -> _c.ParamInfo:
        info = _c.ParamInfo(param.kind, param.id.encode(), str(param.name).encode(), param.help.encode() or None, 1)
        info.dynamic = int(param.dynamic)
        self._ranges(info, param)
        self._default(info, param)
        return info

    def _ranges(self, info: _c.ParamInfo, param: Param[Any]) -> None:
        hard = getattr(param, "hard", None)
        if hard is None:
            return
        info.unit = _number(UNITS, getattr(param, "unit"), f"parameter {param.id}: unit")
        info.hard_min, info.hard_max = hard
        info.soft_min, info.soft_max = getattr(param, "soft")

    def _default(self, info: _c.ParamInfo, param: Param[Any]) -> None:
        default, kind = param.default, param.kind
        if kind == 4:
            choices = getattr(param, "choices")
            info.choices = _c.texts(list(choices))
            info.default_number = choices.index(default)
        elif kind == 5:
            info.default_colour[:] = default
        elif kind == 6:
            info.default_file = None if default is None else default.encode()
        elif kind == 7:
            knots = (c_float * (2 * len(default)))(*(number for knot in default for number in knot))
            self._kept.append(knots)
            info.default_knots = ctypes.cast(knots, POINTER(c_float))
            info.default_knot_count = len(default)
        elif kind == 8:
            info.default_text = default.encode()
        else:
            info.default_number = default
