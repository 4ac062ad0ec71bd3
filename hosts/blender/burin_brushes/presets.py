"""Presets: brushes with what they are drawn with, kept by Blender as those of its own operators are."""

from __future__ import annotations

from typing import Any

import bpy
from bl_operators.presets import AddPresetBase

from . import settings

_FOLDER = "burin"
"""Below scripts/presets of the user."""


class BURIN_MT_presets(bpy.types.Menu):
    bl_label = "Presets"
    preset_subdir = _FOLDER
    preset_operator = "script.execute_preset"
    draw = bpy.types.Menu.draw_preset


class BURIN_OT_add_preset(AddPresetBase, bpy.types.Operator):
    """Keep the brush, its parameters and how strokes are drawn as a preset, or remove the chosen one"""

    bl_idname = "burin.add_preset"
    bl_label = "Add Burin Preset"
    preset_menu = BURIN_MT_presets.__name__
    preset_subdir = _FOLDER
    preset_defines = ("chosen = bpy.context.scene.burin",)

    @property
    def preset_values(self) -> list[str]:
        """The properties of the scene that a preset has. Parameters follow the brush."""
        chosen = bpy.context.scene.burin
        brush = settings.chosen(chosen)
        group = settings.group_of(brush.id)
        params = [f"{group}.{settings.param_of(param.id)}" for param in brush.params]
        return [f"chosen.{name}" for name in ("brush", *settings.FEEL, *params)]


def draw(layout: Any) -> None:
    """The row of the panel."""
    row = layout.row(align=True)
    row.menu(BURIN_MT_presets.__name__, text=BURIN_MT_presets.bl_label)
    row.operator(BURIN_OT_add_preset.bl_idname, text="", icon="ADD")
    row.operator(BURIN_OT_add_preset.bl_idname, text="", icon="REMOVE").remove_active = True


def register() -> None:
    for made in (BURIN_MT_presets, BURIN_OT_add_preset):
        bpy.utils.register_class(made)


def unregister() -> None:
    for made in (BURIN_OT_add_preset, BURIN_MT_presets):
        bpy.utils.unregister_class(made)
