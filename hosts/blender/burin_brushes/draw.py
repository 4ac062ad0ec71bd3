"""The operator and the tool that draw with the pen or the mouse."""

from __future__ import annotations

from typing import Any

import bpy
import burin

from . import object_session, pen_stroke


class BURIN_OT_draw(bpy.types.Operator):
    """Draw a stroke on the active object and the other selected meshes; Escape or the right button takes it back"""

    bl_idname = "burin.draw"
    bl_label = "Draw Burin Stroke"
    bl_options = {"UNDO"}

    @classmethod
    def poll(cls, context: Any) -> bool:
        return context.mode == "OBJECT" and context.object is not None and context.region_data is not None

    def invoke(self, context: Any, event: Any) -> set[str]:
        self._button = event.type
        self._stroke = None
        return self._tried(self._begin, context, event)

    def modal(self, context: Any, event: Any) -> set[str]:
        return self._tried(self._go_on, context, event)

    def _tried(self, step: Any, context: Any, event: Any) -> set[str]:
        """What a step returns; if it fails the mesh is as before the stroke, and the user gets the text."""
        try:
            return step(context, event)
        except (burin.Error, object_session.Refused, OSError) as fault:
            self.cancel(context)
            self.report({"ERROR"}, str(fault))
            return {"CANCELLED"}
        except BaseException:
            self.cancel(context)
            raise

    def cancel(self, _context: Any) -> None:
        """Takes the stroke back; Blender calls it where it ends operators, as before another file is loaded."""
        if self._stroke:
            self._stroke.cancel()
        self._stroke = None

    def _begin(self, context: Any, event: Any) -> set[str]:
        self._stroke = pen_stroke.PenStroke(context, event)
        self._stroke.add(event)
        self._stroke.show()
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def _go_on(self, context: Any, event: Any) -> set[str]:
        if event.type in ("ESC", "RIGHTMOUSE"):
            self.cancel(context)
            return {"CANCELLED"}
        if event.type in ("MOUSEMOVE", "INBETWEEN_MOUSEMOVE"):
            self._stroke.add(event)
        if event.type == "MOUSEMOVE":  # the last of those that came while Blender was drawing
            self._stroke.show()
        if event.type == self._button and event.value == "RELEASE":
            self._stroke.end()
            return {"FINISHED"}
        return {"RUNNING_MODAL"}


class BurinTool(bpy.types.WorkSpaceTool):
    bl_space_type = "VIEW_3D"
    bl_context_mode = "OBJECT"
    bl_idname = "burin.draw_tool"
    bl_label = "Burin"
    bl_description = "Draw strokes with Burin's brushes"
    bl_icon = "brush.gpencil_draw.draw"
    bl_keymap = (("burin.draw", {"type": "LEFTMOUSE", "value": "PRESS"}, None),)


def register() -> None:
    bpy.utils.register_class(BURIN_OT_draw)
    if not bpy.app.background:
        bpy.utils.register_tool(BurinTool, separator=True)


def unregister() -> None:
    if not bpy.app.background:
        bpy.utils.unregister_tool(BurinTool)
    bpy.utils.unregister_class(BURIN_OT_draw)
