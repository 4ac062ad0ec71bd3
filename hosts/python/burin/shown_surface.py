"""The surface of a session as it is shown: its values, what changed of them, and its numbers of vertices."""

from __future__ import annotations

import ctypes
import os
import weakref
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _c
from ._arrays import FLOATS, MeshArrays, readable
from ._memory import view as view_of
from .errors import InvalidArgument
from .library import Library
from .mesh import Mesh, Triangles, write_mesh

ATTRIBUTES = {"positions": (1, 3), "normals": (2, 3), "colours": (3, 4), "masks": (4, 1)}
"""Attributes of vertices: their numbers in C, and how many floats a vertex has."""


@dataclass(frozen=True)
class SessionInfo:
    """What a session holds."""

    stroke_open: bool
    vertex_count: int
    triangle_count: int
    undo_count: int
    redo_count: int
    undo_bytes: int
    undo_dropped: int
    """How many strokes can no longer be undone for limit_undo()."""
    generation: int
    """Another number whenever strokes changed triangles."""
    has_colours: bool
    """Whether vertices have colours: written, or painted by strokes that are not undone."""
    has_masks: bool
    solid_count: int
    """How many solids strokes made beside the surface."""
    bent_mesh_count: int


class Handle:
    """A burin_session, which lives as long as something refers to it: a session, or arrays over its memory."""

    def __init__(self, library: Library, arrays: MeshArrays) -> None:
        pointer = ctypes.c_void_p()
        _c.call("burin_session_create", library._handle, arrays.mesh, pointer, cause_of=library._take_fault)
        self.pointer = pointer
        self._finalizer = weakref.finalize(self, _destroy, pointer, library)


def _destroy(pointer: ctypes.c_void_p, _library: Library) -> None:
    _c.lib.burin_session_destroy(pointer)


def _attribute(name: str) -> tuple[int, int]:
    if name not in ATTRIBUTES:
        raise InvalidArgument(f"there is no attribute {name!r}, but {', '.join(ATTRIBUTES)}")
    return ATTRIBUTES[name]


def _shape(count: int, size: int) -> tuple[int, ...]:
    return (count,) if size == 1 else (count, size)


def _check_shape(array: NDArray[Any], shape: tuple[int, ...], name: str) -> None:
    if array.shape != shape:
        raise InvalidArgument(f"{name}: the shape must be {shape}, not {array.shape}")


def _array(array: NDArray[Any]) -> _c.Array:
    return _c.Array(FLOATS[array.dtype.str[1:]], array.ctypes.data, array.strides[0])


