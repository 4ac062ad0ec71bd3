"""Errors of the library as exceptions. Their texts are the lines that the command prints."""

from __future__ import annotations

from typing import NoReturn


class Error(RuntimeError):
    """A call failed. Within a stroke that drops the stroke: the surface is as before it, and the session goes on.

    If a function of Python caused it, as a brush or a progress function, `__cause__` is the exception that it raised.
    """


class InvalidArgument(Error, ValueError):
    """An argument is wrong. Nothing has changed, an open stroke neither."""


class NotFound(Error, LookupError):
    """There is no such brush, or nothing to undo or redo. Nothing has changed."""


class Unsupported(Error):
    """What was asked for is valid, but the library does not support it."""


class OutOfMemory(Error, MemoryError):
    """There is not enough memory."""


_KINDS: dict[int, type[Error]] = {3: InvalidArgument, 4: Unsupported, 5: NotFound, 6: OutOfMemory}


def raise_status(status: int, text: str, cause: BaseException | None = None) -> NoReturn:
    """Raises the exception of a status other than BURIN_OK."""
    raise _KINDS.get(status, Error)(text) from cause
