"""Runs inside Blender, in a window: blender --python draw.py -- STAMP.exr FOLDER

Makes the sphere, leaves in FOLDER what burin needs to draw the same stroke on it (mesh.ply, wave.stroke,
suite.json), draws the stroke with the Draw brush several times, taken back in between, and writes
blender.json.

What is timed is the operator: 200 dabs and the record for undo. The places are given to it, so that it need
not pick, and nothing is redrawn meanwhile.
"""

import json
import math
import os
import sys
import time
import traceback

import bpy
from bpy_extras.view3d_utils import location_3d_to_region_2d
from mathutils import Quaternion, Vector

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import mesh_file
import stroke

SUBDIVISIONS = 10  # 20 * 4^9 triangles


def view_context():
    """The large 3D view of the first window, as an operator wants it named."""
    window = bpy.context.window_manager.windows[0]
    area = next(area for area in window.screen.areas if area.type == "VIEW_3D")
    region = next(region for region in area.regions if region.type == "WINDOW")
    return {"window": window, "screen": window.screen, "area": area, "region": region}


def look_down_on(view):
    """So that the whole sphere is seen from +z: a stroke only begins where its first point is on the screen."""
    view.view_perspective = "ORTHO"
    view.view_rotation = Quaternion((1, 0, 0, 0))
    view.view_location = (0, 0, 0)
    view.view_distance = 3
    view.update()


def make_sphere():
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=SUBDIVISIONS, radius=1)
    bpy.context.object.data.use_mirror_x = False
    return bpy.context.object.name


def set_up_brush(stamp):
    brush = bpy.data.brushes["SculptDraw"]
    tools = bpy.context.tool_settings
    tools.sculpt.brush = brush
    tools.unified_paint_settings.use_unified_size = False
    tools.unified_paint_settings.use_unified_strength = False
    brush.use_locked_size = "SCENE"
    brush.unprojected_radius = stroke.RADIUS
    brush.strength = 0.5
    brush.use_pressure_strength = False
    brush.use_pressure_size = False
    brush.stroke_method = "DOTS"  # a dab for each sample
    texture = bpy.data.textures.new("stamp", "IMAGE")
    texture.image = bpy.data.images.load(stamp)
    brush.texture = texture
    brush.texture_slot.map_mode = "AREA_PLANE"


def stroke_elements(context):
    view = context["area"].spaces.active.region_3d
    elements = []
    for i, place in enumerate(stroke.sample_places()):
        mouse = location_3d_to_region_2d(context["region"], view, Vector(place))
        elements.append({
            "name": "", "location": place, "mouse": mouse, "mouse_event": mouse, "pressure": 1.0,
            "size": 0, "pen_flip": False, "x_tilt": 0, "y_tilt": 0,
            "time": i / stroke.SAMPLES_PER_SECOND, "is_start": i == 0,
        })
    return elements


def moves(before, after):
    """How many vertices moved, and how far at most."""
    distances = [math.dist(before[i : i + 3], after[i : i + 3]) for i in range(0, len(before), 3)
                 if before[i : i + 3] != after[i : i + 3]]
    return len(distances), max(distances, default=0)


def draw_once(name, elements):
    before = mesh_file.positions(bpy.data.objects[name].data)
    begin = time.perf_counter()
    # True: with undo, as when a user draws.
    bpy.ops.sculpt.brush_stroke("EXEC_DEFAULT", True, stroke=elements)
    seconds = time.perf_counter() - begin
    moved, furthest = moves(before, mesh_file.positions(bpy.data.objects[name].data))
    bpy.ops.ed.undo()
    if mesh_file.positions(bpy.data.objects[name].data) != before:
        raise RuntimeError("undo does not bring the sphere back")
    return {"seconds": seconds, "moved": moved, "furthest": furthest}


def draw(stamp, folder):
    context = view_context()
    with bpy.context.temp_override(**context):
        look_down_on(context["area"].spaces.active.region_3d)
        name = make_sphere()
        mesh = bpy.data.objects[name].data
        triangles = len(mesh.polygons)
        mesh_file.write_ply(os.path.join(folder, "mesh.ply"), mesh)
        bpy.ops.object.mode_set(mode="SCULPT")
        set_up_brush(stamp)
        bpy.ops.ed.undo_push(message="before the strokes")
        elements = stroke_elements(context)
        rounds = [draw_once(name, elements) for _ in range(stroke.ROUNDS)]
    with open(os.path.join(folder, "blender.json"), "w", encoding="utf-8") as file:
        json.dump({"version": bpy.app.version_string, "triangles": triangles, "rounds": rounds}, file)


def main():
    stamp, folder = sys.argv[sys.argv.index("--") + 1 :]
    status = 1
    try:
        stroke.write_stroke(os.path.join(folder, "wave.stroke"))
        stroke.write_suite(os.path.join(folder, "suite.json"), stamp)
        draw(stamp, folder)
        status = 0
    except Exception:
        traceback.print_exc()
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)  # rather than quitting, which saves a session of hundreds of megabytes


# The window has no size before it was drawn once.
bpy.app.timers.register(main, first_interval=1)