class ShownSurface:
    """What a session shows. Vertices have the numbers of the arrays that it was made of."""

    def __init__(self, library: Library, arrays: MeshArrays) -> None:
        self.library = library
        self._refines = bool(arrays.mesh.refines)
        self._handle: Handle | None = Handle(library, arrays)
        self._progress_fault: BaseException | None = None

    def close(self) -> None:
        """Lets go of the session. Its memory is freed once no array is a view of it."""
        self._handle = None

    @property
    def _pointer(self) -> ctypes.c_void_p:
        if self._handle is None:
            raise InvalidArgument("the session is closed")
        return self._handle.pointer

    def _call(self, name: str, *args: Any) -> None:
        """Calls a function of the session. An exception of Python that made it fail is the error's cause."""
        self._progress_fault = None
        _c.call(name, self._pointer, *args, cause_of=self._cause_of)

    def _cause_of(self, text: str) -> BaseException | None:
        return self._progress_fault or self.library._take_fault(text)

    @property
    def info(self) -> SessionInfo:
        """What the session holds."""
        info = _c.SessionInfo()
        self._call("burin_session_get_info", info)
        return SessionInfo(
            bool(info.stroke_open),
            info.vertex_count,
            info.triangle_count,
            info.undo_count,
            info.redo_count,
            info.undo_bytes,
            info.undo_dropped,
            info.generation,
            bool(info.has_colours),
            bool(info.has_masks),
            info.solid_count,
            info.bent_mesh_count,
        )

    def update(self, attribute: str = "positions", *, gap: int = 64, most: int = 32) -> NDArray[np.uint64]:
        """Brings values(attribute) up to date, and returns what changed since the update before: ranges [begin, end) of
        vertices, shape (k, 2), ascending. They are more than `gap` vertices apart and at most `most`. The first update is of
        all vertices. Attributes are "positions", "normals", "colours" and "masks". Costs what changed."""
        ranges = np.empty((most, 2), np.uint64)
        count = ctypes.c_uint64()
        self._call("burin_session_update", _attribute(attribute)[0], gap, ranges.ctypes.data, most, count)
        return ranges[: count.value]

    def values(self, attribute: str = "positions") -> NDArray[np.float32]:
        """The values of all vertices as of the last update: a view, not a copy, which is read-only and changes with every
        update. Shape (n, 3) for positions and unit normals; (n, 4) for colours, linear red, green, blue and coverage, 0..1;
        (n,) for masks, 0 = protected .. 1 = free. It keeps the session alive. Of a session that refines it is a copy, since
        strokes make more vertices; those are NaN until update()."""
        number, size = _attribute(attribute)
        if not _c.lib.burin_session_values(self._pointer, number):
            self.update(attribute)
        shape = _shape(self.info.vertex_count, size)
        values = view_of(_c.lib.burin_session_values(self._pointer, number), shape, owner=self._handle)
        return values.copy() if self._refines else values

    @property
    def triangles(self) -> NDArray[np.uint32]:
        """The triangles, shape (m, 3), in the order of the surface; of a session that refines as the next take_patch()
        will leave them."""
        triangles = np.empty((self.info.triangle_count, 3), np.uint32)
        self._call("burin_session_read_triangles", triangles.ctypes.data, len(triangles))
        return triangles

    def map_to_surface(self) -> NDArray[np.uint32]:
        """Element i is the number in Burin's order of vertex i of the arrays that the session was made of."""
        return self._map(1)

    def map_from_surface(self) -> NDArray[np.uint32]:
        """The inverse of map_to_surface()."""
        return self._map(2)

    def _map(self, kind: int) -> NDArray[np.uint32]:
        numbers = np.empty(self.info.vertex_count, np.uint32)
        self._call("burin_session_read_map", kind, numbers.ctypes.data, len(numbers))
        return numbers

    def read(
        self, attribute: str = "positions", begin: int = 0, end: int | None = None, out: NDArray[Any] | None = None
    ) -> NDArray[Any]:
        """The current values of the vertices [begin, end), whether or not there was an update: a new array of float32, or
        `out`, float32 or float64, whose first axis may have any stride."""
        number, size = _attribute(attribute)
        end = self.info.vertex_count if end is None else end
        shape = _shape(max(end - begin, 0), size)
        if out is None:
            out = np.empty(shape, np.float32)
        _check_shape(out, shape, "out")
        if readable(out, FLOATS, np.float64) is not out or not out.flags.writeable:
            raise InvalidArgument("out: must be float32 or float64, writable, forwards and without gaps within a vertex")
        self._call("burin_session_read", number, _c.Range(begin, end), _array(out))
        return out

    def write(self, attribute: str, values: ArrayLike, begin: int = 0) -> None:
        """Takes values of the vertices [begin, begin + n) that other tools changed: positions, or colours or masks, 0..1. It
        is no step of undo. float32 and float64 are read where they are."""
        number, size = _attribute(attribute)
        array = readable(np.atleast_1d(values), FLOATS, np.float64)
        _check_shape(array, _shape(len(array), size), "values")
        self._call("burin_session_write", number, _c.Range(begin, begin + len(array)), _array(array))

    def solids(self, begin: int = 0) -> list[Mesh]:
        """Meshes of the solids that strokes made beside the surface, in their order, from number `begin` on, where the object
        has them. Undo takes them back."""
        numbers = range(begin, self.info.solid_count)
        return [Triangles("burin_session_read_solid", self._pointer, number).mesh() for number in numbers]

    def bent_meshes(self) -> list[Mesh]:
        """The meshes that strokes with the setting along_mesh laid beside the surface, likewise."""
        return [Triangles("burin_session_read_bent_mesh", self._pointer, i).mesh() for i in range(self.info.bent_mesh_count)]

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the surface, with colours and masks if it has any: .ply, .glb, .obj or .off."""
        info = self.info
        write_mesh(
            path,
            self.read(),
            self.triangles,
            colours=self.read("colours") if info.has_colours else None,
            masks=self.read("masks") if info.has_masks else None,
        )
