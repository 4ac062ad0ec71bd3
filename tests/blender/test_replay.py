"""The operator that draws recordings: the bits of `burin replay`, Blender's undo, and meshes that stay as they were."""

import sys
import unittest
from pathlib import Path

import addon_utils
import bpy
import mathutils
import numpy as np

import burin
from support import ADDON, activate, brush_that_fails, folder, hilly_grid, make_object, positions_of, replayed, write_stroke


class OfOneMesh(unittest.TestCase):
    def setUp(self):
        bpy.ops.wm.read_factory_settings(use_empty=True)
        addon_utils.enable(ADDON)
        self.positions, self.faces = hilly_grid()
        self.object = make_object("Grid", self.positions, self.faces)
        work = folder()
        self.addCleanup(work.cleanup)
        self.work = Path(work.name)
        self.stroke = write_stroke(self.work / "one.stroke")
        bpy.ops.ed.undo_push(message="Start")

    def replay(self, stroke=None, **settings):
        return bpy.ops.burin.replay("EXEC_DEFAULT", True, filepath=str(stroke or self.stroke), **settings)  # with its undo step

    def now(self):
        return positions_of(bpy.data.objects["Grid"])


class Replays(OfOneMesh):
    def test_equal_the_command(self):
        for settings, options in (
            ("", []),
            ("radius=0.2 params=depth=0.1 strength=-1", ["--radius", "0.2", "--param", "depth=0.1", "--strength", "-1"]),
        ):
            with self.subTest(settings):
                self.setUp()
                expected, _ = replayed(self.work, self.stroke, self.positions, self.faces, *options)
                self.assertEqual(self.replay(settings=settings), {"FINISHED"})
                np.testing.assert_array_equal(self.now(), expected)
                self.assertGreater((expected != self.positions).any(axis=1).sum(), 100)

    def test_follow_each_other(self):
        second = write_stroke(self.work / "two.stroke", brush="org.burin.rope", shift=0.2, params={})
        both = self.work / "both.stroke"
        both.write_text(self.stroke.read_text() + "".join(second.read_text().splitlines(True)[1:]))
        expected, _ = replayed(self.work, both, self.positions, self.faces)
        self.replay()
        self.replay(second)
        np.testing.assert_array_equal(self.now(), expected)
        self.object.data.vertices.foreach_set("co", self.positions.ravel())
        self.replay(both)
        np.testing.assert_array_equal(self.now(), expected)

    def test_are_undone_and_redone(self):
        second = write_stroke(self.work / "two.stroke", shift=0.2)
        self.replay()
        one = self.now()
        self.replay(second)
        two = self.now()
        bpy.ops.ed.undo()
        np.testing.assert_array_equal(self.now(), one)
        bpy.ops.ed.undo()
        np.testing.assert_array_equal(self.now(), self.positions)
        bpy.ops.ed.redo()
        np.testing.assert_array_equal(self.now(), one)
        self.replay(second)
        np.testing.assert_array_equal(self.now(), two)

    def test_are_saved(self):
        self.replay()
        drawn = self.now()
        file = str(self.work / "drawn.blend")
        bpy.ops.wm.save_as_mainfile(filepath=file)
        bpy.ops.wm.open_mainfile(filepath=file)
        np.testing.assert_array_equal(self.now(), drawn)
        activate(bpy.data.objects["Grid"])
        self.assertEqual(self.replay(write_stroke(self.work / "two.stroke", shift=0.2)), {"FINISHED"})
        self.assertFalse(np.array_equal(self.now(), drawn))

    def test_of_two_objects_are_their_own(self):
        other_positions = (self.positions * [1, 1, 2]).astype(np.float32)
        other = make_object("Other", other_positions, self.faces)
        expected, _ = replayed(self.work, self.stroke, self.positions, self.faces)
        expected_other, _ = replayed(self.work, self.stroke, other_positions, self.faces)
        self.replay()
        np.testing.assert_array_equal(self.now(), self.positions)
        activate(self.object)
        self.replay()
        np.testing.assert_array_equal(self.now(), expected)
        np.testing.assert_array_equal(positions_of(other), expected_other)

    def test_see_what_other_tools_did(self):
        self.replay()
        moved = self.now()
        moved[1000:2000, 2] += np.float32(0.05)
        self.object.data.vertices.foreach_set("co", moved.ravel())
        self.replay()
        oracle = burin.Session(burin.Library(), self.positions, sum(self.faces, []), [len(face) for face in self.faces])
        oracle.replay(self.stroke)
        oracle.write("positions", moved)
        oracle.replay(self.stroke)
        np.testing.assert_array_equal(self.now(), oracle.read())
        bpy.ops.object.mode_set(mode="EDIT")
        bpy.ops.mesh.select_all(action="SELECT")
        bpy.ops.mesh.flip_normals()
        bpy.ops.object.mode_set(mode="OBJECT")
        flipped = [list(face.vertices) for face in self.object.data.polygons]  # each begins at some corner
        self.object.data.vertices.foreach_set("co", self.positions.ravel())
        self.replay()
        inside_out, _ = replayed(self.work, self.stroke, self.positions, flipped)
        np.testing.assert_array_equal(self.now(), inside_out)
        outside_out, _ = replayed(self.work, self.stroke, self.positions, self.faces)
        self.assertFalse(np.array_equal(inside_out, outside_out))

    def test_on_scaled_objects_are_round_in_the_world(self):
        for scale in ((1, 3, 1), (1, -3, 1)):
            with self.subTest(scale):
                self.setUp()
                local = (self.positions / [1, scale[1], 1]).astype(np.float32)
                self.object.data.vertices.foreach_set("co", local.ravel())
                self.object.scale = scale
                bpy.context.view_layer.update()
                world = (local * np.array(scale)).astype(np.float32)
                faces = self.faces if scale[1] > 0 else [face[:1] + face[:0:-1] for face in self.faces]
                expected, _ = replayed(self.work, self.stroke, world, faces)
                self.assertEqual(self.replay(), {"FINISHED"})
                np.testing.assert_allclose(self.now() * np.array(scale), expected, atol=1e-6)
                still = (expected == world).all(axis=1)
                self.assertGreater((~still).sum(), 100)
                np.testing.assert_array_equal(self.now()[still], local[still])

    def test_on_scaled_objects_are_the_same_after_undo(self):
        turned = mathutils.Matrix.LocRotScale((0.1, 0.2, 0), mathutils.Euler((0.1, 0.2, 0.7)), (1.1, 0.7, 1.3))
        self.object.matrix_world = turned
        bpy.context.view_layer.update()
        bpy.ops.ed.undo_push(message="Turned")
        second = write_stroke(self.work / "two.stroke", shift=0.1)
        self.replay()
        one = self.now()
        self.replay(second)
        two = self.now()
        self.assertGreater(((one != self.positions) & (one != two)).any(axis=1).sum(), 100)
        bpy.ops.ed.undo()
        np.testing.assert_array_equal(self.now(), one)
        self.replay(second)
        np.testing.assert_array_equal(self.now(), two)

    def test_leave_hidden_faces_out(self):
        numbers = np.arange(len(self.faces))
        kept = None
        for hidden in ((numbers >= 1500) & (numbers < 1540), numbers % 60 < 30, numbers < 0):
            self.object.data.vertices.foreach_set("co", self.positions.ravel())
            self.object.data.polygons.foreach_set("hide", hidden)
            for mode in ("EDIT", "OBJECT"):
                bpy.ops.object.mode_set(mode=mode)
            shown = [face for face, is_hidden in zip(self.faces, hidden) if not is_hidden]
            expected, _ = replayed(self.work, self.stroke, self.positions, shown)
            whole, _ = replayed(self.work, self.stroke, self.positions, self.faces)
            self.replay()
            np.testing.assert_array_equal(self.now(), expected)
            self.assertEqual(np.array_equal(expected, whole), not hidden.any())
            (session,) = sys.modules["burin_brushes.object_session"]._sessions.values()
            self.assertIn(kept, (None, session), "the session stays")
            kept = session


