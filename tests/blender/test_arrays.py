"""Meshes of Blender as arrays, and back."""

import unittest

import addon_utils
import bpy
import numpy as np

from support import ADDON, hilly_grid, make_object, positions_of

addon_utils.enable(ADDON)
from burin_brushes import mesh_io  # noqa: E402


class Arrays(unittest.TestCase):
    def test_have_what_the_mesh_has(self):
        positions, faces = hilly_grid(20)
        mesh = make_object("Grid", positions, faces).data
        read = mesh_io.read_faces(mesh)
        np.testing.assert_array_equal(mesh_io.read_positions(mesh), positions)
        self.assertEqual(read.corners.tolist(), sum(faces, []))
        self.assertEqual(read.sizes.tolist(), [len(face) for face in faces])
        self.assertEqual({3, 4}, set(read.sizes.tolist()))

    def test_tell_which_faces_are_hidden(self):
        mesh = make_object("Grid", *hilly_grid(20)).data
        self.assertFalse(mesh_io.read_hidden(mesh).any())
        mesh.polygons[0].hide = mesh.polygons[30].hide = True
        self.assertEqual(np.flatnonzero(mesh_io.read_hidden(mesh)).tolist(), [0, 30])

    def test_written_are_what_blender_evaluates(self):
        made = make_object("Grid", *hilly_grid(20))
        moved = positions_of(made) + np.float32(0.5)
        mesh_io.write_positions(made.data, moved)
        evaluated = made.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
        np.testing.assert_array_equal(mesh_io.read_positions(evaluated), moved)


class Changes(unittest.TestCase):
    def test_are_ranges_that_are_apart(self):
        before, _ = hilly_grid(20)
        self.assertEqual(mesh_io.changed_ranges(before, before.copy()), [])
        for changed, expected in (
            ([0], [(0, 1)]),
            ([7, 30], [(7, 31)]),
            ([399], [(399, 400)]),
            ([0, 65, 130, 131], [(0, 1), (65, 66), (130, 132)]),
        ):
            for axis in range(3):
                after = before.copy()
                after[changed, axis] += 1
                self.assertEqual(mesh_io.changed_ranges(before, after, gap=64), expected)
        after = before + np.float32(1)
        self.assertEqual(mesh_io.changed_ranges(before, after), [(0, 400)])
