"""The panel in the sidebar of the 3D view."""

from __future__ import annotations

from typing import Any

import bpy

from . import presets, settings


class BURIN_PT_brush(bpy.types.Panel):
    bl_label = "Burin"
    bl_idname = "BURIN_PT_brush"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Burin"
    bl_context = "objectmode"

    def draw(self, context: Any) -> None:
        chosen = context.scene.burin
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        presets.draw(layout)
        for name in ("brush", "radius", "strength", "follow"):
            layout.prop(chosen, name)
        pressure = layout.column(heading="Pressure")
        pressure.prop(chosen, "pressure_strength", text="Strength")
        pressure.prop(chosen, "pressure_radius", text="Radius")
        mirror = layout.row(heading="Mirror", align=True)
        for index, axis in enumerate("XYZ"):
            mirror.prop(chosen, "mirror", index=index, text=axis, toggle=True)
        layout.separator()
        brush = settings.chosen(chosen)
        group = getattr(chosen, settings.group_of(brush.id))
        for param in brush.params:
            layout.prop(group, settings.param_of(param.id))
        layout.separator()
        layout.prop(chosen, "record")
        layout.operator("burin.replay", icon="FILE_REFRESH")


def register() -> None:
    bpy.utils.register_class(BURIN_PT_brush)


def unregister() -> None:
    bpy.utils.unregister_class(BURIN_PT_brush)