class OfSeveralMeshes(OfOneMesh):
    """Two squares that touch at x = 0, the second one scaled and turned in its own space."""

    def setUp(self):
        super().setUp()
        self.object.location.x = -1
        self.second = make_object("Second", (self.positions * [0.5, 2, 1]).astype(np.float32), self.faces)
        self.second.location.x, self.second.scale = 1.01, (2, 0.5, 1)
        self.third = make_object("Third", self.positions, self.faces)
        for object, selected in ((self.object, True), (self.second, True), (self.third, False)):
            object.select_set(selected)
        bpy.context.view_layer.objects.active = self.object
        bpy.context.view_layer.update()
        bpy.ops.ed.undo_push(message="Three")
        self.names = ("Grid", "Second", "Third")

    def all_now(self):
        return [positions_of(bpy.data.objects[name]) for name in self.names]

    def sessions(self):
        return [
            burin.Session(
                burin.Library(),
                positions_of(object),
                sum(self.faces, []),
                [len(face) for face in self.faces],
                transform=np.array(object.matrix_world),
            )
            for object in (self.object, self.second)
        ]

    def test_is_one_stroke_and_one_step(self):
        before = self.all_now()
        oracles = self.sessions()
        burin.Group(oracles).draw(burin.read_recording(self.stroke).strokes[0])
        self.assertEqual(self.replay(), {"FINISHED"})
        drawn = self.all_now()
        for now, oracle, start in zip(drawn, oracles, before):
            np.testing.assert_array_equal(now, oracle.read())
            self.assertGreater((now != start).any(axis=1).sum(), 50)
        np.testing.assert_array_equal(drawn[2], before[2], "not selected")
        bpy.ops.ed.undo()
        np.testing.assert_array_equal(self.all_now(), before)
        bpy.ops.ed.redo()
        np.testing.assert_array_equal(self.all_now(), drawn)

    def test_that_fails_on_one_leaves_all(self):
        Faulty = brush_that_fails(after=0.3)
        sys.modules["burin_brushes.brushes"].library().add(Faulty)
        before = self.all_now()
        with self.assertRaisesRegex(RuntimeError, "the pen went too far"):
            self.replay(write_stroke(self.work / "f.stroke", brush=Faulty.id, params={}))
        np.testing.assert_array_equal(self.all_now(), before)
        self.replay()
        self.assertFalse(np.array_equal(self.all_now()[1], before[1]))

    def test_that_share_a_mesh_are_refused(self):
        twin = self.object.copy()
        twin.name = "Twin"
        bpy.context.collection.objects.link(twin)
        twin.select_set(True)
        before = self.all_now()
        with self.assertRaisesRegex(RuntimeError, "Grid and Twin: share a mesh; select one of them"):
            self.replay()
        twin.select_set(False)
        self.second.modifiers.new("Waves", "WAVE")
        with self.assertRaisesRegex(RuntimeError, "Second: modifiers change its shape"):
            self.replay()
        np.testing.assert_array_equal(self.all_now(), before)


