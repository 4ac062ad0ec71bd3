"""Strokes that paint: colours and sculpt masks of vertices are the bits of a session of the same mesh."""

import sys
import unittest

import bpy
import numpy as np

import burin
from support import activate, brush_that_fails, write_stroke
from test_replay import OfOneMesh


class Inked(burin.Brush):
    """Colours the middle of the stroke and protects it, half where the pen comes near to the rim."""

    id = "org.example.inked"
    inputs = ("t", "d", "radius", "colour", "mask")
    outputs = ("displacement", "colour", "mask")

    def evaluate(self, batch):
        inside = np.clip(2 - 2 * np.abs(batch.d) / batch.radius, 0, 1)
        batch.up = 0.2 * batch.radius * inside
        for channel, ink in enumerate((0.8, 0.1, 0.05, 1)):
            batch.colour[:, channel] = (1 - inside) * batch.colour_before[:, channel] + inside * ink
        batch.mask = batch.mask_before * (1 - 0.75 * inside)


def activate_empty():
    empty = bpy.data.objects.new("Nothing", None)
    bpy.context.collection.objects.link(empty)
    activate(empty)


class Painted(OfOneMesh):
    def setUp(self):
        super().setUp()
        sys.modules["burin_brushes.brushes"].library().add(Inked)
        self.ink = write_stroke(self.work / "ink.stroke", brush=Inked.id, params={})
        self.mesh = self.object.data

    @property
    def mesh_now(self):
        return bpy.data.objects["Grid"].data

    def oracle(self, colours=None):
        library = burin.Library()
        library.add(Inked)
        session = burin.Session(library, self.now(), sum(self.faces, []), [len(face) for face in self.faces])
        session.write("colours", np.ones((len(self.positions), 4), np.float32) if colours is None else colours)
        return session

    def colours(self):
        colours = np.empty(4 * len(self.positions), np.float32)
        self.mesh_now.color_attributes.active_color.data.foreach_get("color", colours)
        return colours.reshape(-1, 4)

    def masked(self):
        masked = np.empty(len(self.positions), np.float32)
        self.mesh_now.vertex_paint_masks[0].data.foreach_get("value", masked)
        return masked

    def expect(self, oracle):
        np.testing.assert_array_equal(self.now(), oracle.read())
        np.testing.assert_array_equal(self.colours(), oracle.read("colours"))
        np.testing.assert_array_equal(self.masked(), 1 - oracle.read("masks"))

    def test_has_the_bits_of_a_session_and_is_undone(self):
        oracle = self.oracle()
        oracle.replay(self.ink)
        self.assertEqual(self.replay(self.ink), {"FINISHED"})
        self.expect(oracle)
        self.assertGreater((self.colours() < 0.5).any(axis=1).sum(), 100)
        self.assertGreater((self.masked() > 0.5).sum(), 100)
        again = write_stroke(self.work / "again.stroke", brush=Inked.id, params={}, shift=0.1)
        one = self.colours()
        oracle.replay(again)
        self.replay(again)
        self.expect(oracle)
        bpy.ops.ed.undo()
        np.testing.assert_array_equal(self.colours(), one)
        self.replay(again)
        self.expect(oracle)
        bpy.ops.ed.undo()
        bpy.ops.ed.undo()
        self.assertIsNone(self.mesh_now.color_attributes.active_color)
        self.replay(self.ink)
        np.testing.assert_array_equal(self.colours(), one)

    def test_goes_over_the_colours_that_are_there(self):
        there = self.mesh.color_attributes.new("Mine", "FLOAT_COLOR", "POINT")
        self.mesh.color_attributes.active_color = there
        before = np.random.default_rng(7).random((len(self.positions), 4), np.float32)
        there.data.foreach_set("color", before.ravel())
        oracle = self.oracle(before)
        oracle.replay(self.ink)
        self.replay(self.ink)
        self.expect(oracle)
        self.assertEqual([each.name for each in self.mesh_now.color_attributes], ["Mine"])
        self.assertGreater((self.colours() == before).all(axis=1).sum(), 1000)

    def test_leaves_bright_colours_beside_the_stroke(self):
        there = self.mesh.color_attributes.new("Bright", "FLOAT_COLOR", "POINT")
        self.mesh.color_attributes.active_color = there
        before = np.full((len(self.positions), 4), 3, np.float32)
        there.data.foreach_set("color", before.ravel())
        oracle = self.oracle()
        oracle.replay(self.ink)
        self.replay(self.ink)
        now, painted = self.colours(), oracle.read("colours")
        beside = (painted == 1).all(axis=1)
        np.testing.assert_array_equal(now[beside], before[beside])
        np.testing.assert_array_equal(now[~beside], painted[~beside])
        self.assertGreater((~beside).sum(), 100)

    def test_that_is_taken_back_leaves_colours_to_the_bit(self):
        for kind in ("FLOAT_COLOR", "BYTE_COLOR"):
            there = self.mesh.color_attributes.new(kind, kind, "POINT")
            self.mesh.color_attributes.active_color = there
            there.data.foreach_set("color", np.linspace(-1, 3, 4 * len(self.positions), dtype=np.float32))
            before = self.colours()
            canvas = sys.modules["burin_brushes.canvas"].Canvas(bpy.context, set(Inked.outputs))
            canvas.pen.begin(brush=Inked.id, radius=0.2)
            canvas.pen.add([[-0.5, 0, 0], [0.5, 0, 0]])
            canvas.show()
            self.assertGreater((self.colours() != before).any(axis=1).sum(), 100)
            canvas.cancel()
            np.testing.assert_array_equal(self.colours(), before)
            np.testing.assert_array_equal(self.now(), self.positions)

    def test_wants_a_mesh(self):
        refused = sys.modules["burin_brushes.object_session"].Refused
        activate_empty()
        with self.assertRaisesRegex(refused, "select a mesh to draw on"):
            sys.modules["burin_brushes.canvas"].Canvas(bpy.context, set(Inked.outputs))

    def test_that_cannot_be_kept_leaves_no_session(self):
        values = sys.modules["burin_brushes.vertex_values"]
        whole = values._write_masks
        values._write_masks = lambda mesh, masks: 1 / 0
        self.addCleanup(setattr, values, "_write_masks", whole)
        canvas = sys.modules["burin_brushes.canvas"].Canvas(bpy.context, set(Inked.outputs))
        canvas.pen.begin(brush=Inked.id, radius=0.2)
        canvas.pen.add([[-0.5, 0, 0], [0.5, 0, 0]])
        canvas.pen.end()
        with self.assertRaises(ZeroDivisionError):
            canvas.keep()
        canvas.cancel()
        self.assertFalse(sys.modules["burin_brushes.object_session"]._sessions)
        np.testing.assert_array_equal(self.now(), self.positions)

    def test_of_bytes_is_what_bytes_hold(self):
        there = self.mesh.color_attributes.new("Bytes", "BYTE_COLOR", "POINT")
        self.mesh.color_attributes.active_color = there
        oracle = self.oracle()
        oracle.replay(self.ink)
        self.replay(self.ink)
        np.testing.assert_allclose(self.colours(), oracle.read("colours"), atol=1 / 100)
        self.replay(self.ink)
        self.assertEqual(self.mesh_now.color_attributes.active_color.data_type, "BYTE_COLOR")

    def test_of_corners_is_refused(self):
        self.mesh.color_attributes.active_color = self.mesh.color_attributes.new("Corners", "BYTE_COLOR", "CORNER")
        with self.assertRaisesRegex(RuntimeError, "Grid: the colour attribute Corners is of face corners; convert it"):
            self.replay(self.ink)
        np.testing.assert_array_equal(self.now(), self.positions)
        self.assertEqual(self.replay(), {"FINISHED"}, "strokes that do not paint are drawn")

    def test_leaves_masks_beside_the_stroke_to_the_bit(self):
        oracle = self.oracle()
        oracle.replay(self.ink)
        self.replay(self.ink)  # which makes the layer of masks
        before = np.random.default_rng(3).random(len(self.positions), np.float32) ** 4
        self.mesh_now.vertex_paint_masks[0].data.foreach_set("value", before)
        oracle.write("masks", 1 - before)
        oracle.replay(self.ink)
        self.replay(self.ink)
        beside = oracle.read("masks") == 1 - before
        np.testing.assert_array_equal(self.masked()[beside], before[beside])
        np.testing.assert_array_equal(self.masked()[~beside], 1 - oracle.read("masks")[~beside])
        self.assertGreater((1 - (1 - before) != before).sum(), 100, "bits that would be lost")

    def test_sculpt_masks_protect(self):
        oracle = self.oracle()
        oracle.replay(self.ink)
        oracle.replay(self.stroke)
        self.replay(self.ink)
        masks = 1 - self.masked()
        free = burin.Session(burin.Library(), self.now(), sum(self.faces, []), [len(face) for face in self.faces])
        free.replay(self.stroke)
        self.replay()
        self.expect(oracle)
        moved = (self.now() != free.read()).any(axis=1)
        self.assertGreater((moved & (masks < 0.5)).sum(), 100)

    def test_of_stock_brushes_leaves_nothing_where_it_fails(self):
        Faulty = brush_that_fails(after=0.7)
        sys.modules["burin_brushes.brushes"].library().add(Faulty)
        both = self.work / "both.stroke"
        arrow = write_stroke(self.work / "arrow.stroke", brush="org.burin.arrow", params={"colour": [0.5, 0, 0, 1]})
        faulty = write_stroke(self.work / "f.stroke", brush=Faulty.id, params={})
        both.write_text(arrow.read_text() + "".join(faulty.read_text().splitlines(True)[1:]))
        with self.assertRaisesRegex(RuntimeError, "the pen went too far"):
            self.replay(both)
        self.assertIsNone(self.mesh_now.color_attributes.active_color)
        self.assertFalse(len(self.mesh_now.vertex_paint_masks))
        np.testing.assert_array_equal(self.now(), self.positions)
        self.assertEqual(self.replay(arrow), {"FINISHED"})
        self.assertGreater((self.colours() != 1).any(axis=1).sum(), 50)


del OfOneMesh  # it has no tests of its own
