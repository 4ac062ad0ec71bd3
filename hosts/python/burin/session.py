"""Sessions: a surface that is sculpted by strokes."""

from __future__ import annotations

import ctypes
import os
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _c
from ._arrays import MeshArrays
from ._drawing import Drawing
from ._memory import view as view_of
from ._settings import Setting, fields_of, setting_texts
from .errors import InvalidArgument
from .library import Library
from .mesh import Mesh
from .samples import SAMPLE, as_samples
from .shown_surface import ShownSurface
from .step import Step

CHART_NODE = np.dtype([("vertex", "<u4"), ("sheet", "<u4"), ("t", "<f8"), ("d", "<f4")])
"""A node of a chart: the vertex, the number of the visit to it, arc length along the stroke and signed distance to it,
object units; d is positive on the left."""

Progress = Callable[[str, float], None]


@dataclass(frozen=True)
class Event:
    """What became of the samples of a call."""

    drawn: int
    """How many were drawn."""
    on_surface: bool
    """Whether the last was: else its ray misses, or no surface is near, and the next one begins another piece."""


@dataclass(frozen=True)
class Chart:
    """The coordinates (t, d) of the vertices around a piece of a stroke."""

    nodes: NDArray[np.void]
    """Shape (n,), type CHART_NODE, in Burin's own order. A vertex that the stroke visits several times is there as often."""
    length: float
    """Of the stroke, object units."""
    closed: bool
    """Whether t is periodic with `length`."""


@dataclass(frozen=True)
class Patch:
    """How triangles and vertices changed."""

    kept_vertices: int
    """The vertices below are those that they were."""
    vertex_count: int
    """Now: those kept, then new ones."""
    removed: NDArray[np.uint32]
    """Places in the caller's array of triangles, ascending."""
    added: NDArray[np.uint32]
    """Triangles, shape (k, 3)."""

    def triangles(self, before: NDArray[np.uint32]) -> NDArray[np.uint32]:
        """The triangles after the patch of those before it, at first Session.triangles: new ones come last."""
        return np.concatenate([np.delete(before, self.removed, axis=0), self.added])


LINES = ("ridge", "valley", "silhouette", "border", "high", "low", "crease", "suggestive")
"""What strokes are snapped to."""


@dataclass(frozen=True)
class Snapped:
    """A stroke that was moved to a line of the surface."""

    samples: NDArray[np.void]
    """Of type SAMPLE, on the surface, half an edge apart."""
    share: float
    """Of the stroke's length that was snapped; 0: nothing stands out, the stroke stays as it was."""
    significance: float
    """Contrast of the line in units of the noise, mean; if nothing was snapped the greatest anywhere."""
    mean_move: float
    """Of what was snapped, object units."""


