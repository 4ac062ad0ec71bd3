"""Settings of strokes as keyword arguments, and as the texts that the library takes."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Union

from .errors import InvalidArgument

Value = Union[bool, int, float, str, "os.PathLike[str]", Sequence[float]]
"""A value of a setting or parameter: true or false, a number, a text, a path, or numbers."""

Curve = Sequence[float]
"""Knots x0, y0, x1, y1, ... with increasing x; linear between them."""

Setting = Union[Value, Mapping[str, Value], Mapping[str, tuple[str, Curve]], None]
"""What a keyword argument of Session.begin() may be; None: not given."""

PEN_FIELDS = {"time": 1, "pressure": 2, "tilt": 4, "twist": 8, "barrel": 16}


def fields_of(names: str | Iterable[str]) -> int:
    """The bits BURIN_PEN_* of what a pen reports: names, or a text of names between spaces."""
    bits = 0
    for name in names.split() if isinstance(names, str) else names:
        if name not in PEN_FIELDS:
            raise InvalidArgument(f"fields: a pen reports no {name!r}, but {', '.join(PEN_FIELDS)}")
        bits |= PEN_FIELDS[name]
    return bits


def text_of(value: Any) -> str:
    """A value as the command line has it. Numbers keep all digits."""
    if isinstance(value, str):
        return value
    if isinstance(value, os.PathLike):
        return str(os.fspath(value))
    if value is True or value is False or type(value).__name__ == "bool_":
        return "true" if value else "false"
    try:
        return repr(value) if isinstance(value, int) else repr(float(value))
    except TypeError:
        return ",".join(repr(float(number)) for number in value)


def dynamics_of(value: Any) -> Iterable[tuple[str, tuple[str, Curve]]]:
    """Targets with the source and the curve of each."""
    for target, given in value.items():
        if not (isinstance(given, (tuple, list)) and len(given) == 2):
            raise InvalidArgument(f"dynamics: {target}: must be (source, curve), not {given!r}")
    found: Iterable[tuple[str, tuple[str, Curve]]] = value.items()
    return found


def setting_texts(settings: Mapping[str, Setting]) -> list[str]:
    """Texts "KEY=VALUE". The library refuses keys that it does not know, by their names."""
    lines: list[str] = []
    for key, value in settings.items():
        if value is None:
            continue
        if key == "params" and isinstance(value, Mapping):
            lines += [f"params={name}={text_of(one)}" for name, one in value.items()]
        elif key == "dynamics" and isinstance(value, Mapping):
            lines += [f"dynamics={target}={source}:{text_of(curve)}" for target, (source, curve) in dynamics_of(value)]
        elif isinstance(value, Mapping):
            raise InvalidArgument(f"{key}: takes no names and values, only params and dynamics do")
        elif key == "closed" and isinstance(value, bool):
            lines.append("closed=yes" if value else "closed=no")
        else:
            lines.append(f"{key}={text_of(value)}")
    return lines
