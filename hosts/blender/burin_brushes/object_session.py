"""Sessions of objects: made when the first stroke is drawn, kept, and brought up to date with what other tools did.

Between strokes the session of an object has the world positions of the mesh, to the bit, so that what a stroke makes does
not depend on whether its session is new. Blender's undo is the only one: a session sees afterwards that positions differ.
"""

from __future__ import annotations

from typing import Any

import burin
import bpy
import numpy as np

from . import mesh_io


class Refused(Exception):
    """A line that tells the user why an object cannot be drawn on."""


class ObjectSession:
    """A session on the mesh of an object."""

    def __init__(self, library: burin.Library, object: Any) -> None:
        mesh = object.data
        self.counts = mesh_io.counts(mesh)
        self.placement = mesh_io.Placement(object.matrix_world)
        self.faces = mesh_io.read_faces(mesh)
        self.local = mesh_io.read_positions(mesh)
        """What the mesh has, of which the session knows."""
        self.faces_are_known = True
        """False after what may have changed faces and left their number as it was."""
        if not len(self.faces.sizes):
            raise Refused(f"{object.name}: there is no face to draw on")
        faces = self.placement.outward(self.faces)
        self.session = burin.Session(library, self.placement.to_world(self.local), faces.corners, faces.sizes)
        self.session.limit_undo(0)
        self.session.update("positions")

    def fits(self, object: Any) -> bool:
        """Whether the faces and the place of the object are those of the session."""
        mesh = object.data
        if self.counts != mesh_io.counts(mesh) or not self.placement.same(mesh_io.Placement(object.matrix_world)):
            return False
        if not self.faces_are_known:
            self.faces_are_known = self.faces.same(mesh_io.read_faces(mesh))
        return self.faces_are_known

    def take_moved(self, object: Any) -> None:
        """Takes the positions of vertices that others moved, at a cost in proportion to them."""
        local = mesh_io.read_positions(object.data)
        moved = mesh_io.changed_range(self.local, local)
        if moved:
            self._take(local, *moved)
            self.local = local

    def _take(self, local: mesh_io.Floats, begin: int, end: int) -> None:
        self.session.write("positions", self.placement.to_world(local[begin:end]), begin)
        self.session.update("positions")

    def drawn(self, shown: mesh_io.Floats) -> bool:
        """Writes what changed since the last call to the local positions `shown`, and tells whether anything did."""
        ranges = self.session.update("positions")
        positions = self.session.values("positions")
        for begin, end in ranges:
            shown[begin:end] = self.placement.to_local(positions[begin:end])
        return len(ranges) > 0

    def keep(self, object: Any, shown: mesh_io.Floats) -> None:
        """Ends a stroke: the mesh and the session get the local positions that are shown."""
        mesh_io.write_positions(object.data, shown)
        if not self.placement.keeps_bits:
            moved = mesh_io.changed_range(self.local, shown)
            if moved:
                self._take(shown, *moved)
        self.local = shown


_sessions: dict[str, ObjectSession] = {}


def _check(object: Any) -> None:
    if object is None or object.type != "MESH":
        raise Refused("select a mesh to draw on")
    if object.mode != "OBJECT":
        raise Refused(f"{object.name}: strokes are drawn in object mode")
    if object.data.library or object.library:
        raise Refused(f"{object.name}: is linked from another file; make it local first")
    if object.data.shape_keys:
        raise Refused(f"{object.name}: has shape keys, which hide what strokes move; apply or remove them first")
    _check_modifiers(object)


def _check_modifiers(object: Any) -> None:
    """Modifiers may stay that leave the shape as it is: strokes are drawn on what the user sees."""
    shown = [modifier.name for modifier in object.modifiers if modifier.show_viewport]
    if not shown:
        return
    evaluated = object.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
    same = mesh_io.counts(evaluated) == mesh_io.counts(object.data)
    if not (same and np.array_equal(mesh_io.read_positions(evaluated), mesh_io.read_positions(object.data))):
        raise Refused(
            f"{object.name}: modifiers change its shape ({', '.join(shown)}); apply them or switch them off in the viewport"
        )


def session_of(library: burin.Library, object: Any) -> ObjectSession:
    """The session of an object, as the object is now. Raises Refused or burin.Error."""
    _check(object)
    kept = _sessions.pop(object.name_full, None)
    try:
        if kept is None or not kept.fits(object):
            kept = None  # its memory is free before there is another
            kept = ObjectSession(library, object)
    except ValueError as fault:
        raise Refused(f"{object.name}: {fault}") from fault
    kept.take_moved(object)
    _sessions[object.name_full] = kept
    return kept


def forget(object: Any) -> None:
    """Drops the session of an object, after a failure that left strokes in it."""
    _sessions.pop(object.name_full, None)


@bpy.app.handlers.persistent
def forget_all(*_event: Any) -> None:
    """Drops all sessions."""
    _sessions.clear()


@bpy.app.handlers.persistent
def doubt_faces(*_event: Any) -> None:
    """Has every session compare its faces before its next stroke."""
    for kept in _sessions.values():
        kept.faces_are_known = False


@bpy.app.handlers.persistent
def _doubt_edited(_scene: Any, depsgraph: Any) -> None:
    if any(isinstance(update.id, bpy.types.Object) and update.id.mode == "EDIT" for update in depsgraph.updates):
        doubt_faces()


_HANDLERS = {
    "load_pre": forget_all,
    "undo_post": doubt_faces,
    "redo_post": doubt_faces,
    "depsgraph_update_post": _doubt_edited,
}


def register() -> None:
    for name, handler in _HANDLERS.items():
        getattr(bpy.app.handlers, name).append(handler)


def unregister() -> None:
    for name, handler in _HANDLERS.items():
        getattr(bpy.app.handlers, name).remove(handler)
    forget_all()