class Session(ShownSurface, Drawing[Event]):
    """A surface that is sculpted by strokes. A session belongs to one thread at a time; inside it uses all of the machine's,
    without the interpreter's lock. Vertices have the numbers of the arrays that it was made of."""

    _functions = "burin_session"

    def __init__(
        self,
        library: Library,
        positions: ArrayLike,
        faces: ArrayLike,
        face_sizes: ArrayLike | None = None,
        *,
        order: str = "caller",
        transform: ArrayLike | None = None,
        hidden: ArrayLike | None = None,
        refines: bool = False,
    ) -> None:
        """Makes a session of arrays, which are read once.

        positions: shape (n, 3), float32 or float64, object units, of any stride. faces: shape (m, corners), 32 or 64 bits,
        counter-clockwise seen from outside; or with `face_sizes`, shape (m,), the corners of all faces one after the other.
        Arrays of these types are read where they are, others are copied first. order "surface": vertices have Burin's own
        numbers, so that a stroke changes few ranges; see map_to_surface(). transform: shape (4, 4), takes positions of the
        object to the world, in which samples, radii, charts and the hash are, so that brushes are round there whatever the
        scale; positions and normals stay the object's. hidden: shape (m,), whether each face is hidden, see hide(); None:
        faces are never hidden. refines: strokes with the setting refine="auto" may split triangles, and those with
        solid="union" and the like merge solids with the surface, see take_patch().

        >>> plane = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], np.float32)
        >>> Session(Library(stock=False), plane, [[0, 1, 2, 3]]).info.triangle_count
        2
        """
        super().__init__(library, MeshArrays(positions, faces, face_sizes, order, transform, hidden, refines))
        self._progress: Any = None

    def __enter__(self) -> Session:
        return self

    def __exit__(self, *_exception: object) -> None:
        self.close()

    @classmethod
    def of_mesh(cls, library: Library, mesh: Mesh, *, order: str = "caller", refines: bool = False) -> Session:
        """Makes a session of a mesh that read_mesh() has read, with its colours and masks."""
        session = cls(library, mesh.positions, mesh.triangles, order=order, refines=refines)
        for attribute, values in (("colours", mesh.colours), ("masks", mesh.masks)):
            if values is not None:
                session.write(attribute, values if order == "caller" else values[session.map_from_surface()])
        return session

    def add(self, position: Any, **pen: ArrayLike) -> Event:
        """Adds samples to the open stroke: an array of type SAMPLE, which is read where it is, or what samples() takes. All
        samples of a call bring the surface up to date once, so those of a frame belong in one."""
        given = as_samples(position, pen)
        event = _c.Event()
        self._call("burin_session_add", given.ctypes.data, len(given), event)
        return Event(event.drawn, event.outcome == 1)

    def replay(self, path: str | os.PathLike[str], **settings: Setting) -> None:
        """Draws all strokes of a recording as `burin replay --refine off` does, or with refine="auto" as `burin replay`. Settings hold before the recording's own."""
        self._call("burin_session_replay", os.fsencode(path), _c.texts(setting_texts(settings)))

    def undo(self) -> None:
        """Undoes the last stroke to the bit. Raises NotFound if there is none."""
        self._call("burin_session_undo")

    def redo(self) -> None:
        """Makes the stroke that was undone last again. Raises NotFound if there is none."""
        self._call("burin_session_redo")

    def limit_undo(self, bytes: int) -> None:
        """Bounds what undo and redo may hold."""
        self._call("burin_session_limit_undo", bytes)

    def take_step(self) -> Step:
        """Takes the step of the last stroke for an undo stack of the application's own; undo() knows of the stroke no more.
        Raises NotFound if there is none."""
        pointer = ctypes.c_void_p()
        self._call("burin_session_take_step", pointer)
        return Step(pointer)

    def apply(self, step: Step) -> None:
        """Undoes the stroke of a step to the bit, or makes it again if that was done last. Raises InvalidArgument, and changes
        nothing, unless the surface is in the state that it was left in by the stroke or the step."""
        self._call("burin_session_apply_step", step._pointer)

    def hide(self, hidden: ArrayLike | None) -> None:
        """Hides faces, shape (m,), or shows them again; None: shows all. Pens do not meet hidden faces, strokes end at them,
        and vertices without any other face keep their bits. The session must have been made with such an array."""
        flags = None if hidden is None else np.ascontiguousarray(hidden, np.bool_)
        address, count = (None, 0) if flags is None else (flags.ctypes.data, flags.size)
        self._call("burin_session_hide", address, count)

    def take_patch(self) -> Patch:
        """How triangles and vertices changed since the call before, or since the session was made, by strokes, undo, redo and
        hide(). Raises InvalidArgument unless the session refines. To be called when info.generation is another one, before
        update(), which tells the values of new vertices."""
        patch = _c.Patch()
        self._call("burin_session_take_patch", patch)
        return Patch(
            patch.kept_vertices,
            patch.vertex_count,
            view_of(patch.removed, (patch.removed_count,), kind="<u4").copy(),
            view_of(patch.added, (patch.added_count, 3), kind="<u4").copy(),
        )

    def set_progress(self, progress: Progress | None) -> None:
        """Sets what is told what replay(), and end() where it makes solids, are at: the name of the step, and the share of
        it that is done, 0..1. An exception that it raises ends the call with Error, whose cause it is."""

        def tell(_user: int | None, stage: bytes, done: float) -> int:
            try:
                assert progress is not None
                progress(stage.decode(), done)
                return 0
            except BaseException as fault:
                self._progress_fault = fault
                return 1

        function = _c.ProgressFunction(tell) if progress else None
        self._call("burin_session_set_progress", function, None)
        self._progress = function

    def snap(
        self,
        line: str,
        position: Any,
        *,
        radius: float,
        scale: float = 0,
        significance: float = 4,
        view: tuple[float, float, float] = (0, 0, 0),
        view_is_eye: bool = False,
        fixed_ends: bool = False,
        values: ArrayLike | None = None,
        least_angle: float = 30,
        fields: str | Iterable[str] = (),
        **pen: ArrayLike,
    ) -> Snapped:
        """Moves a stroke, samples as add() takes them, to a line of the surface within `radius`, object units, without drawing
        it: "ridge", "valley", "silhouette" and "suggestive", seen in the direction `view` or from the eye there, "border",
        "crease", edges of at least `least_angle` degrees, or "high" and "low", crests of `values` of the vertices. scale: half the line's width is best, object units; 0: chosen. See
        docs/snapping.md. Costs time in proportion to the surface."""
        if line not in LINES:
            raise InvalidArgument(f"there is no line {line!r}, but {', '.join(LINES)}")
        given = as_samples(position, pen)
        kept = None if values is None else np.ascontiguousarray(values, np.float32)
        if kept is not None and kept.shape != (self.info.vertex_count,):
            raise InvalidArgument(f"values: the shape must be ({self.info.vertex_count},), not {kept.shape}")
        how = _c.Snap(LINES.index(line) + 1, radius, scale, significance, view, view_is_eye, fixed_ends)
        how.least_angle = least_angle
        how.values = None if kept is None else kept.ctypes.data
        found = _c.Snapped()
        self._call("burin_session_snap", how, given.ctypes.data, len(given), fields_of(fields), found)
        moved = view_of(found.samples, (found.sample_count,), kind=SAMPLE).copy()
        return Snapped(moved, found.share, found.significance, found.mean_move)

    def hash(self) -> int:
        """The number that `burin replay` prints, there with 16 hexadecimal digits: f"{session.hash():016x}"."""
        hash = ctypes.c_uint64()
        self._call("burin_session_hash", hash)
        return hash.value

    def chart(self) -> Chart:
        """The chart of the last piece of the open stroke, or of the last stroke; a copy."""
        chart = _c.Chart()
        self._call("burin_session_chart", chart)
        nodes = np.empty(chart.count, CHART_NODE)
        for name in ("vertex", "sheet", "t", "d"):
            kind = CHART_NODE[name].str
            nodes[name] = view_of(getattr(chart, name), (chart.count,), kind=kind)
        return Chart(nodes, chart.length, bool(chart.closed))
