"""Strokes over several sessions."""

from __future__ import annotations

import ctypes
import weakref
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

from numpy.typing import ArrayLike

from . import _c
from ._settings import Setting, fields_of, setting_texts
from .samples import as_samples
from .session import Session


@dataclass(frozen=True)
class GroupEvent:
    """What became of the samples of a call."""

    drawn: int
    """How many were drawn."""
    on_surface: bool
    """Whether the last was."""
    session: Session
    """On which the pen is, or was last."""


class Group:
    """Sessions that one pen draws on: each sample goes to the surface that its ray meets first, or which is closest to its
    position. What the sessions show is updated in each of them."""

    def __init__(self, sessions: Iterable[Session]) -> None:
        self.sessions = tuple(sessions)
        pointers = (ctypes.c_void_p * len(self.sessions))(*(session._pointer.value for session in self.sessions))
        self._pointer = ctypes.c_void_p()
        _c.call("burin_group_create", pointers, len(pointers), self._pointer)
        # The sessions outlive the group, even if they are closed.
        handles = tuple(session._handle for session in self.sessions)
        self._finalizer = weakref.finalize(self, _destroy, self._pointer, handles)

    def begin(
        self,
        brush: str | None = None,
        *,
        radius: float | None = None,
        fields: str | Iterable[str] = (),
        seed: int = 0,
        **settings: Setting,
    ) -> None:
        """Opens a stroke, as Session.begin() does."""
        lines = setting_texts({"brush": brush, "radius": radius, **settings})
        _c.call("burin_group_begin", self._pointer, _c.Stroke(fields_of(fields), _c.texts(lines), seed))

    def add(self, position: Any, **pen: ArrayLike) -> GroupEvent:
        """Adds samples to the open stroke, as Session.add() does."""
        given = as_samples(position, pen)
        event = _c.GroupEvent()
        _c.call("burin_group_add", self._pointer, given.ctypes.data, len(given), event)
        return GroupEvent(event.drawn, event.outcome == 1, self.sessions[event.session])

    def end(self) -> None:
        """Ends the open stroke, which then can be undone."""
        _c.call("burin_group_end", self._pointer)

    def cancel(self) -> None:
        """Drops the open stroke, if there is one."""
        _c.call("burin_group_cancel", self._pointer)

    @contextmanager
    def stroke(self, brush: str | None = None, **settings: Any) -> Iterator[Group]:
        """Opens a stroke as begin() does, and ends it; an exception cancels it."""
        self.begin(brush, **settings)
        try:
            yield self
        except BaseException:
            self.cancel()
            raise
        self.end()

    def undo(self) -> None:
        """Undoes the last stroke in all sessions that it changed. Raises NotFound if there is none."""
        _c.call("burin_group_undo", self._pointer)

    def redo(self) -> None:
        """Makes the stroke that was undone last again."""
        _c.call("burin_group_redo", self._pointer)


def _destroy(pointer: ctypes.c_void_p, _handles: tuple[object, ...]) -> None:
    _c.lib.burin_group_destroy(pointer)
