"""Meshes: read, refined and written."""

from __future__ import annotations

import ctypes
import os
import weakref
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _c
from ._arrays import MeshArrays
from ._memory import view
from .errors import InvalidArgument


@dataclass(frozen=True)
class Mesh:
    """A mesh of triangles. Arrays are views of the library's memory, read-only."""

    positions: NDArray[np.float32]
    """Shape (n, 3), object units, relative to `origin`."""
    triangles: NDArray[np.uint32]
    """Shape (m, 3), counter-clockwise seen from outside."""
    colours: NDArray[np.float32] | None
    """Shape (n, 4), linear red, green, blue and coverage, 0..1; None: nothing is painted."""
    masks: NDArray[np.float32] | None
    """Shape (n,), 0 = protected .. 1 = free; None: all are free."""
    origin: tuple[float, float, float]
    """Zero unless a file's positions are so far from its own origin that floats would round them."""
    uv: NDArray[np.float32] | None = None
    """Shape (m, 3, 2), texture coordinates of the corners of each triangle, from the lower left; None: there are none."""


class Triangles:
    """A burin_triangles, which lives as long as arrays over its memory."""

    def __init__(self, function: str, *args: Any) -> None:
        self.pointer = ctypes.c_void_p()
        _c.call(function, *args, self.pointer)
        self._finalizer = weakref.finalize(self, _c.lib.burin_triangles_destroy, self.pointer)

    def mesh(self) -> Mesh:
        mesh, values = _c.MeshArrays(), _c.MeshValues()
        _c.call("burin_triangles_get", self.pointer, mesh, values)
        count = mesh.vertex_count

        def floats(address: int | None, size: tuple[int, ...]) -> NDArray[np.float32] | None:
            return view(address, (count, *size), owner=self) if address else None

        return Mesh(
            view(mesh.positions, (count, 3), owner=self),
            view(mesh.corners, (mesh.face_count, 3), kind="<u4", owner=self),
            floats(values.colours, (4,)),
            floats(values.masks, ()),
            (values.origin[0], values.origin[1], values.origin[2]),
            view(values.uv, (mesh.face_count, 3, 2), owner=self) if values.uv else None,
        )


def _refinement(levels: int, target_triangles: int | None, weld: float | None) -> _c.Refinement:
    if not 0 <= levels <= 15:
        raise InvalidArgument(f"levels: must be 0 to 15, not {levels}")
    return _c.Refinement(levels, target_triangles or 0, weld or 0)


def read_mesh(
    path: str | os.PathLike[str],
    *,
    levels: int = 0,
    target_triangles: int | None = None,
    weld: float | None = None,
) -> Mesh:
    """Reads a mesh as `burin replay` does: OBJ, PLY, STL, OFF, glTF or GLB.

    levels: of refinement, 0 to 15, by Loop if all faces are triangles, else by Catmull and Clark; target_triangles: instead,
    refine to at least so many. weld: edges that lie on each other no farther apart are joined, object units; None: what
    rounding has separated. Refined meshes have neither colours nor masks. Raises Error, which names the file and the place
    in it.
    """
    options = _refinement(levels, target_triangles, weld)
    return Triangles("burin_triangles_read", os.fsencode(path), options).mesh()


def refine_mesh(
    positions: ArrayLike,
    faces: ArrayLike,
    face_sizes: ArrayLike | None = None,
    *,
    levels: int = 0,
    target_triangles: int | None = None,
) -> Mesh:
    """Refines a cage, arrays as those of Session, as read_mesh() does, without creases. Its faces must be a manifold of one
    orientation.

    >>> refine_mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2, 3]], levels=3).triangles.shape
    (128, 3)
    """
    arrays = MeshArrays(positions, faces, face_sizes, "caller")
    return Triangles("burin_triangles_refine", arrays.mesh, _refinement(levels, target_triangles, None)).mesh()


def write_mesh(
    path: str | os.PathLike[str],
    positions: ArrayLike,
    faces: ArrayLike,
    face_sizes: ArrayLike | None = None,
    *,
    colours: ArrayLike | None = None,
    masks: ArrayLike | None = None,
    origin: tuple[float, float, float] = (0, 0, 0),
    uv: ArrayLike | None = None,
) -> None:
    """Writes a mesh, wholly or not at all: .ply, .glb, .obj or .off. Arrays are those of Session, colours, masks and uv those
    of Mesh; larger faces are cut into triangles, and have no uv, nor have .off files. Raises Error, which names the file."""
    arrays = MeshArrays(positions, faces, face_sizes, "caller")
    values = _c.MeshValues(origin=origin)
    count = len(arrays.positions)
    kept = [
        _floats(colours, (count, 4), "colours"),
        _floats(masks, (count,), "masks"),
        _floats(uv, (arrays.mesh.face_count, 3, 2), "uv"),
    ]
    values.colours, values.masks, values.uv = (None if one is None else one.ctypes.data for one in kept)
    _c.call("burin_mesh_write", os.fsencode(path), arrays.mesh, values)


def _floats(given: ArrayLike | None, shape: tuple[int, ...], name: str) -> NDArray[Any] | None:
    if given is None:
        return None
    array = np.ascontiguousarray(given, np.float32)
    if array.shape != shape:
        raise InvalidArgument(f"{name}: the shape must be {shape}, not {array.shape}")
    return array
