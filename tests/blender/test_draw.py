"""Strokes of the mouse, simulated by Blender: the bits of the same strokes replayed, undo, and strokes that are taken back."""

import os
import sys

import addon_utils
import bpy
import mathutils
import numpy as np

import burin
from support import ADDON, brush_that_fails, hilly_grid, make_object, positions_of, replayed
from windowed import in_view, send, view

PICTURE = os.environ.get("BURIN_SCREENSHOT")
"""A file for a picture of the window, if one is wanted."""
PANEL = (0.988, 0.7)
"""The place of the tab of the panel, in a window of 1280 x 800 pixels."""
PATH = [(0.35 + 0.3 * s, 0.5 + 0.1 * np.sin(6 * s)) for s in np.linspace(0, 1, 25)]


def prepared(work, scale=(1, 1, 1)):
    """An object in the middle of the view, the tool of the add-on, and what is drawn with."""
    addon_utils.enable(ADDON)
    for other in list(bpy.data.objects):
        bpy.data.objects.remove(other)
    positions, faces = hilly_grid(80)
    made = make_object("Grid", positions, faces)
    made.scale = scale
    bpy.context.view_layer.update()
    region_3d = view()[0].spaces.active.region_3d
    region_3d.view_rotation = mathutils.Euler((0.5, 0.2, 0.3)).to_quaternion()
    region_3d.view_location, region_3d.view_distance = (0, 0, 0), 4
    chosen = bpy.context.scene.burin
    chosen.brush, chosen.radius, chosen.record = "org.burin.groove", 0.15, "//strokes"
    bpy.ops.wm.save_as_mainfile(filepath=str(work / "scene.blend"))
    with in_view():
        view()[0].spaces.active.show_region_ui = bool(PICTURE)
        bpy.ops.wm.tool_set_by_id(name="burin.draw_tool")
        bpy.ops.ed.undo_push(message="Start")
    return positions, faces


def now():
    return positions_of(bpy.data.objects["Grid"])


def moves(path):
    for number, place in enumerate(path):
        send("MOUSEMOVE", "NOTHING", place)
        if number % 8 == 7:
            yield


def stroke(path=PATH, last=("LEFTMOUSE", "RELEASE")):
    send("MOUSEMOVE", "NOTHING", path[0])
    yield
    send("LEFTMOUSE", "PRESS", path[0])
    yield from moves(path)
    send(*last, path[-1])
    yield


def take_picture(file=PICTURE):
    """Of the window with the panel, which a click on its tab shows."""
    for value in ("PRESS", "RELEASE"):
        send("LEFTMOUSE", value, PANEL)
        yield
    send("MOUSEMOVE", "NOTHING", (0.1, 0.1))
    for _ in range(20):
        yield
    with in_view():
        bpy.ops.screen.screenshot(filepath=file)


def test_a_stroke_has_the_bits_of_its_recording(work):
    positions, faces = prepared(work)
    yield
    yield from stroke()
    drawn = now()
    recording = work / "strokes/0001.stroke"
    assert len(burin.read_recording(recording).strokes[0].samples) == len(PATH) + 1
    expected, _ = replayed(work, recording, positions, faces)
    np.testing.assert_array_equal(drawn, expected)
    assert (drawn != positions).any(axis=1).sum() > 100
    if PICTURE:
        yield from take_picture()

    yield from stroke([(x, y + 0.12) for x, y in PATH])
    two = now()
    assert (two != drawn).any() and (work / "strokes/0002.stroke").exists()
    with in_view():
        bpy.ops.ed.undo()
        np.testing.assert_array_equal(now(), drawn)
        bpy.ops.ed.undo()
        np.testing.assert_array_equal(now(), positions)
        bpy.ops.ed.redo()
        np.testing.assert_array_equal(now(), drawn)
        bpy.ops.burin.replay(filepath=str(work / "strokes/0002.stroke"))
    np.testing.assert_array_equal(now(), two)


def test_a_stroke_on_a_scaled_object_has_the_bits_of_its_recording(work):
    positions, _ = prepared(work, (1, 1.5, 0.5))
    yield
    yield from stroke()
    drawn = now()
    assert (drawn != positions).any(axis=1).sum() > 100
    bpy.data.objects["Grid"].data.vertices.foreach_set("co", positions.ravel())
    with in_view():
        bpy.ops.burin.replay(filepath=str(work / "strokes/0001.stroke"))
    np.testing.assert_array_equal(now(), drawn)