class Solids(OfOneMesh):
    def test_are_objects_of_their_own(self):
        self.object.scale = (1, 2, 0.5)
        self.object.data.vertices.foreach_set("co", (self.positions / [1, 2, 0.5]).astype(np.float32).ravel())
        bpy.context.view_layer.update()
        bpy.ops.ed.undo_push(message="Scaled")
        before = self.now()
        chain = write_stroke(self.work / "chain.stroke", brush="org.burin.chain", params={}, radius=0.5, count=20)
        oracle = burin.Session(
            burin.Library(),
            before,
            sum(self.faces, []),
            [len(face) for face in self.faces],
            transform=np.array(self.object.matrix_world),
        )
        oracle.replay(chain, voxel=0.05)
        (expected,) = oracle.solids()
        for names in (["Grid solid"], ["Grid solid", "Grid solid.001"]):
            self.assertEqual(self.replay(chain, settings="voxel=0.05"), {"FINISHED"})
            self.assertEqual(sorted(set(bpy.data.objects.keys()) - {"Grid"}), names)
            solid = bpy.data.objects[names[-1]]
            np.testing.assert_array_equal(positions_of(solid), expected.positions)
            self.assertEqual(len(solid.data.polygons), len(expected.triangles))
            self.assertEqual(solid.matrix_world, bpy.data.objects["Grid"].matrix_world)
            self.assertFalse(solid.select_get())
        np.testing.assert_array_equal(self.now(), before)
        bpy.ops.ed.undo()
        self.assertEqual(sorted(bpy.data.objects.keys()), ["Grid", "Grid solid"])
        bpy.ops.ed.undo()
        self.assertEqual(bpy.data.objects.keys(), ["Grid"])


