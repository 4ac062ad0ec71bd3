"""Meshes of Blender as arrays, and back.

Positions that a mesh has are local, those of strokes are in the world, so that brushes stay round whatever the object's
scale is. Nothing here imports Blender: a mesh is what has vertices, loops and polygons with foreach_get().
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float32]


@dataclass(frozen=True)
class Faces:
    """The faces of a mesh that are not hidden."""

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


def changed_range(before: Floats, after: Floats) -> tuple[int, int] | None:
    """The vertices begin .. end - 1 of which the first and the last differ; None: all are the same."""
    differ = before.ravel() != after.ravel()
    if not differ.any():
        return None
    return int(differ.argmax()) // 3, (len(differ) - int(differ[::-1].argmax()) + 2) // 3


def read_faces(mesh: Any) -> Faces:
    """The faces that are not hidden."""
    corners = np.empty(len(mesh.loops), np.uint32)
    sizes = np.empty(len(mesh.polygons), np.uint32)
    mesh.loops.foreach_get("vertex_index", corners)  # faces follow each other without gaps
    mesh.polygons.foreach_get("loop_total", sizes)
    if ".hide_poly" not in mesh.attributes:
        return Faces(corners, sizes)
    hidden = np.empty(len(sizes), bool)
    mesh.polygons.foreach_get("hide", hidden)
    return Faces(corners[~np.repeat(hidden, sizes)], sizes[~hidden])


class Placement:
    """Where an object is: its matrix from local to world positions, 4 x 4."""

    def __init__(self, matrix: Any) -> None:
        self.matrix = np.array(matrix, np.float64)
        self.keeps_bits = bool(np.array_equal(self.matrix, np.eye(4)))
        determinant = np.linalg.det(self.matrix[:3, :3])
        if determinant == 0 or not np.isfinite(self.matrix).all():
            raise ValueError("the object is scaled to nothing along an axis")
        self.mirrors = bool(determinant < 0)
        self._inverse = np.linalg.inv(self.matrix)

    def same(self, other: Placement) -> bool:
        return np.array_equal(self.matrix, other.matrix)

    def to_world(self, local: Floats) -> Floats:
        """Positions in the world. Without rotation, scale and translation they are the local ones: `keeps_bits`."""
        return self._apply(self.matrix, local)

    def to_local(self, world: Floats) -> Floats:
        """The inverse of to_world() but for rounding."""
        return self._apply(self._inverse, world)

    def outward(self, faces: Faces) -> Faces:
        """Faces as seen in the world: a mirroring matrix turns them inside out unless their corners are reversed."""
        return Faces(faces.corners[::-1], faces.sizes[::-1]) if self.mirrors else faces

    def _apply(self, matrix: NDArray[np.float64], positions: Floats) -> Floats:
        if self.keeps_bits:
            return positions
        # One axis after the other instead of a product of matrices, whose bits depend on the machine.
        columns = positions.astype(np.float64).T
        moved = np.empty(positions.shape, np.float32)
        for axis, (x, y, z, t) in enumerate(matrix[:3]):
            moved[:, axis] = x * columns[0] + y * columns[1] + z * columns[2] + t
        return moved
