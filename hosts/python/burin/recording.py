"""Recorded strokes, docs/stroke_format.md."""

from __future__ import annotations

import ctypes
import os
import weakref
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _c
from ._memory import view
from ._settings import PEN_FIELDS
from .samples import SAMPLE


@dataclass(frozen=True)
class RecordedStroke:
    """A stroke of a recording: session.draw(stroke) draws it as `burin replay --refine off` does, and as `burin replay`
    with refine="auto" on a session that refines."""

    settings: dict[str, Any]
    """What was recorded, as keyword arguments of Session.begin(); values of params are texts."""
    fields: tuple[str, ...]
    """What the pen reported, of "time", "pressure", "tilt", "twist", "barrel"."""
    seed: int
    samples: NDArray[np.void]
    """Of type SAMPLE; of a recording on a screen the rays through the camera. A read-only view."""
    tool: str = ""
    """What drew it, "pen", "touch", "mouse" or the like; "" if unknown."""
    eraser: bool = False
    """Whether it was the pen's eraser, or an eraser tool."""

    def settings_with(self, given: dict[str, Any]) -> dict[str, Any]:
        """The recorded settings, of which those that are given take the place: of parameters name by name, of dynamics target
        by target. What was recorded for another brush is left out."""
        given = {key: value for key, value in given.items() if value is not None}
        merged = {**self.settings, **given}
        same_brush = merged.get("brush") == self.settings.get("brush")
        recorded = dict(self.settings.get("dynamics", {}))
        if not same_brush:
            recorded = {target: one for target, one in recorded.items() if target in ("radius", "strength")}
        merged["dynamics"] = {**recorded, **given.get("dynamics", {})}
        merged["params"] = {**(self.settings.get("params", {}) if same_brush else {}), **given.get("params", {})}
        return merged


@dataclass(frozen=True)
class Recording:
    """A recording."""

    device: str
    """What was drawn with; "" if the file does not say."""
    strokes: tuple[RecordedStroke, ...]


class _File:
    """A burin_recording, which lives as long as arrays over its memory."""

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self.pointer = ctypes.c_void_p()
        _c.call("burin_recording_read", os.fsencode(path), self.pointer)
        self._finalizer = weakref.finalize(self, _c.lib.burin_recording_destroy, self.pointer)


def _settings(texts: tuple[str, ...]) -> dict[str, Any]:
    settings: dict[str, Any] = {}
    for text in texts:
        key, value = text.split("=", 1)
        if key == "params":
            name, _, of_param = value.partition("=")
            settings.setdefault(key, {})[name] = of_param
        elif key == "dynamics":
            target, _, source_curve = value.partition("=")
            source, _, curve = source_curve.partition(":")
            settings.setdefault(key, {})[target] = (source, [float(number) for number in curve.split(",")])
        else:
            settings[key] = _number(value)
    return settings


def _number(text: str) -> float | str:
    try:
        return float(text)
    except ValueError:
        return text


def read_recording(path: str | os.PathLike[str]) -> Recording:
    """Reads a `.stroke` file; `burin import` makes such files of others. Raises Error, which names the file and the line, also
    for a recording that was cut off."""
    file = _File(path)
    strokes = []
    for index in range(_c.lib.burin_recording_stroke_count(file.pointer)):
        stroke = _c.RecordingStroke()
        _c.call("burin_recording_get_stroke", file.pointer, index, stroke)
        strokes.append(
            RecordedStroke(
                _settings(_c.strings(stroke.settings)),
                tuple(name for name, bit in PEN_FIELDS.items() if stroke.fields & bit),
                stroke.seed,
                view(stroke.samples, (stroke.sample_count,), kind=SAMPLE, owner=file),
                stroke.tool.decode(),
                bool(stroke.eraser),
            )
        )
    return Recording(_c.lib.burin_recording_device(file.pointer).decode(), tuple(strokes))
