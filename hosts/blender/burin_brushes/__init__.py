"""Burin's brushes in Blender: strokes on the active mesh in object mode, docs/blender.md."""

from __future__ import annotations

import importlib
import sys

bl_info = {
    "name": "Burin",
    "description": "Strokes with Burin's brushes on meshes",
    "author": "Burin authors",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "3D View > Sidebar > Burin",
    "category": "Mesh",
}

_PARTS = ("brushes", "preview", "object_session", "settings", "presets", "replay", "draw", "panel")
"""Modules with register() or unregister(), in the order of their imports."""


def _modules() -> list:
    return [importlib.import_module(f".{part}", __name__) for part in _PARTS]


def register() -> None:
    for module in _modules():
        if hasattr(module, "register"):
            module.register()


def unregister() -> None:
    for module in reversed(_modules()):
        if hasattr(module, "unregister"):
            module.unregister()
    # So that the add-on that is enabled next is the one on disk: imports look here, too.
    for name in [name for name in sys.modules if name.startswith(f"{__name__}.")]:
        del sys.modules[name]
        globals().pop(name.removeprefix(f"{__name__}."), None)
