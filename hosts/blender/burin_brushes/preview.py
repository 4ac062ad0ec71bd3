"""Objects as an open stroke leaves them, drawn without Blender's evaluation of the mesh, which takes a second where there are
millions of triangles. So long the objects themselves are hidden. The graphics card has their triangles in parts and gets
those anew that changed.

The shading is that of solid views with studio lights, without their highlights.
"""

from __future__ import annotations

import functools
from typing import Any

import bpy
import gpu
import numpy as np

from . import mesh_parts, mesh_io

FEWEST_FACES = 200_000
"""Of an object that is drawn so. Blender shows smaller ones within some hundredths of a second, with all that they look
like."""

_LIGHTS = 4
_SCENE = f"""
struct Scene {{
  mat4 to_view;
  mat4 projection;
  vec4 colour;                      /* w: 1 for smooth faces, 0 for flat ones */
  vec4 light_colour[{_LIGHTS}];
  vec4 light_direction[{_LIGHTS}];  /* towards the light, in the view; w: by how much it reaches around */
  vec4 ambient;
}};
"""
_VERTEX = """
void main()
{
  vec4 at = scene.to_view * vec4(position, 1.0);
  in_view = at.xyz;
  /* The inverse transpose, but for the length: normals of objects that are scaled unevenly. */
  mat3 linear = mat3(scene.to_view);
  mat3 cofactors = mat3(cross(linear[1], linear[2]), cross(linear[2], linear[0]), cross(linear[0], linear[1]));
  normal_in_view = cofactors * normal;
  gl_Position = scene.projection * at;
}
"""
_FRAGMENT = """
void main()
{
  vec3 facing = normalize(cross(dFdx(in_view), dFdy(in_view)));
  vec3 n = scene.colour.w > 0.5 ? normalize(normal_in_view) : facing;
  if (dot(n, facing) < 0.0) n = -n;
  vec3 light = scene.ambient.rgb;
  for (int i = 0; i < LIGHTS; i++) {
    vec4 direction = scene.light_direction[i];
    float around = 1.0 + direction.w;
    light += scene.light_colour[i].rgb * clamp((dot(n, direction.xyz) + direction.w) / (around * around), 0.0, 1.0);
  }
  colour = vec4(light * scene.colour.rgb, 1.0);
}
"""


@functools.cache
def _shader() -> Any:
    """One for all strokes: batches keep what they know of the shader that they were drawn with."""
    between = gpu.types.GPUStageInterfaceInfo("burin_preview")
    between.smooth("VEC3", "in_view")
    between.smooth("VEC3", "normal_in_view")
    info = gpu.types.GPUShaderCreateInfo()
    info.typedef_source(_SCENE)
    info.define("LIGHTS", str(_LIGHTS))
    info.uniform_buf(0, "Scene", "scene")
    info.vertex_in(0, "VEC3", "position")
    info.vertex_in(1, "VEC3", "normal")
    info.vertex_out(between)
    info.fragment_out(0, "VEC4", "colour")
    info.vertex_source(_VERTEX)
    info.fragment_source(_FRAGMENT)
    return gpu.shader.create_from_info(info)


def _surface_colour(object: Any, shading: Any) -> tuple[float, ...]:
    if shading.color_type == "SINGLE":
        return tuple(shading.single_color)
    if shading.color_type == "OBJECT":
        return tuple(object.color)[:3]
    if shading.color_type == "MATERIAL" and object.active_material:
        return tuple(object.active_material.diffuse_color)[:3]
    return (0.8, 0.8, 0.8)


def _scene(object: Any, context: Any) -> Any:
    """What the shader wants to know, for one view."""
    view, shading, system = context.region_data, context.space_data.shading, context.preferences.system
    lights = [light for light in system.solid_lights if light.use][:_LIGHTS] if shading.light != "FLAT" else []
    colours, directions = np.zeros((2, _LIGHTS, 4), np.float32)
    for i, light in enumerate(lights):
        colours[i, :3] = light.diffuse_color
        directions[i] = *light.direction, light.smooth
    ambient = system.light_ambient if lights else (1, 1, 1)
    smooth = object.data.polygons[0].use_smooth
    values = [
        np.array(view.view_matrix @ object.matrix_world).T,
        np.array(view.window_matrix).T,
        (*_surface_colour(object, shading), smooth),
        colours,
        directions,
        (*ambient, 0),
    ]
    return gpu.types.GPUUniformBuf(np.concatenate([np.ravel(value) for value in values]).astype(np.float32))


