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

    def test_leave_hidden_faces_out(self):
        mesh = make_object("Grid", *hilly_grid(20)).data
        whole = mesh_io.read_faces(mesh)
        mesh.polygons[0].hide = mesh.polygons[30].hide = True
        read = mesh_io.read_faces(mesh)
        starts = np.cumsum(whole.sizes) - whole.sizes
        left = [whole.corners[s : s + n].tolist() for f, (s, n) in enumerate(zip(starts, whole.sizes)) if f not in (0, 30)]
        self.assertEqual(read.corners.tolist(), sum(left, []))
        self.assertEqual(len(read.sizes), len(whole.sizes) - 2)

    def test_written_are_what_blender_evaluates(self):
        made = make_object("Grid", *hilly_grid(20))
        moved = positions_of(made) + np.float32(0.5)
        mesh_io.write_positions(made.data, moved)
        evaluated = made.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
        np.testing.assert_array_equal(mesh_io.read_positions(evaluated), moved)


class Changes(unittest.TestCase):
    def test_are_found_from_the_first_to_the_last(self):
        before, _ = hilly_grid(20)
        self.assertIsNone(mesh_io.changed_range(before, before.copy()))
        for changed, expected in (([0], (0, 1)), ([7, 30], (7, 31)), ([399], (399, 400))):
            for axis in range(3):
                after = before.copy()
                after[changed, axis] += 1
                self.assertEqual(mesh_io.changed_range(before, after), expected)


class Placements(unittest.TestCase):
    def test_of_nothing_keep_the_bits(self):
        positions, _ = hilly_grid(20)
        self.assertIs(mesh_io.Placement(np.eye(4)).to_world(positions), positions)

    def test_move_there_and_back(self):
        seed = 7
        matrix = np.eye(4)
        matrix[:3] = np.random.default_rng(seed).normal(size=(3, 4))
        positions, _ = hilly_grid(20)
        placement = mesh_io.Placement(matrix)
        world = placement.to_world(positions)
        expected = positions.astype(float) @ matrix[:3, :3].T + matrix[:3, 3]
        np.testing.assert_allclose(world, expected, atol=1e-6, err_msg=f"seed {seed}")
        np.testing.assert_allclose(placement.to_local(world), positions, atol=2e-5, err_msg=f"seed {seed}")

    def test_that_mirror_turn_faces_around(self):
        faces = mesh_io.Faces(np.array([0, 1, 2, 1, 3, 4, 2], np.uint32), np.array([3, 4], np.uint32))
        turned = mesh_io.Placement(np.diag([1, -1, 1, 1])).outward(faces)
        self.assertEqual(turned.corners.tolist(), [2, 4, 3, 1, 2, 1, 0])
        self.assertEqual(turned.sizes.tolist(), [4, 3])
        self.assertIs(mesh_io.Placement(np.diag([1, -1, -1, 1])).outward(faces), faces)

    def test_that_are_flat_are_refused(self):
        with self.assertRaisesRegex(ValueError, "scaled to nothing"):
            mesh_io.Placement(np.diag([1, 0, 1, 1]))
