"""Steps of undo that an application holds itself."""

from __future__ import annotations

import ctypes
import weakref
from typing import Any

from . import _c


class Step:
    """What a stroke changed, from Session.take_step() or Step.load(). Session.apply() undoes it, the next time makes it
    again. It may be pickled, and lives without its session."""

    def __init__(self, pointer: ctypes.c_void_p) -> None:
        self._pointer = pointer
        self._finalizer = weakref.finalize(self, _c.lib.burin_step_destroy, pointer)

    @classmethod
    def load(cls, saved: bytes) -> Step:
        """Makes a step of the bytes of save(). Raises Error if they are damaged."""
        pointer = ctypes.c_void_p()
        _c.call("burin_step_load", saved, len(saved), pointer)
        return cls(pointer)

    def save(self) -> bytes:
        """The step as bytes, for a document of the application's."""
        saved = ctypes.create_string_buffer(self._info.saved_bytes)
        _c.call("burin_step_save", self._pointer, saved, len(saved))
        return saved.raw

    @property
    def bytes(self) -> int:
        """What it takes of memory."""
        return int(self._info.bytes)

    @property
    def vertex_count(self) -> int:
        """How many vertices move."""
        return int(self._info.vertex_count)

    @property
    def painted_count(self) -> int:
        """How many vertices change their colour or mask."""
        return int(self._info.painted_count)

    @property
    def _info(self) -> Any:
        info = _c.StepInfo()
        _c.call("burin_step_get_info", self._pointer, info)
        return info

    def __reduce__(self) -> tuple[Any, tuple[Any, ...]]:
        return Step.load, (self.save(),)
