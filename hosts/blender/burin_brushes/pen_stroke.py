"""A stroke of the pen on objects: samples to the sessions and the recording, and what changed to the meshes."""

from __future__ import annotations

import math
import time
from pathlib import Path
from typing import Any

import bpy
import burin
import numpy as np

from . import canvas, settings, view_rays


def pen_of(event: Any) -> dict[str, Any]:
    """What the pen of an event reports. Blender's tilt is 1 for a pen that lies flat."""
    if not event.is_tablet:
        return {}
    return {"pressure": event.pressure, "tilt": tuple(math.pi / 2 * part for part in event.tilt)}


def next_recording(folder: str) -> Path:
    """The file of the next stroke: 0001.stroke, 0002.stroke, ..."""
    path = Path(bpy.path.abspath(folder))
    path.mkdir(parents=True, exist_ok=True)
    numbers = [int(file.stem) for file in path.glob("*.stroke") if file.stem.isdigit()]
    return path / f"{max(numbers, default=0) + 1:04d}.stroke"


class PenStroke:
    """An open stroke."""

    def __init__(self, context: Any, event: Any) -> None:
        self._region = context.region
        self._canvas = canvas.Canvas(context, set(settings.chosen(context.scene.burin).outputs))
        self._start = time.perf_counter()
        self._waiting: list[Any] = []
        self._recorder: burin.Recorder | None = None
        self._recording: Path | None = None
        view = context.region_data
        size = (self._region.width, self._region.height)
        corners = self._canvas.corners
        self._camera = view_rays.drawing_camera(view.view_matrix, view.window_matrix, size, corners)
        fields = "time pressure tilt" if event.is_tablet else "time"
        try:
            self._open(context.scene.burin, fields, context.object.matrix_world.translation)
            self._canvas.preview()
        except BaseException:
            self.cancel()
            raise

    def _open(self, chosen: Any, fields: str, origin: Any) -> None:
        given = settings.stroke_settings(chosen, pressure="pressure" in fields)
        self._canvas.pen.begin(fields=fields, **given, **settings.symmetry(chosen, origin))
        if chosen.record:
            self._recording = next_recording(chosen.record)
            self._recorder = burin.Recorder(self._recording, space="screen", device="Blender", camera=self._camera)
            self._recorder.begin(fields=fields, **given)

    def add(self, event: Any) -> None:
        """Takes a sample, which show() draws with those before it."""
        x, y = event.mouse_x - self._region.x + 0.5, self._region.height - (event.mouse_y - self._region.y + 0.5)
        pen = {"time": time.perf_counter() - self._start, **pen_of(event)}
        origin, direction = view_rays.pixel_ray(self._camera, x, y)
        self._waiting.append(burin.samples(origin, direction=direction, **pen))
        if self._recorder:
            self._recorder.add((x, y, 0), **pen)

    def _draw(self) -> None:
        if self._waiting:
            self._canvas.pen.add(np.concatenate(self._waiting))
            self._waiting.clear()

    def show(self) -> None:
        """Draws what waits, and shows it."""
        self._draw()
        self._canvas.show()

    def end(self) -> None:
        """Ends the stroke. The meshes are last: a recording that cannot be written fails the stroke."""
        if self._recorder:
            self._recorder.end()
        self._draw()
        self._canvas.pen.end()
        self._canvas.keep()
        if self._recorder:
            self._recorder.close()

    def cancel(self) -> None:
        """Takes the stroke back, and its recording; also after a failure, which has dropped it."""
        self._canvas.cancel()
        if self._recorder:
            self._recorder.close()
        if self._recording:
            self._recording.unlink(missing_ok=True)
