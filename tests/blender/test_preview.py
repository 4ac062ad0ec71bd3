"""Strokes on objects that are drawn by the graphics card while the pen is down: what is seen then is what Blender shows of the
result, and the mesh is written once."""

import os
import shutil
import sys

import addon_utils
import bpy
import numpy as np

from support import ADDON
from test_draw import PATH, moves, now, prepared
from windowed import in_view, send, view

KEEP = os.environ.get("BURIN_SCREENSHOT")
"""A folder for the pictures, if they are wanted."""


def seen(name, work):
    """What the view shows, 0..1, rows from below; without its rims, where buttons are."""
    file = str(work / f"{name}.png")
    with in_view():
        bpy.ops.wm.redraw_timer(type="DRAW_WIN_SWAP", iterations=1)
        bpy.ops.screen.screenshot(filepath=file)
    if KEEP:
        shutil.copy(file, KEEP)
    image = bpy.data.images.load(file)
    pixels = np.array(image.pixels[:]).reshape(image.size[1], image.size[0], 4)[..., :3]
    bpy.data.images.remove(image)
    _, region = view()
    in_region = pixels[region.y : region.y + region.height, region.x : region.x + region.width]
    rim = 60
    return in_region[rim:-rim, rim:-rim]


def large(work, smooth, **scale):
    """The scene, all of whose objects count as large, without what the preview leaves out."""
    positions, _ = prepared(work, **scale)
    sys.modules["burin_brushes.preview"].FEWEST_FACES = 0
    bpy.data.objects["Grid"].data.polygons.foreach_set("use_smooth", np.full(len(bpy.data.objects["Grid"].data.polygons), smooth))
    bpy.context.scene.burin.brush = "org.burin.bead"
    space = view()[0].spaces.active
    space.shading.show_specular_highlight = space.shading.show_object_outline = space.show_region_ui = False
    for name in ("floor", "axis_x", "axis_y", "outline_selected", "object_origins", "cursor", "text"):
        setattr(space.overlay, f"show_{name}", False)
    return positions


def is_drawn_by_blender(work):
    """Whether the mesh itself is written while the pen is down; Escape takes the stroke back."""
    before = now()
    send("MOUSEMOVE", "NOTHING", PATH[0])
    yield
    send("LEFTMOUSE", "PRESS", PATH[0])
    yield from moves(PATH)
    yield
    written = not np.array_equal(now(), before)
    assert bpy.data.objects["Grid"].visible_get() == written
    send("ESC", "PRESS", PATH[-1])
    yield
    send("LEFTMOUSE", "RELEASE", PATH[-1])
    send("ESC", "RELEASE", PATH[-1])
    yield
    np.testing.assert_array_equal(now(), before)
    return written


def test_what_the_preview_cannot_show_is_drawn_by_blender(work):
    large(work, True)
    yield
    mesh, shading = bpy.data.objects["Grid"].data, view()[0].spaces.active.shading
    assert not (yield from is_drawn_by_blender(work))
    shading.type = "WIREFRAME"
    assert (yield from is_drawn_by_blender(work))
    shading.type = "SOLID"
    mesh.polygons[0].hide = True
    sys.modules["burin_brushes.object_session"].doubt_faces()
    assert (yield from is_drawn_by_blender(work))


def differing(a, b):
    """The share of pixels that differ by more than a twentieth of the range."""
    return (np.abs(a - b).max(axis=2) > 0.05).mean()


def check_pictures(work, smooth, **scale):
    positions = large(work, smooth, **scale)
    yield
    before = seen("before", work)
    send("MOUSEMOVE", "NOTHING", PATH[0])
    yield
    send("LEFTMOUSE", "PRESS", PATH[0])
    yield
    begun = seen("begun", work)
    assert differing(begun, before) < 0.005, differing(begun, before)
    yield from moves(PATH)
    yield
    during = seen("during", work)
    np.testing.assert_array_equal(now(), positions)
    send("LEFTMOUSE", "RELEASE", PATH[-1])
    yield
    yield
    after = seen("after", work)
    assert (now() != positions).any()
    assert differing(after, before) > 0.01, "the stroke is not seen"
    differ, drawn = differing(during, after), differing(after, before)
    print(f"{differ:.4f} of the pixels differ, where the stroke changed {drawn:.4f}")
    # Normals of vertices are weighted otherwise, which is seen at the foot of the bead, and quads have other diagonals.
    assert differ < drawn / 3
    object = bpy.data.objects["Grid"]
    assert object.visible_get() and object.select_get() and bpy.context.view_layer.objects.active == object


def test_smooth_faces_look_as_blender_shows_them(work):
    yield from check_pictures(work, True)


def test_flat_faces_of_a_mirrored_and_scaled_object_look_as_blender_shows_them(work):
    yield from check_pictures(work, False, scale=(-1, 1.3, 0.8))


def test_escape_shows_the_object_as_it_was(work):
    positions = large(work, True)
    yield
    before = seen("before", work)
    send("MOUSEMOVE", "NOTHING", PATH[0])
    yield
    send("LEFTMOUSE", "PRESS", PATH[0])
    yield from moves(PATH)
    assert differing(seen("during", work), before) > 0.01
    send("ESC", "PRESS", PATH[-1])
    yield
    yield
    np.testing.assert_array_equal(now(), positions)
    assert differing(seen("after", work), before) == 0
    send("LEFTMOUSE", "RELEASE", PATH[-1])
    send("ESC", "RELEASE", PATH[-1])
    yield


def test_nothing_stays_hidden_where_the_addon_is_disabled(work):
    large(work, True)
    object = bpy.data.objects["Grid"]
    yield
    send("MOUSEMOVE", "NOTHING", PATH[0])
    yield
    send("LEFTMOUSE", "PRESS", PATH[0])
    yield from moves(PATH)
    assert not object.visible_get()
    addon_utils.disable(ADDON)
    yield
    assert object.visible_get() and object.select_get()
    send("LEFTMOUSE", "RELEASE", PATH[-1])
    yield


def fails(*_arguments):
    raise MemoryError


def check_fault(work, fault):
    """`fault`: a class and the name of its function that fails when the pen comes down."""
    positions = large(work, True)
    place, name = (getattr(sys.modules[f"burin_brushes.{fault[0]}"], fault[1]), fault[2])
    object, was = bpy.data.objects["Grid"], getattr(place, name)
    yield
    setattr(place, name, fails)
    send("MOUSEMOVE", "NOTHING", PATH[0])
    yield
    send("LEFTMOUSE", "PRESS", PATH[0])
    yield
    setattr(place, name, was)
    send("LEFTMOUSE", "RELEASE", PATH[0])
    yield
    assert object.visible_get() and object.select_get() and not sys.modules["burin_brushes.preview"]._open
    np.testing.assert_array_equal(now(), positions)


# Last, since Blender's message of a fault takes the next press of a button.
def test_nothing_stays_hidden_where_a_stroke_fails(work):
    yield from check_fault(work, ("pen_stroke", "PenStroke", "show"))


def test_nothing_stays_hidden_where_the_preview_fails(work):
    send("LEFTMOUSE", "PRESS", (0.5, 0.05))
    yield
    send("LEFTMOUSE", "RELEASE", (0.5, 0.05))
    yield
    yield from check_fault(work, ("preview", "ShownParts", "send"))
