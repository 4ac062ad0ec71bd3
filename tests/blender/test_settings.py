"""Properties of Blender from descriptors of brushes, and settings of strokes from properties."""

import math
import os
import types
import unittest

import addon_utils
import bpy
import numpy as np

import burin
from every_param import EveryParam
from support import ADDON, folder, hilly_grid

addon_utils.enable(ADDON)
from burin_brushes import brushes, pen_stroke, settings, view_rays  # noqa: E402


class Everything(EveryParam):
    id = "org.example.everything"
    help = "Declares all there is."
    seen = {}

    def begin(self, start):
        for param in self.params():
            value = start[param]  # arrays are valid during the call
            self.seen[param.id] = value if isinstance(value, str) else np.array(value)

    def evaluate(self, batch):
        batch.up = 0.1


class Properties(unittest.TestCase):
    def test_have_the_ranges_texts_and_defaults_of_parameters(self):
        brushes.library().add(Everything)
        settings.rebuild()
        chosen = bpy.context.scene.burin
        chosen.brush = Everything.id
        group = getattr(chosen, settings.group_of(Everything.id))
        height = group.bl_rna.properties["param_height"]
        self.assertEqual((height.hard_min, height.hard_max, height.soft_max), (0, 1, 0.5))
        self.assertEqual(height.description, "How high. (radii)")
        self.assertEqual([item.identifier for item in group.bl_rna.properties["param_form"].enum_items], ["round", "flat"])
        self.assertEqual(group.bl_rna.properties["param_file"].subtype, "FILE_PATH")
        given = settings.stroke_settings(chosen, pressure=False)
        session = burin.Session(brushes.library(), *hilly_plane())
        session.begin(**given)
        session.add([[-0.5, 0, 0], [0.5, 0, 0]])
        session.end()
        seen = Everything.seen
        self.assertAlmostEqual(float(seen["height"]), 0.1, places=7)
        self.assertEqual((float(seen["count"]), float(seen["on"]), float(seen["form"])), (3, 1, 1))
        self.assertEqual((seen["word"], seen["file"]), ("Größe", ""))
        np.testing.assert_allclose(seen["tint"], (1, 0.5, 0.25, 1))
        np.testing.assert_allclose(seen["profile"], [(0, 1), (1, 0)])

    def test_of_all_stock_brushes_begin_strokes(self):
        chosen = bpy.context.scene.burin
        session = burin.Session(brushes.library(), *hilly_plane())
        names = [item.identifier for item in chosen.bl_rna.properties["brush"].enum_items]
        self.assertGreater(len(names), 10)
        for name in names:
            chosen.brush = name
            given = settings.stroke_settings(chosen, pressure=True)
            stamps = [param.id for param in brushes.library()[name].params if param.type == "file" and param.default is None]
            self.assertEqual([stamp for stamp in stamps if stamp in given["params"]], [])
            if not stamps:
                session.begin(fields="pressure", **given)
                session.cancel()

    def test_of_pressure_and_symmetry_are_settings(self):
        chosen = bpy.context.scene.burin
        chosen.pressure_radius, chosen.mirror = True, (True, False, True)
        self.assertEqual(set(settings.stroke_settings(chosen, pressure=True)["dynamics"]), {"strength", "radius"})
        self.assertEqual(settings.stroke_settings(chosen, pressure=False)["dynamics"], {})
        self.assertEqual(settings.symmetry(chosen, (1, 2, 3)), {"mirror": "xz", "symmetry_centre": (1, 2, 3)})


class Presets(unittest.TestCase):
    def test_bring_back_the_brush_and_its_parameters(self):
        chosen = bpy.context.scene.burin
        chosen.brush, chosen.radius, chosen.pressure_radius = "org.burin.arrow", 0.3, True
        chosen.brush_org_burin_arrow.param_colour = (0.25, 0.5, 0.125, 1)
        chosen.brush_org_burin_arrow.param_height = 0.375
        self.assertEqual(bpy.ops.burin.add_preset(name="Green Arrow"), {"FINISHED"})
        (file,) = bpy.utils.preset_paths("burin")
        self.assertEqual(os.listdir(file), ["Green_Arrow.py"])
        chosen.brush_org_burin_arrow.param_height = 0.5
        chosen.brush_org_burin_arrow.param_colour = (0, 0, 0, 0)
        chosen.brush, chosen.radius, chosen.pressure_radius = "org.burin.rope", 0.1, False
        bpy.ops.script.execute_preset(filepath=f"{file}/Green_Arrow.py", menu_idname="BURIN_MT_presets")
        self.assertEqual((chosen.brush, chosen.pressure_radius), ("org.burin.arrow", True))
        self.assertAlmostEqual(chosen.radius, 0.3)
        self.assertEqual(tuple(chosen.brush_org_burin_arrow.param_colour), (0.25, 0.5, 0.125, 1))
        self.assertEqual(chosen.brush_org_burin_arrow.param_height, 0.375)
        self.assertEqual(bpy.ops.burin.add_preset(name="Green Arrow", remove_name=True), {"FINISHED"})
        self.assertEqual(os.listdir(file), [])


class Pens(unittest.TestCase):
    def test_report_pressure_and_tilt_and_mice_do_not(self):
        pen = types.SimpleNamespace(is_tablet=True, pressure=0.25, tilt=(1, -0.5))
        self.assertEqual(pen_stroke.pen_of(pen), {"pressure": 0.25, "tilt": (math.pi / 2, -math.pi / 4)})
        self.assertEqual(pen_stroke.pen_of(types.SimpleNamespace(is_tablet=False)), {})


class Rays(unittest.TestCase):
    def test_have_the_bits_of_recordings(self):
        seed = 11
        random = np.random.default_rng(seed)
        corners = random.normal(size=(8, 3))
        perspective = [[1.5, 0, 0.1, 0], [0, 2, 0, 0], [0, 0, -1.00002, -0.0200002], [0, 0, -1, 0]]
        parallel = [[0.2, 0, 0, 0], [0, 0.3, 0, 0.1], [0, 0, -0.001, 0], [0, 0, 0, 1]]
        rotation, _ = np.linalg.qr(random.normal(size=(3, 3)))
        view = np.eye(4)
        view[:3, :3], view[:3, 3] = rotation, (0.3, -0.2, -7)
        for projection in (perspective, parallel):
            camera = view_rays.drawing_camera(view, projection, (640, 480), corners)
            pixels = random.integers(0, 480, (200, 2)) + 0.5
            with folder() as work:
                path = f"{work}/rays.stroke"
                with burin.Recorder(path, space="screen", camera=camera) as recorder:
                    recorder.begin(brush="org.burin.groove", radius=0.1)
                    recorder.add(np.column_stack([pixels, 0 * pixels[:, 0]]))
                    recorder.end()
                samples = burin.read_recording(path).strokes[0].samples
                rays = [view_rays.pixel_ray(camera, x, y) for x, y in pixels]
                np.testing.assert_array_equal([origin for origin, _ in rays], samples["position"], err_msg=f"seed {seed}")
                np.testing.assert_array_equal([direction for _, direction in rays], samples["direction"])


def hilly_plane():
    positions, faces = hilly_grid(40)
    return positions, sum(faces, []), [len(face) for face in faces]
