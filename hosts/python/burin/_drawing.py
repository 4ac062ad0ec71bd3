"""Drawing with a pen, on one session or on several."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from typing import Any, ClassVar, Generic, TypeVar

from numpy.typing import ArrayLike

from . import _c
from ._settings import Setting, fields_of, setting_texts
from .recording import RecordedStroke
from .samples import as_samples

_Drawing = TypeVar("_Drawing", bound="Drawing[Any]")
_Event = TypeVar("_Event")


class Drawing(ABC, Generic[_Event]):
    """What strokes are drawn on."""

    _functions: ClassVar[str]
    """How the names of the library's functions for it begin."""

    @abstractmethod
    def _call(self, name: str, *args: Any) -> None:
        """Calls a function of the library for this."""

    def begin(
        self,
        brush: str | None = None,
        *,
        radius: float | None = None,
        fields: str | Iterable[str] = (),
        seed: int = 0,
        path: Any = None,
        **settings: Setting,
    ) -> None:
        """Opens a stroke.

        brush: its id. radius: half the width, object units. fields: what the pen reports of "time pressure tilt twist"; the
        rest of samples is not read. seed: of random numbers. settings: those of docs/stroke_format.md and docs/bench.md,
        such as strength, follow, closed, cap, join, overlap, dabs, mirror, radial and stabilise; None: not given. params and
        dynamics are mappings: params={"depth": 0.2}, dynamics={"strength": ("pressure", [0, 0, 1, 1])}.
        path: positions or samples() that the stroke will have, as far as they are known: where it refines the surface that
        is done once, not again and again as the pen comes. Raises InvalidArgument with the name of a setting that does not
        exist or has a wrong value, NotFound for the brush.
        """
        lines = setting_texts({"brush": brush, "radius": radius, **settings})
        stroke = _c.Stroke(fields_of(fields), _c.texts(lines), seed)
        ahead = None if path is None else as_samples(path, {})
        if ahead is not None:
            stroke.path, stroke.path_count = ahead.ctypes.data, len(ahead)
        self._call(f"{self._functions}_begin", stroke)

    def end(self) -> None:
        """Ends the open stroke, which then can be undone."""
        self._call(f"{self._functions}_end")

    def cancel(self) -> None:
        """Drops the open stroke, if there is one: what it is drawn on is as before it."""
        self._call(f"{self._functions}_cancel")

    @abstractmethod
    def add(self, position: Any, **pen: ArrayLike) -> _Event:
        """Adds samples to the open stroke."""

    def draw(self, stroke: RecordedStroke, **settings: Setting) -> _Event:
        """Draws a recorded stroke at once. Settings hold before the recorded ones, as RecordedStroke.settings_with() has it."""
        self.begin(fields=stroke.fields, seed=stroke.seed, path=stroke.samples, **stroke.settings_with(settings))
        event = self.add(stroke.samples)
        self.end()
        return event

    @contextmanager
    def stroke(self: _Drawing, brush: str | None = None, **settings: Any) -> Iterator[_Drawing]:
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
