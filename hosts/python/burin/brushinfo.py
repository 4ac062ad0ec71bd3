"""What brushes tell of themselves: panels are made of it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Union

from . import _c

ParamValue = Union[bool, int, float, str, tuple[float, ...], tuple[tuple[float, float], ...], None]

PARAM_TYPES = ("unknown", "float", "int", "bool", "choice", "colour", "file", "curve", "text")
UNITS = ("unknown", "none", "radius", "length", "angle", "time")
OVERLAPS = ("unknown", "strongest", "latest", "max", "min", "add", "average")

INPUTS = (
    "t d radius stretch footprint position normal e1 mean_curvature laplacian displacement mask colour sheet visit_count "
    "node_id symmetry pressure tilt twist speed time foot fine_position fine_normal "
    "fine_mean_curvature end_distance"
).split()
"""Inputs that brushes may read, in the order of the bits BURIN_INPUT_*."""

OUTPUTS = ("displacement", "mask", "colour")
"""Outputs that brushes may write, in the order of the bits BURIN_OUTPUT_*."""


@dataclass(frozen=True)
class ParamInfo:
    """A parameter of a brush, as burin/abi/param.h describes it.

    `hard` is the range of values that are taken, `soft` the range of a slider; both are of "float" and "int".
    `default` is of the type: a number; for "bool" True or False; for "choice" its id; for "colour" linear red, green, blue
    and coverage, 0..1; for "file" a path, "" for none, None where the user must choose one; for "curve" pairs (x, y); for
    "text" a text. `unit` is "none", "radius" (multiples of the stroke's radius), "length" (object units), "angle"
    (radians) or "time" (seconds).
    """

    id: str
    name: str
    help: str
    type: str
    unit: str
    default: ParamValue
    hard: tuple[float, float]
    soft: tuple[float, float]
    choices: tuple[str, ...]
    dynamic: bool


@dataclass(frozen=True)
class BrushInfo:
    """A brush, as burin/abi/brush.h describes it."""

    id: str
    name: str
    vendor: str
    version: str
    help: str
    features: tuple[str, ...]
    params: tuple[ParamInfo, ...]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    overlap: str

    def param(self, id: str) -> ParamInfo:
        """The parameter with this id. Raises KeyError if there is none."""
        for param in self.params:
            if param.id == id:
                return param
        raise KeyError(f"brush {self.id} has no parameter {id!r}")


def _text(value: bytes | None) -> str:
    return value.decode() if value else ""


def _name(names: tuple[str, ...], number: int) -> str:
    return names[number] if 0 <= number < len(names) else names[0]


def _default(info: Any, type_name: str, choices: tuple[str, ...]) -> ParamValue:
    if type_name == "bool":
        return bool(info.default_number)
    if type_name == "int":
        return int(info.default_number)
    if type_name == "choice":
        return choices[int(info.default_number)]
    if type_name == "colour":
        return tuple(info.default_colour)
    if type_name == "file":
        return None if info.default_file is None else _text(info.default_file)
    if type_name == "text":
        return _text(info.default_text) if _c.has(info, "default_text") else ""
    if type_name == "curve":
        knots = info.default_knots
        return tuple((knots[2 * i], knots[2 * i + 1]) for i in range(info.default_knot_count))
    return float(info.default_number)


def _param(info: Any) -> ParamInfo:
    type_name = _name(PARAM_TYPES, info.type)
    choices = _c.strings(info.choices) if type_name == "choice" else ()
    return ParamInfo(
        id=_text(info.id),
        name=_text(info.name),
        help=_text(info.help),
        type=type_name,
        unit=_name(UNITS, info.unit),
        default=_default(info, type_name, choices),
        hard=(info.hard_min, info.hard_max),
        soft=(info.soft_min, info.soft_max),
        choices=choices,
        dynamic=bool(info.dynamic),
    )


def brush_info(descriptor: Any) -> BrushInfo:
    """What a burin_brush_descriptor tells."""
    return BrushInfo(
        id=_text(descriptor.id),
        name=_text(descriptor.name),
        vendor=_text(descriptor.vendor),
        version=_text(descriptor.version),
        help=_text(descriptor.help),
        features=_c.strings(descriptor.features),
        params=tuple(_param(descriptor.params[i].contents) for i in range(descriptor.param_count)),
        inputs=tuple(name for bit, name in enumerate(INPUTS) if descriptor.inputs_read >> bit & 1),
        outputs=tuple(name for bit, name in enumerate(OUTPUTS) if descriptor.outputs_written >> bit & 1),
        overlap=_name(OVERLAPS, descriptor.overlap) if _c.has(descriptor, "overlap") else "unknown",
    )
