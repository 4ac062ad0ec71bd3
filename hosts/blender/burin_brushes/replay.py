"""The operator that draws a recording. Its properties are annotations, which must not be texts."""

import shlex
from typing import Any

import bpy
import burin

from . import brushes, canvas, object_session


def parse_settings(text: str) -> dict[str, Any]:
    """Settings KEY=VALUE between spaces, as keyword arguments of a session; those of params are params=NAME=VALUE."""
    settings: dict[str, Any] = {"params": {}}
    for setting in shlex.split(text):
        key, equals, value = setting.partition("=")
        if not equals:
            raise object_session.Refused(f"settings: {setting!r}: must be KEY=VALUE")
        if key == "params":
            name, _, value = value.partition("=")
            settings["params"][name] = value
        else:
            settings[key] = value
    return settings


def _outputs(path: str, brush: str | None) -> set[str]:
    """What the brushes of a recording write, or the given one. A brush that is not there is refused when it is to draw."""
    names = {brush or stroke.settings.get("brush") for stroke in burin.read_recording(path).strokes}
    return {output for name in names if name in brushes.library() for output in brushes.library()[name].outputs}


class BURIN_OT_replay(bpy.types.Operator):
    """Draw the strokes of a recording on the active object and the other selected meshes"""

    bl_idname = "burin.replay"
    bl_label = "Replay Burin Strokes"
    bl_options = {"REGISTER", "UNDO"}

    filepath: bpy.props.StringProperty(name="Recording", description="A .stroke file", subtype="FILE_PATH")
    filter_glob: bpy.props.StringProperty(default="*.stroke", options={"HIDDEN"})
    brush: bpy.props.StringProperty(name="Brush", description="Id of a brush instead of the recorded one")
    settings: bpy.props.StringProperty(
        name="Settings", description="KEY=VALUE between spaces: radius=0.1 strength=0.5 params=depth=0.2"
    )

    @classmethod
    def poll(cls, context: Any) -> bool:
        return context.mode == "OBJECT" and context.object is not None and context.object.type == "MESH"

    def invoke(self, context: Any, _event: Any) -> set[str]:
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def execute(self, context: Any) -> set[str]:
        try:
            self._draw(context)
        except (burin.Error, object_session.Refused, ValueError) as fault:
            self.report({"ERROR"}, str(fault))
            return {"CANCELLED"}
        return {"FINISHED"}

    def _draw(self, context: Any) -> None:
        path = bpy.path.abspath(self.filepath)
        given = {"brush": self.brush or None, **parse_settings(self.settings)}
        canvas.Canvas(context, _outputs(path, given["brush"])).replay(path, **given)


def register() -> None:
    bpy.utils.register_class(BURIN_OT_replay)


def unregister() -> None:
    bpy.utils.unregister_class(BURIN_OT_replay)
