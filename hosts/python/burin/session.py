"""Sessions: a surface that is sculpted by strokes."""

from __future__ import annotations

import ctypes
import os
import weakref
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _c
from ._arrays import FLOATS, MeshArrays, readable
from ._memory import view as view_of
from ._settings import Setting, fields_of, setting_texts
from .errors import InvalidArgument, raise_status
from .library import Library
from .mesh import Mesh, write_mesh
from .recording import RecordedStroke
from .samples import SAMPLE, samples

ATTRIBUTES = {"positions": (1, 3), "normals": (2, 3), "colours": (3, 4), "masks": (4, 1)}
"""Attributes of vertices: their numbers in C, and how many floats a vertex has."""

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
class SessionInfo:
    """What a session holds."""

    stroke_open: bool
    vertex_count: int
    triangle_count: int
    undo_count: int
    redo_count: int
    undo_bytes: int


@dataclass(frozen=True)
class Chart:
    """The coordinates (t, d) of the vertices around a piece of a stroke."""

    nodes: NDArray[np.void]
    """Shape (n,), type CHART_NODE, in Burin's own order. A vertex that the stroke visits several times is there as often."""
    length: float
    """Of the stroke, object units."""
    closed: bool
    """Whether t is periodic with `length`."""


LINES = ("ridge", "valley", "silhouette", "border", "high", "low")
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


class _Handle:
    """A burin_session, which lives as long as something refers to it: a session, or arrays over its memory."""

    def __init__(self, library: Library, mesh: _c.MeshArrays) -> None:
        pointer = ctypes.c_void_p()
        _c.call("burin_session_create", library._handle, mesh, pointer)
        self.pointer = pointer
        self._finalizer = weakref.finalize(self, _destroy, pointer, library)


def _destroy(pointer: ctypes.c_void_p, _library: Library) -> None:
    _c.lib.burin_session_destroy(pointer)


def _as_samples(position: Any, pen: dict[str, ArrayLike]) -> NDArray[np.void]:
    """Samples one after the other: the array itself if it is of type SAMPLE and has no gaps."""
    given: NDArray[np.void] = position if getattr(position, "dtype", None) == SAMPLE else samples(position, **pen)
    return np.atleast_1d(np.ascontiguousarray(given))


def _attribute(name: str) -> tuple[int, int]:
    if name not in ATTRIBUTES:
        raise InvalidArgument(f"there is no attribute {name!r}, but {', '.join(ATTRIBUTES)}")
    return ATTRIBUTES[name]


