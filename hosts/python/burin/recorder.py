"""Records what users draw as `.stroke` files, docs/stroke_format.md."""

from __future__ import annotations

import json
import os
import weakref
from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _c
from ._settings import Setting, dynamics_of, fields_of
from .errors import Error
from .samples import SAMPLE, samples


class Camera:
    """The camera of strokes on a screen. Matrices have OpenGL's conventions, clip = projection @ view @ position; the viewport
    is in pixels."""

    def __init__(self, view: ArrayLike, projection: ArrayLike, width: int, height: int) -> None:
        self.view = np.asarray(view, np.float64).reshape(4, 4)
        self.projection = np.asarray(projection, np.float64).reshape(4, 4)
        self.width, self.height = width, height

    def _in_c(self) -> _c.RecorderCamera:
        camera = _c.RecorderCamera(width=self.width, height=self.height)
        camera.view[:] = self.view.T.ravel()  # by columns
        camera.projection[:] = self.projection.T.ravel()
        return camera


def _json_setting(value: Any) -> Any:
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, np.generic) or isinstance(value, np.ndarray):
        return value.tolist()
    return value


def _json(settings: dict[str, Setting]) -> str:
    """The settings of "begin"."""
    given: dict[str, Any] = {key: value for key, value in settings.items() if value is not None}
    if isinstance(given.get("dynamics"), dict):
        given["dynamics"] = [
            {"target": target, "source": source, "curve": list(curve)}
            for target, (source, curve) in dynamics_of(given["dynamics"])
        ]
    return json.dumps(given, default=_json_setting)


class Recorder:
    """Writes a recording. Every call passes its line to the operating system before it returns: a process that is killed
    loses at most the line that it is writing. A recorder belongs to one thread.

        with burin.Recorder("mine.stroke") as recorder:
            recorder.begin(fields="time pressure", brush="org.burin.groove", radius=0.1)
            recorder.add(samples)
            recorder.end()
    """

    def __init__(
        self,
        path: str | os.PathLike[str],
        *,
        space: str = "object",
        device: str | None = None,
        camera: Camera | None = None,
    ) -> None:
        """Creates or replaces a file. space "object": samples are positions near the surface; "screen": pixels of the
        camera's viewport, from the top left corner. device: name of what the pen was drawn with."""
        options = _c.RecorderOptions(2 if space == "screen" else 1, os.fsencode(path))
        options.device = device.encode() if device is not None else None
        if camera is not None:
            options.camera.contents = camera._in_c()
        error = _c.ErrorText()
        self._pointer = _c.lib.burin_recorder_open(options, error.text)
        if not self._pointer:
            raise Error(str(error))
        self._finalizer = weakref.finalize(self, _c.lib.burin_recorder_close, self._pointer)

    def begin(
        self, *, fields: str | Iterable[str] = (), tool: str = "", eraser: bool = False, **settings: Setting
    ) -> None:
        """Begins a stroke. Settings are those of docs/stroke_format.md, as Session.begin() takes them. tool: what draws it,
        "pen", "touch", "mouse" or the like; eraser: it is the pen's eraser, or an eraser tool."""
        stroke = _c.RecordedStroke(fields_of(fields), _json(settings).encode(), tool.encode(), eraser)
        _c.call("burin_recorder_begin", self._pointer, stroke)

    def add(self, position: Any, **pen: ArrayLike) -> None:
        """Adds samples, as Session.add() takes them, without rays."""
        given = position if getattr(position, "dtype", None) == SAMPLE else samples(position, **pen)
        for one in np.atleast_1d(given):
            place = tuple(one["position"])
            sample = _c.RecordedSample(one["pressure"], one["time"], place, *one["tilt"], one["twist"], one["barrel"])
            _c.call("burin_recorder_add", self._pointer, sample)

    def end(self) -> None:
        """Ends the open stroke."""
        _c.call("burin_recorder_end", self._pointer)

    def close(self) -> None:
        """Closes the file."""
        self._finalizer()
        self._pointer = None

    def __enter__(self) -> Recorder:
        return self

    def __exit__(self, *_exception: object) -> None:
        self.close()