class ShownParts:
    """The triangles of a session on the graphics card."""

    def __init__(self, session: Any) -> None:
        self._session = session
        self._mesh = mesh_parts.MeshParts(session.triangles, session.info.vertex_count)
        self._format = gpu.types.GPUVertFormat()
        for name in ("position", "normal"):
            self._format.attr_add(id=name, comp_type="F32", len=3, fetch_mode="FLOAT")
        self._corners = [gpu.types.GPUIndexBuf(type="TRIS", seq=part.triangles) for part in self._mesh.parts]
        self._batches: list[Any] = [None] * len(self._mesh.parts)  # until all vertices were sent once

    def send(self, positions: mesh_io.Floats, ranges: Any) -> None:
        """Sends the positions and normals of all vertices in ranges, and of those around whose normals changed."""
        turned = self._session.update("normals", most=1024)
        normals = self._session.values("normals")
        changed = np.concatenate([np.asarray(some, np.uint64).reshape(-1, 2) for some in (ranges, turned)])
        for number in self._mesh.touched(changed):
            vertices = self._mesh.parts[number].vertices
            buffer = gpu.types.GPUVertBuf(self._format, len(vertices))
            buffer.attr_fill("position", positions[vertices])
            buffer.attr_fill("normal", normals[vertices])
            self._batches[number] = gpu.types.GPUBatch(type="TRIS", buf=buffer, elem=self._corners[number])

    def draw(self, shader: Any) -> None:
        for batch in self._batches:
            batch.draw(shader)


class Preview:
    """Objects that are drawn from here while a stroke is open."""

    def __init__(self, objects: list[tuple[Any, ShownParts]]) -> None:
        self._objects = objects
        self._layer = bpy.context.view_layer
        self._selected = [object.select_get() for object, _ in objects]  # what is hidden is selected no more
        self._handler = bpy.types.SpaceView3D.draw_handler_add(self._draw, (), "WINDOW", "POST_VIEW")
        _open.append(self)
        for object, _ in objects:
            object.hide_set(True)

    def _draw(self) -> None:
        context = bpy.context
        if context.view_layer != self._layer:
            return
        gpu.state.depth_test_set("LESS_EQUAL")
        gpu.state.depth_mask_set(True)
        gpu.state.face_culling_set("BACK" if context.space_data.shading.show_backface_culling else "NONE")
        try:
            self._draw_objects(context)
        finally:
            gpu.state.face_culling_set("NONE")
            gpu.state.depth_mask_set(False)
            gpu.state.depth_test_set("NONE")

    def _draw_objects(self, context: Any) -> None:
        shader, space = _shader(), context.space_data
        for object, parts in self._objects:
            if space.local_view and not object.local_view_get(space):
                continue
            shader.bind()
            scene = _scene(object, context)  # the shader keeps no reference
            shader.uniform_block("scene", scene)
            parts.draw(shader)

    def shows(self, object: Any) -> bool:
        """Whether an object is drawn from here, until the preview is closed."""
        return self in _open and any(own == object for own, _ in self._objects)

    def close(self) -> None:
        """Shows the objects themselves again. Those that are gone since are passed over. It may be closed already."""
        if self not in _open:
            return
        _open.remove(self)
        bpy.types.SpaceView3D.draw_handler_remove(self._handler, "WINDOW")
        for (object, _), selected in zip(self._objects, self._selected):
            try:
                object.hide_set(False, view_layer=self._layer)
                object.select_set(selected, view_layer=self._layer)
            except (ReferenceError, RuntimeError):
                continue
        redraw()


_open: list[Preview] = []


@bpy.app.handlers.persistent
def close_all(*_event: Any) -> None:
    """Shows all objects themselves, before another file is loaded or the add-on goes."""
    for shown in list(_open):
        shown.close()


def redraw() -> None:
    """Has Blender draw its 3D views again."""
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "VIEW_3D":
                area.tag_redraw()


def _views() -> Any:
    """The 3D views of the view layer: their spaces and what they look at."""
    for window in bpy.context.window_manager.windows:
        if window.view_layer == bpy.context.view_layer:
            yield from (area.spaces.active for area in window.screen.areas if area.type == "VIEW_3D")


def _is_plain(space: Any) -> bool:
    return space.shading.type == "SOLID" and not space.shading.show_xray and not space.region_3d.use_clip_planes


def is_wanted(object: Any) -> bool:
    """Whether an object is so large, and plain in all views that show it, that it is drawn from here."""
    if bpy.app.background or len(object.data.polygons) < FEWEST_FACES:
        return False
    return object.visible_get() and object.display_type in ("SOLID", "TEXTURED") and all(map(_is_plain, _views()))


def register() -> None:
    bpy.app.handlers.load_pre.append(close_all)


def unregister() -> None:
    close_all()
    bpy.app.handlers.load_pre.remove(close_all)
