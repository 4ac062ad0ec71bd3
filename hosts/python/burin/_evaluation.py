"""What brushes in Python get: nodes of the chart as arrays over the library's memory."""

from __future__ import annotations

from ctypes import POINTER, Structure, c_char_p, c_double, c_float, c_uint32, c_uint64, c_void_p
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from ._memory import view

if TYPE_CHECKING:
    from .brush import Param

Floats = NDArray[np.float32]
V = TypeVar("V")


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


class Context:
    """The stroke as a whole, as far as it has been drawn. Lengths are in object units."""

    def __init__(self, context: Any) -> None:
        self.length: float = context.length
        """Arc length so far."""
        self.radius_min: float = context.radius_min
        """Lower bound of the radius over the whole stroke."""
        self.radius_max: float = context.radius_max
        self.object_scale: float = context.object_scale
        """Diagonal of the surface's bounding box."""
        self.seed: int = context.seed
        """Key of random numbers, so that a stroke drawn again is the same."""
        self.pass_number: int = context.pass_
        self.dab_t: float = context.dab_t
        """Of a dab its arc length along the stroke."""
        self._flags: int = context.flags

    @property
    def closed(self) -> bool:
        """Whether t is periodic in `length`."""
        return bool(self._flags & 1)

    @property
    def final(self) -> bool:
        """Whether the piece has ended: `length` stays as it is."""
        return bool(self._flags & 2)

    @property
    def mirrored(self) -> bool:
        """Whether this is a mirror image: d and `across` point to the right of the direction of travel."""
        return bool(self._flags & 4)

    @property
    def dab(self) -> bool:
        """Whether this is one of a row of dabs: t and d are geodesic normal coordinates around it."""
        return bool(self._flags & 8)


def _column(array: Any, count: int, kind: str = "<f4", writable: bool = False) -> NDArray[Any]:
    return view(array.data, (count,), (4 * array.stride,), kind, writable)


def _columns(arrays: list[Any], count: int, writable: bool = False) -> Floats:
    """Several arrays as one of shape (count, len(arrays)): without a copy where they are equally far apart."""
    first, step = arrays[0], arrays[1].data - arrays[0].data
    if all(one.data == first.data + i * step and one.stride == first.stride for i, one in enumerate(arrays)):
        return view(first.data, (count, len(arrays)), (4 * first.stride, step), "<f4", writable)
    if writable:
        raise NotImplementedError("the arrays of an output are not equally far apart")
    return np.stack([_column(one, count) for one in arrays], axis=1)


class _Values:
    """Values of parameters. count: of the nodes; None: the values before they vary."""

    def __init__(self, values: Any, count: int | None) -> None:
        self._values = values
        self._count = count

    def get(self, index: int, kind: int) -> Any:
        value = self._values[index]
        if kind in (6, 8):
            return value.text.decode()
        if kind == 7:
            return view(value.knots, (value.knot_count, 2))
        count = 1 if self._count is None else self._count
        found = _columns(list(value.colour), count) if kind == 5 else _column(value.number, count)
        return found[0] if self._count is None else found


class Start:
    """A stroke that begins. `start[self.NAME]` is the value of a parameter: a number, a text or an array."""

    passes: int = 1
    """evaluate() runs over the whole stroke once per pass."""
    end_influence: float = 0.0
    """How far back from the end results depend on `stroke.length` or `stroke.final`, object units; inf is allowed."""

    def __init__(self, context: Any, params: Any, order: dict[str, int]) -> None:
        self.stroke = Context(context)
        self._values = _Values(params.values, None)
        self._order = order

    def __getitem__(self, param: Param[V]) -> V:
        found: V = self._values.get(self._order[param.id], param.kind)
        return found


