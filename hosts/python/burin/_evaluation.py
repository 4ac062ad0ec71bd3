"""What brushes in Python get: nodes of the chart as arrays over the library's memory."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Generic, TypeVar, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._memory import view

if TYPE_CHECKING:
    from .brush import Param

Floats = NDArray[np.float32]
Indices = NDArray[np.uint32]
A = TypeVar("A")
V = TypeVar("V")


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


def _declared(columns: list[Any], name: str, what: str) -> list[Any]:
    if not columns[0].data:
        raise AttributeError(f"the brush does not declare {name} among its {what}")
    return columns


class Input(Generic[A]):
    """An input of a batch: a read-only view of the library's memory."""

    def __init__(self, text: str, *, member: str = "", components: str = "", kind: str = "<f4") -> None:
        self.__doc__ = text
        self._member, self._components, self._kind = member, components, kind

    def __set_name__(self, owner: type, name: str) -> None:
        self._member = self._member or name

    @overload
    def __get__(self, batch: None, owner: type) -> Input[A]:
        ...

    @overload
    def __get__(self, batch: Batch, owner: type) -> A:
        ...

    def __get__(self, batch: Batch | None, owner: type) -> Input[A] | Any:
        if batch is None:
            return self
        member = getattr(batch._batch, self._member)
        columns = [getattr(member, one) for one in self._components] or [member]
        _declared(columns, self._member, "inputs")
        return _columns(columns, batch.size) if self._components else _column(member, batch.size, self._kind)


class Output:
    """An output of a batch: a writable view of the library's memory, to which any values may be assigned."""

    def __init__(self, text: str) -> None:
        self.__doc__ = text

    def __set_name__(self, owner: type, name: str) -> None:
        self._name = name

    @overload
    def __get__(self, batch: None, owner: type) -> Output:
        ...

    @overload
    def __get__(self, batch: Batch, owner: type) -> Floats:
        ...

    def __get__(self, batch: Batch | None, owner: type) -> Output | Floats:
        if batch is None:
            return self
        member = getattr(batch._outputs, self._name)
        is_colour = self._name == "colour"
        columns = _declared(list(member) if is_colour else [member], self._name, "outputs")
        if is_colour:
            return _columns(columns, batch.size, writable=True)
        return _column(member, batch.size, writable=True)

    def __set__(self, batch: Batch, values: ArrayLike) -> None:
        self.__get__(batch, type(batch))[...] = values


class Batch:
    """Nodes of the chart. Arrays have the shape (n,), vectors (n, 3) and colours (n, 4); they are float32 views of the
    library's memory, to be read during the call only. burin/abi/stroke.h has their meanings. An input that the brush does
    not declare raises AttributeError. `mask` and `colour` are outputs, `mask_before` and `colour_before` the inputs of these
    names."""

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

    t = Input[Floats]("Arc length along the stroke, object units; below 0 and above the length in round caps.")
    d = Input[Floats]("Signed geodesic distance to the stroke, object units; positive on its left.")
    radius = Input[Floats]("Half the width of the stroke at t, object units, above 0.")
    stretch = Input[Floats]("|dP/dt| at constant d; 1 on the stroke.")
    footprint_t = Input[Floats]('Size of the node’s cell along the stroke, object units; of the input "footprint".')
    footprint_d = Input[Floats]('Size of the node’s cell across the stroke, object units; of the input "footprint".')
    mean_curvature = Input[Floats]("Of the base surface, 1 / object units, positive where convex.")
    pressure = Input[Floats]("At t: 0..1; 1 where the pen reports none.")
    tilt_x = Input[Floats]('At t: radians from upright, towards +x; of the input "tilt".')
    tilt_y = Input[Floats]('At t: radians from upright, towards +y; of the input "tilt".')
    twist = Input[Floats]("At t: radians, 0..2 pi.")
    speed = Input[Floats]("At t: object units per second.")
    time = Input[Floats]("At t: seconds since the stroke began.")
    fine_mean_curvature = Input[Floats]("Of the fine surface, 1 / object units, positive where convex.")
    end_distance = Input[Floats](
        "From the stroke's nearer end along it, at most the end influence, object units; for tapered ends."
    )
    position = Input[Floats](
        "Base surface, object units; from the second pass on displaced by the passes before.", components="xyz"
    )
    normal = Input[Floats]("Base surface, unit, outward.", components="xyz")
    e1 = Input[Floats]("Along the stroke, unit, tangent to the base surface.", components="xyz")
    laplacian = Input[Floats]("Mean of the neighbours minus the vertex, fine surface.", components="xyz")
    displacement = Input[Floats]("Of the pass before: along, across and up.", components="xyz")
    foot = Input[Floats]("At t: mean position of the curve within one radius before and after.", components="xyz")
    foot_normal = Input[Floats]('At t: mean normal over the same part, unit; of the input "foot".', components="xyz")
    fine_position = Input[Floats](
        "Fine surface, object units; from the second pass on displaced by the passes before.", components="xyz"
    )
    fine_normal = Input[Floats]("Fine surface, unit, outward.", components="xyz")
    sheet = Input[Indices]("Number of the visit to the vertex, from 0.", kind="<u4")
    visit_count = Input[Indices]("How often the stroke visits the vertex.", kind="<u4")
    node_id = Input[Indices]("Stable number of the vertex: counter of random numbers.", kind="<u4")
    symmetry = Input[Indices]("Symmetric image, 0 = the stroke as drawn.", kind="<u4")
    mask_before = Input[Floats]('The input "mask": of the vertex before the stroke, 0 = protected .. 1 = free.', member="mask")
    colour_before = Input[Floats](
        'The input "colour": of the vertex before the stroke, linear red, green, blue and coverage, 0..1.', member="colour", components="rgba"
    )
    along = Output("Displacement along e1, object units: an output.")
    across = Output("Displacement along e2, object units: an output.")
    up = Output("Displacement along the normal, object units: an output.")
    mask = Output("The mask to be, 0..1: an output.")
    colour = Output("The colour to be, linear red, green, blue and coverage, 0..1: an output.")