def test_a_stroke_over_two_objects_is_one_step_of_both(work):
    positions, faces = prepared(work)
    make_object("Second", (positions * [2, 1, 1]).astype(np.float32), faces)
    both = [bpy.data.objects[name] for name in ("Grid", "Second")]
    both[0].location.x, both[1].location.x, both[1].scale.x = -1, 1, 0.5
    for object in both:
        object.select_set(True)
    bpy.context.view_layer.update()
    with in_view():
        bpy.ops.ed.undo_push(message="Two")

    def all_now():
        return [positions_of(bpy.data.objects[name]) for name in ("Grid", "Second")]

    before = all_now()
    yield
    yield from stroke()
    drawn = all_now()
    for now_one, before_one in zip(drawn, before):
        assert (now_one != before_one).any(axis=1).sum() > 100
    if PICTURE:
        yield from take_picture(PICTURE + ".two.png")
    with in_view():
        bpy.ops.ed.undo()
        np.testing.assert_array_equal(all_now(), before)
        bpy.ops.burin.replay(filepath=str(work / "strokes/0001.stroke"))
    np.testing.assert_array_equal(all_now(), drawn)
    send("LEFTMOUSE", "PRESS", PATH[0])
    yield from moves(PATH)
    assert not np.array_equal(all_now(), drawn)
    send("ESC", "PRESS", PATH[-1])
    yield
    np.testing.assert_array_equal(all_now(), drawn)
    send("LEFTMOUSE", "RELEASE", PATH[-1])
    send("ESC", "RELEASE", PATH[-1])
    yield


def test_escape_and_the_right_button_take_strokes_back(work):
    positions, _ = prepared(work)
    yield
    for last in (("ESC", "PRESS"), ("RIGHTMOUSE", "PRESS")):
        send("MOUSEMOVE", "NOTHING", PATH[0])
        yield
        send("LEFTMOUSE", "PRESS", PATH[0])
        yield from moves(PATH)
        assert (now() != positions).any(), "nothing was shown while the pen was down"
        send(*last, PATH[-1])
        yield
        np.testing.assert_array_equal(now(), positions)
        assert not list(work.glob("strokes/*.stroke"))
        send("LEFTMOUSE", "RELEASE", PATH[-1])
        send(last[0], "RELEASE", PATH[-1])
        yield
    yield from stroke()
    assert (now() != positions).any()


def test_a_stroke_that_paints_is_seen_and_taken_back(work):
    positions, faces = prepared(work)
    view()[0].spaces.active.shading.color_type = "VERTEX"
    chosen = bpy.context.scene.burin
    chosen.brush, chosen.radius = "org.burin.arrow", 0.2
    chosen.brush_org_burin_arrow.param_colour = (0.5, 0.05, 0.02, 1)
    mesh = bpy.data.objects["Grid"].data

    def colours():
        values = np.empty(4 * len(positions), np.float32)
        mesh.color_attributes.active_color.data.foreach_get("color", values)
        return values.reshape(-1, 4)

    yield
    send("MOUSEMOVE", "NOTHING", PATH[0])
    yield
    send("LEFTMOUSE", "PRESS", PATH[0])
    yield from moves(PATH)
    assert (colours() < 0.6).any(), "nothing was shown while the pen was down"
    send("ESC", "PRESS", PATH[-1])
    yield
    assert mesh.color_attributes.active_color is None
    np.testing.assert_array_equal(now(), positions)
    send("LEFTMOUSE", "RELEASE", PATH[-1])
    send("ESC", "RELEASE", PATH[-1])
    yield
    yield from stroke()
    oracle = burin.Session(burin.Library(), positions, sum(faces, []), [len(face) for face in faces])
    oracle.write("colours", np.ones((len(positions), 4), np.float32))
    oracle.replay(work / "strokes/0001.stroke")
    np.testing.assert_array_equal(colours(), oracle.read("colours"))
    np.testing.assert_array_equal(now(), oracle.read())
    if PICTURE:
        yield from take_picture(PICTURE + ".paint.png")


def test_a_brush_that_fails_costs_its_stroke(work):
    Faulty = brush_that_fails(after=0.5)

    positions, _ = prepared(work)
    sys.modules["burin_brushes.brushes"].library().add(Faulty)
    sys.modules["burin_brushes.settings"].rebuild()
    chosen = bpy.context.scene.burin
    chosen.brush, chosen.radius, chosen.record = Faulty.id, 0.15, "//strokes"
    yield
    yield from stroke()
    np.testing.assert_array_equal(now(), positions)
    assert not list(work.glob("strokes/*.stroke"))
    for place in ((0.1, 0.9), (0.1, 0.1)):  # the message goes when the mouse leaves it
        send("MOUSEMOVE", "NOTHING", place)
        yield
    chosen.brush = "org.burin.groove"
    yield from stroke()
    assert (now() != positions).any()
