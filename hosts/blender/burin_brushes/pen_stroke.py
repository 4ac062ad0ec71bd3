"""A stroke of the pen on an object: samples to the session and the recording, and what changed to the mesh."""

from __future__ import annotations

import math
import time
from pathlib import Path
from typing import Any

import bpy
import burin
import numpy as np

from . import brushes, mesh_io, object_session, settings, view_rays


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
        self.object = context.object
        self._region = context.region
        self._kept = object_session.session_of(brushes.library(), self.object)
        self._shown = self._kept.local.copy()
        self._start = time.perf_counter()
        self._waiting: list[Any] = []
        self._recorder: burin.Recorder | None = None
        self._recording: Path | None = None
        matrix = np.array(self.object.matrix_world)
        corners = np.array(self.object.bound_box) @ matrix[:3, :3].T + matrix[:3, 3]
        view = context.region_data
        size = (self._region.width, self._region.height)
        self._camera = view_rays.drawing_camera(view.view_matrix, view.window_matrix, size, corners)
        self._open(context.scene.burin, "time pressure tilt" if event.is_tablet else "time", matrix[:3, 3])

    def _open(self, chosen: Any, fields: str, origin: Any) -> None:
        given = settings.stroke_settings(chosen, pressure="pressure" in fields)
        self._kept.session.begin(fields=fields, **given, **settings.symmetry(chosen, origin))
        if chosen.record:
            try:
                self._recording = next_recording(chosen.record)
                self._recorder = burin.Recorder(self._recording, space="screen", device="Blender", camera=self._camera)
                self._recorder.begin(fields=fields, **given)
            except (burin.Error, OSError):
                self.cancel()
                raise

    def add(self, event: Any) -> None:
        """Takes a sample, which show() draws with those before it."""
        x, y = event.mouse_x - self._region.x + 0.5, self._region.height - (event.mouse_y - self._region.y + 0.5)
        pen = {"time": time.perf_counter() - self._start, **pen_of(event)}
        origin, direction = view_rays.pixel_ray(self._camera, x, y)
        self._waiting.append(burin.samples(origin, direction=direction, **pen))
        if self._recorder:
            self._recorder.add((x, y, 0), **pen)

    def _draw(self) -> bool:
        if self._waiting:
            self._kept.session.add(np.concatenate(self._waiting))
            self._waiting.clear()
        return self._kept.drawn(self._shown)

    def show(self) -> None:
        """Draws what waits, and shows it."""
        if self._draw():
            mesh_io.write_positions(self.object.data, self._shown)

    def end(self) -> None:
        """Ends the stroke. The mesh is last: a recording that cannot be written fails the stroke."""
        if self._recorder:
            self._recorder.end()
        self._draw()
        self._kept.session.end()
        self._kept.drawn(self._shown)
        self._kept.keep(self.object, self._shown)
        if self._recorder:
            self._recorder.close()

    def cancel(self) -> None:
        """Takes the stroke back, and its recording; also after a failure, which has dropped it."""
        self._kept.session.cancel()
        self._kept.session.update("positions")
        mesh_io.write_positions(self.object.data, self._kept.local)
        if self._recorder:
            self._recorder.close()
        if self._recording:
            self._recording.unlink(missing_ok=True)
