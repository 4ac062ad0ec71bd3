"""Arrays of numpy as C reads them."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _c
from .errors import InvalidArgument

FLOATS = {"f4": _c.FLOAT32, "f8": _c.FLOAT64}
"""Types of positions and other values, by numpy's names, and their numbers in C."""

CORNERS = {"u4": _c.UINT32, "i4": _c.UINT32, "u8": _c.UINT64, "i8": _c.UINT64}
"""Types of the vertices of faces."""


def readable(given: ArrayLike, types: dict[str, int], other: Any) -> NDArray[Any]:
    """The array itself if C can read it: numbers of one of the types, those of a vertex or face without gaps."""
    array = np.asarray(given)
    if array.dtype.str[1:] not in types or not array.dtype.isnative:
        array = array.astype(other)
    in_order = array.ndim > 0 and array.strides[-1] == array.itemsize and min(array.strides) > 0
    return array if in_order else np.ascontiguousarray(array)


class MeshArrays:
    """burin_mesh over arrays of numpy, which belong to this object. They are copied only if their type or layout is none of
    C's."""

    def __init__(
        self,
        positions: ArrayLike,
        faces: ArrayLike,
        face_sizes: ArrayLike | None,
        order: str,
        transform: ArrayLike | None = None,
        hidden: ArrayLike | None = None,
        refines: bool = False,
    ) -> None:
        self.positions = readable(positions, FLOATS, np.float64)
        self.corners = readable(faces, CORNERS, np.int64)
        if self.positions.ndim != 2 or self.positions.shape[1] != 3:
            raise InvalidArgument(f"positions: the shape must be (n, 3), not {self.positions.shape}")
        self.mesh = _c.MeshArrays(
            FLOATS[self.positions.dtype.str[1:]],
            self.positions.ctypes.data,
            len(self.positions),
            self.positions.strides[0],
        )
        self.mesh.corners = self.corners.ctypes.data
        self.mesh.corner_type = CORNERS[self.corners.dtype.str[1:]]
        if order not in ("caller", "surface"):
            raise InvalidArgument(f"order: must be 'caller' or 'surface', not {order!r}")
        self.mesh.refines = refines
        self.mesh.order = 1 if order == "caller" else 2
        if face_sizes is None:
            self._set_faces_of_one_size()
        else:
            self._set_face_sizes(face_sizes)
        if transform is not None:
            self._set_transform(transform)
        if hidden is not None:
            self._set_hidden(hidden)

    def _set_transform(self, transform: ArrayLike) -> None:
        matrix = np.asarray(transform, np.float64)
        if matrix.shape != (4, 4):
            raise InvalidArgument(f"transform: the shape must be (4, 4), not {matrix.shape}")
        self.transform = np.ascontiguousarray(matrix.T)  # C has it by columns
        self.mesh.transform = self.transform.ctypes.data

    def _set_hidden(self, hidden: ArrayLike) -> None:
        self.hidden = np.ascontiguousarray(hidden, np.bool_)
        if self.hidden.shape != (self.mesh.face_count,):
            raise InvalidArgument(f"hidden: the shape must be ({self.mesh.face_count},), not {self.hidden.shape}")
        self.mesh.hidden = self.hidden.ctypes.data

    def _set_faces_of_one_size(self) -> None:
        if self.corners.ndim != 2:
            raise InvalidArgument(f"faces: the shape must be (m, corners of a face), not {self.corners.shape}")
        self.mesh.face_count, self.mesh.face_size = self.corners.shape
        self.mesh.face_stride = self.corners.strides[0]

    def _set_face_sizes(self, face_sizes: ArrayLike) -> None:
        if self.corners.ndim != 1:
            raise InvalidArgument(f"faces: with face_sizes the shape must be (corners of all faces,), not {self.corners.shape}")
        self.sizes = np.ascontiguousarray(face_sizes, self.corners.dtype)
        if self.sizes.sum() != len(self.corners):
            raise InvalidArgument(f"face_sizes: their sum is {self.sizes.sum()}, but there are {len(self.corners)} corners")
        self.mesh.face_count = len(self.sizes)
        self.mesh.face_sizes = self.sizes.ctypes.data
