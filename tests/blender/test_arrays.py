"""Meshes of Blender as arrays, and back."""

import unittest

import addon_utils
import bpy
import numpy as np

from support import ADDON, hilly_grid, make_object, positions_of

addon_utils.enable(ADDON)
from burin_brushes import mesh_io, mesh_parts  # noqa: E402


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


class Parts(unittest.TestCase):
    """Of a strip of 100 triangles: triangle i has the vertices i, i + 1 and i + 2."""

    def setUp(self):
        self.triangles = (np.arange(100)[:, None] + np.arange(3)).astype(np.uint32)
        self.mesh = mesh_parts.MeshParts(self.triangles, vertex_count=200, most=30)

    def test_have_all_triangles_once(self):
        self.assertEqual([len(part.triangles) for part in self.mesh.parts], [30, 30, 30, 10])
        again = np.concatenate([part.vertices[part.triangles] for part in self.mesh.parts])
        np.testing.assert_array_equal(again, self.triangles)
        self.assertEqual(self.mesh.parts[1].vertices.tolist(), list(range(30, 62)))

    def test_are_touched_where_they_have_a_vertex_that_changed(self):
        for ranges, touched in (
            ([(5, 6)], [0]),
            ([(30, 31)], [0, 1]),
            ([(31, 32)], [0, 1]),
            ([(32, 33)], [1]),
            ([(0, 1), (91, 95)], [0, 2, 3]),
            ([(0, 102)], [0, 1, 2, 3]),
            ([(102, 200)], []),
            ([], []),
        ):
            self.assertEqual(self.mesh.touched(ranges).tolist(), touched, ranges)

    def test_may_have_scattered_vertices(self):
        shuffled = np.random.default_rng(3).permutation(200).astype(np.uint32)
        mesh = mesh_parts.MeshParts(shuffled[self.triangles], vertex_count=200, most=30)
        again = np.concatenate([part.vertices[part.triangles] for part in mesh.parts])
        np.testing.assert_array_equal(again, shuffled[self.triangles])
        self.assertEqual(mesh.touched([(shuffled[31], shuffled[31] + 1)]).tolist(), [0, 1])


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
        self.assertEqual(mesh_io.changed_ranges(before, after, within=(7, 31)), [(7, 31)])
        self.assertEqual(mesh_io.changed_ranges(before, before, within=(7, 31)), [])