class Session:
    """A surface that is sculpted by strokes. A session belongs to one thread at a time; inside it uses all of the machine's,
    without the interpreter's lock. Vertices have the numbers of the arrays that it was made of."""

    def __init__(
        self,
        library: Library,
        positions: ArrayLike,
        faces: ArrayLike,
        face_sizes: ArrayLike | None = None,
        *,
        order: str = "caller",
    ) -> None:
        """Makes a session of arrays, which are read once.

        positions: shape (n, 3), float32 or float64, object units, of any stride. faces: shape (m, corners), 32 or 64 bits,
        counter-clockwise seen from outside; or with `face_sizes`, shape (m,), the corners of all faces one after the other.
        Arrays of these types are read where they are, others are copied first. order "surface": vertices have Burin's own
        numbers, so that a stroke changes few ranges; see map_to_surface().

        >>> plane = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], np.float32)
        >>> Session(Library(stock=False), plane, [[0, 1, 2, 3]]).info.triangle_count
        2
        """
        arrays = MeshArrays(positions, faces, face_sizes, order)
        self.library = library
        self._handle: _Handle | None = _Handle(library, arrays.mesh)
        self._progress: Any = None
        self._progress_fault: BaseException | None = None

    @classmethod
    def of_mesh(cls, library: Library, mesh: Mesh, *, order: str = "caller") -> Session:
        """Makes a session of a mesh that read_mesh() has read, with its colours and masks."""
        session = cls(library, mesh.positions, mesh.triangles, order=order)
        for attribute, values in (("colours", mesh.colours), ("masks", mesh.masks)):
            if values is not None:
                session.write(attribute, values if order == "caller" else values[session.map_from_surface()])
        return session

    def close(self) -> None:
        """Lets go of the session. Its memory is freed once no array is a view of it."""
        self._handle = None

    def __enter__(self) -> Session:
        return self

    def __exit__(self, *_exception: object) -> None:
        self.close()

    @property
    def _pointer(self) -> ctypes.c_void_p:
        if self._handle is None:
            raise InvalidArgument("the session is closed")
        return self._handle.pointer

    def _call(self, name: str, *args: Any) -> None:
        """Calls a function of the session. An exception of Python that made it fail is the error's cause."""
        self._progress_fault = None
        error = _c.ErrorText()
        status = getattr(_c.lib, name)(self._pointer, *args, error.text)
        if status != _c.OK:
            text = str(error)
            raise_status(status, text, self._progress_fault or self.library._take_fault(text))

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
        )

    # Strokes.

    def begin(
        self,
        brush: str | None = None,
        *,
        radius: float | None = None,
        fields: str | Iterable[str] = (),
        seed: int = 0,
        **settings: Setting,
    ) -> None:
        """Opens a stroke.

        brush: its id. radius: half the width, object units. fields: what the pen reports of "time pressure tilt twist"; the
        rest of samples is not read. seed: of random numbers. settings: those of docs/stroke_format.md and docs/bench.md,
        such as strength, follow, closed, cap, join, overlap, dabs, mirror, radial and stabilise; None: not given. params and
        dynamics are mappings: params={"depth": 0.2}, dynamics={"strength": ("pressure", [0, 0, 1, 1])}. Raises
        InvalidArgument with the name of a setting that does not exist or has a wrong value, NotFound for the brush.
        """
        lines = setting_texts({"brush": brush, "radius": radius, **settings})
        self._call("burin_session_begin", _c.Stroke(fields_of(fields), _c.texts(lines), seed))

    def add(self, position: Any, **pen: ArrayLike) -> Event:
        """Adds samples to the open stroke: an array of type SAMPLE, which is read where it is, or what samples() takes. All
        samples of a call bring the surface up to date once, so those of a frame belong in one."""
        given = _as_samples(position, pen)
        event = _c.Event()
        self._call("burin_session_add", given.ctypes.data, len(given), event)
        return Event(event.drawn, event.outcome == 1)

    def end(self) -> None:
        """Ends the open stroke, which then can be undone."""
        self._call("burin_session_end")

    def cancel(self) -> None:
        """Drops the open stroke, if there is one: the surface is as before it."""
        self._call("burin_session_cancel")

    @contextmanager
    def stroke(self, brush: str | None = None, **settings: Any) -> Iterator[Session]:
        """Opens a stroke as begin() does, and ends it; an exception cancels it.

            with session.stroke("org.burin.groove", radius=0.1):
                session.add(positions)
        """
        self.begin(brush, **settings)
        try:
            yield self
        except BaseException:
            self.cancel()
            raise
        self.end()

    def draw(self, stroke: RecordedStroke, **settings: Setting) -> Event:
        """Draws a recorded stroke at once. Settings hold before the recorded ones, as RecordedStroke.settings_with() has it."""
        self.begin(fields=stroke.fields, seed=stroke.seed, **stroke.settings_with(settings))
        event = self.add(stroke.samples)
        self.end()
        return event

    def replay(self, path: str | os.PathLike[str], **settings: Setting) -> None:
        """Draws all strokes of a recording as `burin replay` does. Settings hold before the recording's own."""
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
        fields: str | Iterable[str] = (),
        **pen: ArrayLike,
    ) -> Snapped:
        """Moves a stroke, samples as add() takes them, to a line of the surface within `radius`, object units, without drawing
        it: "ridge", "valley", "silhouette", seen in the direction `view` or from the eye there, "border", or "high" and
        "low", crests of `values` of the vertices. scale: half the line's width is best, object units; 0: chosen. See
        docs/snapping.md. Costs time in proportion to the surface."""
        if line not in LINES:
            raise InvalidArgument(f"there is no line {line!r}, but {', '.join(LINES)}")
        given = _as_samples(position, pen)
        kept = None if values is None else np.ascontiguousarray(values, np.float32)
        if kept is not None and kept.shape != (self.info.vertex_count,):
            raise InvalidArgument(f"values: the shape must be ({self.info.vertex_count},), not {kept.shape}")
        how = _c.Snap(LINES.index(line) + 1, radius, scale, significance, view, view_is_eye, fixed_ends)
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

    # What to show.

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
        (n,) for masks, 0 = protected .. 1 = free. It keeps the session alive."""
        number, size = _attribute(attribute)
        if not _c.lib.burin_session_values(self._pointer, number):
            self.update(attribute)
        count = self.info.vertex_count
        shape = (count,) if size == 1 else (count, size)
        return view_of(_c.lib.burin_session_values(self._pointer, number), shape, owner=self._handle)

    @property
    def triangles(self) -> NDArray[np.uint32]:
        """The triangles, shape (m, 3), in the order of the surface."""
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
        if out is None:
            count = max(end - begin, 0)
            out = np.empty((count,) if size == 1 else (count, size), np.float32)
        self._check(out, size, end - begin, "out")
        self._call("burin_session_read", number, _c.Range(begin, end), self._array(out))
        return out

    def write(self, attribute: str, values: ArrayLike, begin: int = 0) -> None:
        """Takes values of the vertices [begin, begin + n) that other tools changed: positions, or colours or masks, 0..1. It
        is no step of undo. float32 and float64 are read where they are."""
        number, size = _attribute(attribute)
        array = readable(values, FLOATS, np.float64)
        self._check(array, size, len(array), "values")
        self._call("burin_session_write", number, _c.Range(begin, begin + len(array)), self._array(array))

    @staticmethod
    def _check(array: NDArray[Any], size: int, count: int, name: str) -> None:
        shape = (count,) if size == 1 else (count, size)
        if array.shape != shape:
            raise InvalidArgument(f"{name}: the shape must be {shape}, not {array.shape}")
        if array.dtype.str[1:] not in FLOATS or (size > 1 and array.strides[1] != array.itemsize):
            raise InvalidArgument(f"{name}: must be float32 or float64, without gaps between the values of a vertex")

    @staticmethod
    def _array(array: NDArray[Any]) -> _c.Array:
        return _c.Array(FLOATS[array.dtype.str[1:]], array.ctypes.data, array.strides[0])

    def chart(self) -> Chart:
        """The chart of the last piece of the open stroke, or of the last stroke; a copy."""
        chart = _c.Chart()
        self._call("burin_session_chart", chart)
        nodes = np.empty(chart.count, CHART_NODE)
        for name in ("vertex", "sheet", "t", "d"):
            kind = CHART_NODE[name].str
            nodes[name] = view_of(getattr(chart, name), (chart.count,), kind=kind)
        return Chart(nodes, chart.length, bool(chart.closed))

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the surface, with colours and masks where anything is painted: .ply, .glb, .obj or .off."""
        colours, masks = self.read("colours"), self.read("masks")
        write_mesh(
            path,
            self.read(),
            self.triangles,
            colours=colours if colours[:, 3].any() else None,
            masks=masks if (masks != 1).any() else None,
        )