class Batch:
    """Nodes of the chart. Arrays have the shape (n,), vectors (n, 3) and colours (n, 4); they are float32 views of the
    library's memory, to be read during the call only. burin/abi/stroke.h has their meanings. An input that the brush does
    not declare raises AttributeError."""

    __slots__ = ("_batch", "_outputs", "_context", "_order", "_params", "size", "state")

    def __init__(self, batch: Any, outputs: Any, context: Any, order: dict[str, int], state: object) -> None:
        self._batch = batch
        self._outputs = outputs
        self._context = context
        self._order = order
        self._params = _Values(batch.params.contents.values, batch.count)
        self.size: int = batch.count
        """n, the number of nodes."""
        self.state: Any = state
        """What begin() returned."""

    @property
    def stroke(self) -> Context:
        """The stroke as a whole."""
        return Context(self._context)

    def __len__(self) -> int:
        return self.size

    def __getitem__(self, param: Param[V]) -> V:
        found: V = self._params.get(self._order[param.id], param.kind)
        return found

    def distance(self) -> Floats:
        """The distance of each node to the stroke, object units: |d| beside it, the distance to the end in round caps."""
        t, d, flags = self.t, self.d, self._context.flags
        after = t - np.float32(self._context.length)
        if flags & 1:
            return np.abs(d)
        beyond = np.where(after > 0, after, np.minimum(t, 0)).astype(np.float64)
        across = d.astype(np.float64)
        return np.where(beyond == 0, np.abs(d), np.sqrt(beyond * beyond + across * across).astype(np.float32))

    def _input(self, name: str, kind: str = "<f4") -> NDArray[Any]:
        array = getattr(self._batch, name)
        if not array.data:
            self._refuse(name)
        return _column(array, self.size, kind)

    def _vectors(self, name: str, members: str = "xyz") -> Floats:
        vectors = getattr(self._batch, name)
        if not getattr(vectors, members[0]).data:
            self._refuse(name)
        return _columns([getattr(vectors, member) for member in members], self.size)

    def _refuse(self, name: str) -> None:
        raise AttributeError(f"the brush does not declare {name} among its inputs or outputs")

    def _output(self, name: str) -> Floats:
        array = getattr(self._outputs, name)
        if not array.data:
            self._refuse(name)
        return _column(array, self.size, writable=True)

    @property
    def t(self) -> Floats:
        """Arc length along the stroke, object units; below 0 and above the length in round caps."""
        return self._input("t")

    @property
    def d(self) -> Floats:
        """Signed geodesic distance to the stroke, object units; positive on its left."""
        return self._input("d")

    @property
    def radius(self) -> Floats:
        """Half the width of the stroke at t, object units, above 0."""
        return self._input("radius")

    @property
    def stretch(self) -> Floats:
        """|dP/dt| at constant d; 1 on the stroke."""
        return self._input("stretch")

    @property
    def footprint_t(self) -> Floats:
        """Size of the node's cell along the stroke, object units; of the input "footprint"."""
        return self._input("footprint_t")

    @property
    def footprint_d(self) -> Floats:
        """Size of the node's cell across the stroke, object units; of the input "footprint"."""
        return self._input("footprint_d")

    @property
    def mean_curvature(self) -> Floats:
        """Of the base surface, 1 / object units, positive where convex."""
        return self._input("mean_curvature")

    @property
    def pressure(self) -> Floats:
        """At t: 0..1; 1 where the pen reports none."""
        return self._input("pressure")

    @property
    def tilt_x(self) -> Floats:
        """At t: radians from upright, towards +x; of the input "tilt"."""
        return self._input("tilt_x")

    @property
    def tilt_y(self) -> Floats:
        """At t: radians from upright, towards +y; of the input "tilt"."""
        return self._input("tilt_y")

    @property
    def twist(self) -> Floats:
        """At t: radians, 0..2 pi."""
        return self._input("twist")

    @property
    def speed(self) -> Floats:
        """At t: object units per second."""
        return self._input("speed")

    @property
    def time(self) -> Floats:
        """At t: seconds since the stroke began."""
        return self._input("time")

    @property
    def fine_mean_curvature(self) -> Floats:
        """Of the fine surface, 1 / object units, positive where convex."""
        return self._input("fine_mean_curvature")

    @property
    def position(self) -> Floats:
        """Base surface, object units; from the second pass on displaced by the passes before."""
        return self._vectors("position")

    @property
    def normal(self) -> Floats:
        """Base surface, unit, outward."""
        return self._vectors("normal")

    @property
    def e1(self) -> Floats:
        """Along the stroke, unit, tangent to the base surface."""
        return self._vectors("e1")

    @property
    def laplacian(self) -> Floats:
        """Mean of the neighbours minus the vertex, fine surface."""
        return self._vectors("laplacian")

    @property
    def displacement(self) -> Floats:
        """Of the pass before: along, across and up."""
        return self._vectors("displacement")

    @property
    def foot(self) -> Floats:
        """At t: mean position of the curve within one radius before and after."""
        return self._vectors("foot")

    @property
    def foot_normal(self) -> Floats:
        """At t: mean normal over the same part, unit; of the input "foot"."""
        return self._vectors("foot_normal")

    @property
    def fine_position(self) -> Floats:
        """Fine surface, object units; from the second pass on displaced by the passes before."""
        return self._vectors("fine_position")

    @property
    def fine_normal(self) -> Floats:
        """Fine surface, unit, outward."""
        return self._vectors("fine_normal")

    @property
    def sheet(self) -> NDArray[np.uint32]:
        """Number of the visit to the vertex, from 0."""
        return self._input("sheet", "<u4")

    @property
    def visit_count(self) -> NDArray[np.uint32]:
        """How often the stroke visits the vertex."""
        return self._input("visit_count", "<u4")

    @property
    def node_id(self) -> NDArray[np.uint32]:
        """Stable number of the vertex: counter of random numbers."""
        return self._input("node_id", "<u4")

    @property
    def symmetry(self) -> NDArray[np.uint32]:
        """Symmetric image, 0 = the stroke as drawn."""
        return self._input("symmetry", "<u4")

    @property
    def mask_before(self) -> Floats:
        """The input "mask": of the vertex before the stroke, 0 = protected .. 1 = free."""
        return self._input("mask")

    @property
    def colour_before(self) -> Floats:
        """The input "colour": of the vertex before the stroke, linear red, green, blue and coverage, 0..1."""
        return self._vectors("colour", "rgba")

    @property
    def along(self) -> Floats:
        """Displacement along e1, object units: an output."""
        return self._output("along")

    @along.setter
    def along(self, values: Any) -> None:
        self._output("along")[:] = values

    @property
    def across(self) -> Floats:
        """Displacement along e2, object units: an output."""
        return self._output("across")

    @across.setter
    def across(self, values: Any) -> None:
        self._output("across")[:] = values

    @property
    def up(self) -> Floats:
        """Displacement along the normal, object units: an output."""
        return self._output("up")

    @up.setter
    def up(self, values: Any) -> None:
        self._output("up")[:] = values

    @property
    def mask(self) -> Floats:
        """The mask to be, 0..1: an output."""
        return self._output("mask")

    @mask.setter
    def mask(self, values: Any) -> None:
        self._output("mask")[:] = values

    @property
    def colour(self) -> Floats:
        """The colour to be, linear red, green, blue and coverage, 0..1: an output."""
        if not self._outputs.colour[0].data:
            self._refuse("colour")
        return _columns(list(self._outputs.colour), self.size, writable=True)

    @colour.setter
    def colour(self, values: Any) -> None:
        self.colour[:] = values
