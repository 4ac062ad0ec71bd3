"""The library of brushes, which the add-on has one of."""

from __future__ import annotations

import burin

_library: burin.Library | None = None


def library() -> burin.Library:
    """The stock brushes, those of BURIN_PLUGIN_PATH, and what scripts add: library().add(MyBrush)."""
    global _library
    if _library is None:
        _library = burin.Library()
    return _library


def unregister() -> None:
    global _library
    _library = None
