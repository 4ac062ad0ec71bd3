"""Sessions of objects: made when the first stroke is drawn, kept, and brought up to date with what other tools did.

Strokes are in the world, positions the object's own. Between strokes the session of an object has those of the mesh, to the
bit, so that a stroke that is undone and drawn again makes the same. Blender's undo is the only one: a session sees afterwards
that positions differ.
"""

from __future__ import annotations

from typing import Any

import burin
import bpy
import numpy as np

from . import mesh_io, preview, vertex_values

Shown = dict[str, mesh_io.Floats]
"""Positions, and colours and masks where they are painted, that an object shows while a stroke is open."""


class Refused(Exception):
    """A line that tells the user why an object cannot be drawn on."""


class ObjectSession:
    """A session on the mesh of an object."""

    def __init__(self, library: burin.Library, object: Any) -> None:
        mesh = object.data
        self.counts = mesh_io.counts(mesh)
        self.matrix = np.array(object.matrix_world, np.float64)
        self._faces = mesh_io.read_faces(mesh)
        self._hidden = mesh_io.read_hidden(mesh)
        self._known: Shown = {"positions": mesh_io.read_positions(mesh)}
        """What the mesh has, of which the session knows."""
        self._before: dict[str, vertex_values.Values] = {}
        """What the mesh had when the open stroke began."""
        self.faces_are_known = True
        """False after what may have changed or hidden faces and left their number as it was."""
        self._drawn: dict[str, tuple[int, int]] = {}
        """What the open stroke changed, with a range that has all of its vertices."""
        self._solid_count = 0
        self._parts: preview.ShownParts | None = None
        self._is_world = np.array_equal(self.matrix, np.eye(4))
        if not len(self._faces.sizes):
            raise Refused(f"{object.name}: there is no face to draw on")
        self.session = burin.Session(
            library,
            self._known["positions"],
            self._faces.corners,
            self._faces.sizes,
            transform=None if self._is_world else self.matrix,
            hidden=self._hidden,
        )
        self.session.limit_undo(0)
        self.session.update("positions")

    def fits(self, object: Any) -> bool:
        """Whether the faces and the place of the object are those of the session."""
        mesh = object.data
        if self.counts != mesh_io.counts(mesh) or not np.array_equal(self.matrix, object.matrix_world):
            return False
        return self.faces_are_known or self._faces.same(mesh_io.read_faces(mesh))

    def take_hidden(self, object: Any) -> None:
        """Hides the faces that are hidden, at the cost of a new session where that changed."""
        if self.faces_are_known:
            return
        hidden = mesh_io.read_hidden(object.data)
        if not np.array_equal(self._hidden, hidden):
            self.session.hide(hidden)
            self._parts = None
        self._hidden, self.faces_are_known = hidden, True

    def take_changed(self, object: Any, names: list[str]) -> None:
        """Takes what others changed, at a cost in proportion to that: positions and masks, and what is painted. Raises
        vertex_values.Unfit."""
        for name in vertex_values.NAMES:
            if name == "colours" and name not in names:
                continue  # no stroke feels them
            values = vertex_values.read(name, object.data, blank=name in names or name in self._known)
            if values:
                self._before[name] = values
                self._take(name, values.known)

    def _take(self, name: str, values: mesh_io.Floats, within: tuple[int, int] | None = None) -> None:
        known = self._known.get(name)
        ranges = [(0, len(values))] if known is None else mesh_io.changed_ranges(known, values, within=within)
        for begin, end in ranges:
            self.session.write(name, values[begin:end], begin)
        self.session.update(name)
        self._known[name] = values
        if name == "positions":
            self._send(values, ranges)

    def shown(self, names: list[str]) -> Shown:
        """What the object shows when a stroke begins that changes this: copies."""
        return {name: self._known[name].copy() for name in names}

    @property
    def hides_faces(self) -> bool:
        """Whether faces are hidden, which Blender shows in object mode but the session has not."""
        return bool(self._hidden.any())

    @property
    def parts(self) -> preview.ShownParts:
        """The triangles on the graphics card, which from now on is sent what changes."""
        if self._parts is None:
            self._parts = preview.ShownParts(self.session)
            self._send(self._known["positions"], [(0, self.counts[0])])
        return self._parts

    def _send(self, positions: mesh_io.Floats, ranges: Any) -> None:
        if not self._parts:
            return
        try:
            self._parts.send(positions, ranges)
        except BaseException:
            self._parts = None  # it is made anew for the next stroke
            raise

    def drawn(self, shown: Shown) -> list[str]:
        """Writes what changed since the last call to `shown`, and tells what of it did."""
        return [name for name, values in shown.items() if self._draw(name, values)]

    def _draw(self, name: str, shown: mesh_io.Floats) -> bool:
        ranges = self.session.update(name, most=1024)
        values = self.session.values(name)
        for begin, end in ranges:
            shown[begin:end] = values[begin:end]
        if name == "positions":
            self._send(shown, ranges)
        if not len(ranges):
            return False
        begin, end = self._drawn.get(name, (len(shown), 0))
        self._drawn[name] = min(begin, int(ranges[0, 0])), max(end, int(ranges[-1, 1]))
        return True

    def write(self, object: Any, names: list[str], shown: Shown) -> None:
        """Gives the mesh these of what is shown."""
        for name in names:
            vertex_values.write(name, object.data, shown[name], self._before[name])

    def keep(self, object: Any, shown: Shown) -> None:
        """Ends a stroke: the mesh and the session get what is shown."""
        names = [name for name in vertex_values.NAMES if name in self._drawn]
        self.write(object, names, shown)
        for name in names:
            if name == "positions" and not self._is_world:
                # Floats of the world may have no equal in the object.
                self._take(name, shown[name], within=self._drawn[name])
            self._known[name] = shown[name]
        self._end()

    def _end(self) -> None:
        self._drawn.clear()
        self._before.clear()

    def take_solids(self) -> list[burin.Mesh]:
        """The solids that strokes made beside the mesh since the call before."""
        solids = self.session.solids(self._solid_count)
        self._solid_count += len(solids)
        return solids

    def drop(self, object: Any) -> None:
        """Shows the mesh as it was before the stroke that was cancelled or has failed."""
        for name in self._drawn:
            vertex_values.restore(name, object.data, self._before[name])
        self._end()
        self._send(self._known["positions"], self.session.update("positions"))


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


def session_of(library: burin.Library, object: Any, names: list[str]) -> ObjectSession:
    """The session of an object, as the object is now, for a stroke that changes this. Raises Refused or burin.Error."""
    _check(object)
    kept = _sessions.pop(object.name_full, None)
    try:
        if kept is None or not kept.fits(object):
            kept = None  # its memory is free before there is another
            kept = ObjectSession(library, object)
        kept.take_changed(object, names)
        kept.take_hidden(object)
    except (burin.Error, vertex_values.Unfit) as fault:
        raise Refused(f"{object.name}: {fault}") from fault
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
    if any(isinstance(update.id, bpy.types.Object) and update.id.mode != "OBJECT" for update in depsgraph.updates):
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
