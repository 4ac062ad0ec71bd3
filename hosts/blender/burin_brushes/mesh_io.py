"""Meshes of Blender as arrays, and back. Nothing here imports Blender: a mesh is what has vertices, loops and polygons with
foreach_get()."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float32]


@dataclass(frozen=True)
class Faces:
    """The faces of a mesh, hidden ones too."""

    corners: NDArray[np.uint32]
    """Vertices of the faces, one face after the other."""
    sizes: NDArray[np.uint32]
    """Corners of each face."""

    def same(self, other: Faces) -> bool:
        return np.array_equal(self.sizes, other.sizes) and np.array_equal(self.corners, other.corners)


def counts(mesh: Any) -> tuple[int, int, int]:
    """How many vertices, corners and faces a mesh has."""
    return len(mesh.vertices), len(mesh.loops), len(mesh.polygons)


def read_positions(mesh: Any) -> Floats:
    """Local positions, shape (n, 3)."""
    positions = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get("co", positions)
    return positions.reshape(-1, 3)


def write_positions(mesh: Any, positions: Floats) -> None:
    """Sets local positions, and tells Blender that they changed. Any other type than float32 would cost thirty times as
    much."""
    mesh.vertices.foreach_set("co", np.ascontiguousarray(positions, np.float32).ravel())
    mesh.update()


def fill(mesh: Any, made: Any) -> None:
    """Gives an empty mesh the smooth faces of one that the library has made."""
    mesh.from_pydata(made.positions.tolist(), [], made.triangles.tolist())
    mesh.polygons.foreach_set("use_smooth", np.ones(len(made.triangles), bool))
    mesh.update()


def changed_ranges(
    before: Floats, after: Floats, gap: int = 3000, within: tuple[int, int] | None = None
) -> list[tuple[int, int]]:
    """The vertices that differ, as ascending ranges [begin, end) that are farther apart than `gap`: a range for
    itself costs the library as much as three thousand vertices that have not changed. Looks at those of a range, or at
    all."""
    if within:
        begin, end = within
        return [(begin + b, begin + e) for b, e in changed_ranges(before[begin:end], after[begin:end], gap)]
    changed = np.flatnonzero(before.ravel() != after.ravel()) // (before.size // len(before))
    if not len(changed):
        return []
    last = np.append(np.flatnonzero(np.diff(changed) > gap), len(changed) - 1)
    begins = changed[np.append(0, last[:-1] + 1)]
    return list(zip(begins.tolist(), (changed[last] + 1).tolist()))


def read_faces(mesh: Any) -> Faces:
    corners = np.empty(len(mesh.loops), np.uint32)
    sizes = np.empty(len(mesh.polygons), np.uint32)
    mesh.loops.foreach_get("vertex_index", corners)  # faces follow each other without gaps
    mesh.polygons.foreach_get("loop_total", sizes)
    return Faces(corners, sizes)


def read_hidden(mesh: Any) -> NDArray[np.bool_]:
    """Whether each face is hidden."""
    hidden = np.zeros(len(mesh.polygons), bool)
    if ".hide_poly" in mesh.attributes:
        mesh.attributes[".hide_poly"].data.foreach_get("value", hidden)  # in half the time of polygons' own
    return hidden
