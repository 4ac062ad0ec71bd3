"""Strokes over several sessions."""

from __future__ import annotations

import ctypes
import weakref
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from numpy.typing import ArrayLike

from . import _c
from ._drawing import Drawing
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


class Group(Drawing[GroupEvent]):
    """Sessions that one pen draws on: each sample goes to the surface that its ray meets first, or which is closest to its
    position. What the sessions show is updated in each of them."""

    _functions = "burin_group"

    def __init__(self, sessions: Iterable[Session]) -> None:
        self.sessions = tuple(sessions)
        pointers = (ctypes.c_void_p * len(self.sessions))(*(session._pointer.value for session in self.sessions))
        self._pointer = ctypes.c_void_p()
        _c.call("burin_group_create", pointers, len(pointers), self._pointer)
        # The sessions outlive the group, even if they are closed.
        handles = tuple(session._handle for session in self.sessions)
        self._finalizer = weakref.finalize(self, _destroy, self._pointer, handles)

    def _call(self, name: str, *args: Any) -> None:
        _c.call(name, self._pointer, *args, cause_of=self._cause_of)

    def _cause_of(self, text: str) -> BaseException | None:
        """What a brush raised that a text of one of the libraries has."""
        causes = [library._take_fault(text) for library in {session.library for session in self.sessions}]
        return next((cause for cause in causes if cause), None)

    def add(self, position: Any, **pen: ArrayLike) -> GroupEvent:
        """Adds samples to the open stroke, as Session.add() does."""
        given = as_samples(position, pen)
        event = _c.GroupEvent()
        self._call("burin_group_add", given.ctypes.data, len(given), event)
        return GroupEvent(event.drawn, event.outcome == 1, self.sessions[event.session])

    def undo(self) -> None:
        """Undoes the last stroke in all sessions that it changed. Raises NotFound if there is none."""
        self._call("burin_group_undo")

    def redo(self) -> None:
        """Makes the stroke that was undone last again."""
        self._call("burin_group_redo")


def _destroy(pointer: ctypes.c_void_p, _handles: tuple[object, ...]) -> None:
    _c.lib.burin_group_destroy(pointer)