class BrushesInPython(OfOneMesh):
    def test_have_the_bits_that_they_have_without_blender(self):
        class Steps(burin.Brush):
            id = "org.example.steps"
            inputs = ("t", "d", "radius")
            height = burin.FloatParam(0.1, hard=(0, 1), unit="radius")

            def evaluate(self, batch):
                inside = np.abs(batch.d) < batch.radius / 2
                batch.up = batch[self.height] * batch.radius * (np.floor(8 * batch.t) % 2) * inside

        library = burin.Library(stock=False)
        for each in (library, sys.modules["burin_brushes.brushes"].library()):
            each.add(Steps)
        oracle = burin.Session(library, self.positions, sum(self.faces, []), [len(face) for face in self.faces])
        oracle.replay(self.stroke, brush=Steps.id, params={"height": 0.3})
        self.assertEqual(self.replay(brush=Steps.id, settings="params=height=0.3"), {"FINISHED"})
        np.testing.assert_array_equal(self.now(), oracle.read())
        self.assertGreater((self.now() != self.positions).any(axis=1).sum(), 100)
        sys.modules["burin_brushes.settings"].rebuild()
        bpy.context.scene.burin.brush = Steps.id
        self.assertAlmostEqual(bpy.context.scene.burin.brush_org_example_steps.param_height, 0.1, 6)


class Failures(OfOneMesh):
    def test_leave_the_mesh_as_it_was(self):
        Faulty = brush_that_fails(after=0.7)

        sys.modules["burin_brushes.brushes"].library().add(Faulty)
        both = self.work / "both.stroke"
        both.write_text(
            self.stroke.read_text()
            + "".join(write_stroke(self.work / "f.stroke", brush=Faulty.id, params={}).read_text().splitlines(True)[1:])
        )
        expected, _ = replayed(self.work, self.stroke, self.positions, self.faces)
        with self.assertRaisesRegex(RuntimeError, "the pen went too far"):
            self.replay(both)
        np.testing.assert_array_equal(self.now(), self.positions)
        self.replay()
        np.testing.assert_array_equal(self.now(), expected)

    def test_tell_one_line(self):
        cut = self.work / "cut.stroke"
        cut.write_text(self.stroke.read_text()[:-20])
        for arguments, text in (
            ({"stroke": "missing.stroke"}, "missing.stroke"),
            ({"stroke": cut}, "cut.stroke:.*cut off"),
            ({"brush": "org.example.none"}, "org.example.none"),
            ({"settings": "radius=-1"}, "radius"),
            ({"settings": "radius"}, "must be KEY=VALUE"),
            ({"settings": "no=1"}, "no"),
            ({"settings": "params=none=1"}, "none"),
        ):
            with self.subTest(text):
                with self.assertRaisesRegex(RuntimeError, text) as caught:
                    self.replay(**arguments)
                self.assertEqual(str(caught.exception).strip().count("\n"), 0)
                np.testing.assert_array_equal(self.now(), self.positions)

    def test_of_objects_that_cannot_be_drawn_on_say_why(self):
        self.object.modifiers.new("Waves", "WAVE")
        with self.assertRaisesRegex(RuntimeError, "modifiers change its shape .Waves."):
            self.replay()
        self.object.modifiers["Waves"].show_viewport = False
        self.assertEqual(self.replay(), {"FINISHED"})
        self.object.scale = (1, 0, 1)
        bpy.context.view_layer.update()
        with self.assertRaisesRegex(RuntimeError, "Grid: transform has no inverse: it makes the object flat"):
            self.replay()
        self.object.scale = (1, 1, 1)
        self.object.shape_key_add()
        with self.assertRaisesRegex(RuntimeError, "shape keys"):
            self.replay()
        make_object("Empty", np.zeros((3, 3), np.float32), [])
        with self.assertRaisesRegex(RuntimeError, "no face"):
            self.replay()


class Registration(OfOneMesh):
    def test_can_be_repeated(self):
        self.replay()
        drawn = self.now()
        for _ in range(3):
            addon_utils.disable(ADDON)
            self.assertFalse(hasattr(bpy.types, "BURIN_OT_replay"))
            self.assertEqual([name for name in sys.modules if name.startswith("burin_brushes.")], [])
            handlers = [bpy.app.handlers.undo_post, bpy.app.handlers.depsgraph_update_post, bpy.app.handlers.load_pre]
            self.assertEqual([one for some in handlers for one in some if "burin" in one.__module__], [])
            addon_utils.enable(ADDON)
            self.object.data.vertices.foreach_set("co", self.positions.ravel())
            self.replay()
            np.testing.assert_array_equal(self.now(), drawn)
