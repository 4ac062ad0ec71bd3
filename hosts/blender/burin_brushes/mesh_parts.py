"""Triangles in parts that a graphics card gets one by one, so that it is sent no more than what changed. Nothing here imports
Blender."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

Numbers = NDArray[np.uint32]


@dataclass(frozen=True)
class Part:
    """Some triangles of a mesh."""

    vertices: Numbers
    """Their vertices, ascending numbers of the mesh."""
    triangles: Numbers
    """Their corners, indices of `vertices`, shape (m, 3)."""


class MeshParts:
    """The triangles of a mesh in parts. Triangles that follow each other should lie near each other."""

    def __init__(self, triangles: Numbers, vertex_count: int, most: int = 1 << 14) -> None:
        """`triangles`: vertices, shape (m, 3); `most`: triangles of a part."""
        index = np.empty(vertex_count, np.uint32)  # of a vertex in its part, written anew for each part
        here = np.zeros(vertex_count, bool)
        self.parts = [_part(triangles[begin : begin + most], index, here) for begin in range(0, len(triangles), most)]
        vertices = np.concatenate([part.vertices for part in self.parts])
        parts = np.repeat(np.arange(len(self.parts)), [len(part.vertices) for part in self.parts])
        order = np.argsort(vertices, kind="stable")
        self._vertices, self._parts = vertices[order], parts[order]

    def touched(self, ranges: ArrayLike) -> NDArray[np.intp]:
        """The parts that have vertices in ranges [begin, end), shape (k, 2); ascending. Costs what is in the ranges."""
        bounds = np.searchsorted(self._vertices, np.asarray(ranges, np.uint32).reshape(-1, 2))
        found = np.zeros(len(self.parts), bool)
        for begin, end in bounds:
            found[self._parts[begin:end]] = True
        return np.flatnonzero(found)


def _part(triangles: Numbers, index: Numbers, here: NDArray[np.bool_]) -> Part:
    """`here` is false everywhere, before and after."""
    first, last = triangles.min(), triangles.max()
    here[triangles] = True
    vertices = (first + np.flatnonzero(here[first : last + 1])).astype(np.uint32)
    here[vertices] = False
    index[vertices] = np.arange(len(vertices), dtype=np.uint32)
    return Part(vertices, index[triangles])
