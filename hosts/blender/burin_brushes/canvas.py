"""What strokes are drawn on: the active object, and the other meshes that are selected."""

from __future__ import annotations

from typing import Any

import bpy
import burin
import numpy as np

from . import brushes, mesh_io, object_session, preview, vertex_values


def _objects(context: Any) -> list[Any]:
    active = context.object
    meshes = [other for other in context.selected_objects if other.type == "MESH" and other != active]
    return [active, *sorted(meshes, key=lambda other: other.name_full)]


def _add_object(solid: burin.Mesh, beside: Any) -> None:
    """Makes an object of a solid, where the one is that it was drawn on."""
    name = f"{beside.name} solid"
    mesh = bpy.data.meshes.new(name)
    mesh_io.fill(mesh, solid)
    made = bpy.data.objects.new(name, mesh)
    made.matrix_world = beside.matrix_world
    beside.users_collection[0].objects.link(made)


class Canvas:
    """Sessions of objects, and what these show while a stroke is open."""

    def __init__(self, context: Any, outputs: set[str]) -> None:
        """For strokes of brushes with these outputs. Raises Refused for an object that cannot be drawn on."""
        self._objects = _objects(context)
        self._check_meshes()
        names = vertex_values.of_outputs(outputs)
        self._paints = "colours" in names
        self._kept = [object_session.session_of(brushes.library(), object, names) for object in self._objects]
        self._shown = [kept.shown(names) for kept in self._kept]
        sessions = [kept.session for kept in self._kept]
        self.pen: burin.Session | burin.Group = sessions[0] if len(sessions) == 1 else burin.Group(sessions)
        """What draws."""
        self._preview: preview.Preview | None = None

    def preview(self) -> None:
        """From now on large objects are shown without Blender's evaluation, until what was drawn is kept or cancelled. It
        has no colours of vertices."""
        if self._paints:
            return
        whole = [(object, kept) for kept, object, _ in self._each() if not kept.hides_faces]
        large = [(object, kept.parts) for object, kept in whole if preview.is_wanted(object)]
        if large:
            self._preview = preview.Preview(large)

    def _end_preview(self) -> None:
        shown, self._preview = self._preview, None
        if shown:
            shown.close()

    def _check_meshes(self) -> None:
        users: dict[Any, Any] = {}
        for object in self._objects:
            other = users.setdefault(object.data, object)
            if other != object:
                raise object_session.Refused(f"{other.name} and {object.name}: share a mesh; select one of them")

    @property
    def corners(self) -> mesh_io.Floats:
        """Those of boxes in the world around what the objects show."""
        boxes = []
        for object in self._objects:
            matrix = np.array(object.matrix_world)
            boxes.append(np.array(object.bound_box) @ matrix[:3, :3].T + matrix[:3, 3])
        return np.concatenate(boxes)

    def _each(self) -> Any:
        return zip(self._kept, self._objects, self._shown)

    def show(self) -> None:
        """Shows what was drawn since. Masks are not seen in object mode."""
        for kept, object, shown in self._each():
            changed = [name for name in kept.drawn(shown) if name != "masks"]
            if changed and self._preview and self._preview.shows(object):
                preview.redraw()
            else:
                kept.write(object, changed, shown)

    def keep(self) -> None:
        """Shows what was drawn, which then is the objects' own, and adds objects for solids."""
        self._end_preview()
        solids = self._take_solids()
        try:
            for kept, object, shown in self._each():
                kept.drawn(shown)
                kept.keep(object, shown)
        except BaseException:
            self._forget()
            raise
        for solid, object in solids:
            _add_object(solid, object)

    def _take_solids(self) -> list[tuple[burin.Mesh, Any]]:
        try:
            return [(solid, object) for kept, object, _ in self._each() for solid in kept.take_solids()]
        except burin.Error:
            self._forget()
            raise

    def _forget(self) -> None:
        """Drops the sessions, which have strokes that the objects have not."""
        for object in self._objects:
            object_session.forget(object)

    def cancel(self) -> None:
        """Takes the open stroke back, also after a failure, which has dropped it."""
        self._end_preview()
        self.pen.cancel()
        for kept, object, _ in self._each():
            kept.drop(object)

    def replay(self, path: str, **given: Any) -> None:
        """Draws all strokes of a recording. If one fails the objects are as before the first."""
        try:
            if isinstance(self.pen, burin.Session):
                self.pen.replay(path, **given)
            else:
                for stroke in burin.read_recording(path).strokes:
                    self.pen.draw(stroke, **given)
        except burin.Error:
            self._forget()
            raise
        self.keep()
