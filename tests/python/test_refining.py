"""Strokes that split triangles: the bits of the command, arrays that follow by patches, undo, and files."""

import unittest
from pathlib import Path

import numpy as np

import burin
from support import LIBRARY, folder, grid, hex_hash, replayed, wave

CUBE = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], float)
CUBE_FACES = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
STROKE = {"radius": 0.15, "params": {"depth": 0.3}}


def coarse(library=LIBRARY):
    return burin.Session(library, *grid(6, corners=3), refines=True)


def draw(session, **settings):
    with session.stroke("org.burin.groove", **STROKE, refine="auto", **settings):
        for position in wave():
            session.add(position)


class Follower:
    """Arrays of an application's that follow a session by what it tells."""

    def __init__(self, session):
        self.session = session
        self.triangles, self.positions = session.triangles, session.values()

    def follow(self):
        patch = self.session.take_patch()
        self.triangles = patch.triangles(self.triangles)
        kept = self.positions[: patch.kept_vertices]
        self.positions = np.concatenate([kept, np.full((patch.vertex_count - len(kept), 3), 77, np.float32)])
        ranges = self.session.update()
        shown = self.session.values()
        for begin, end in ranges:
            self.positions[begin:end] = shown[begin:end]
        return len(patch.removed) + len(patch.added)


class Refining(unittest.TestCase):
    def setUp(self):
        self.session = coarse()
        self.arrays = Follower(self.session)

    def expect_followed(self):
        np.testing.assert_array_equal(self.arrays.positions, self.session.read())
        np.testing.assert_array_equal(self.arrays.triangles, self.session.triangles)

    def test_tells_patches_that_arrays_follow(self):
        before = (self.arrays.triangles, self.arrays.positions, self.session.hash())
        self.assertEqual(self.session.info.generation, 0)
        with self.session.stroke("org.burin.groove", **STROKE, refine="auto"):
            news = 0
            for position in wave():
                self.session.add(position)
                news += self.arrays.follow() > 0
                self.expect_followed()
        self.assertGreater(news, 1)
        self.assertGreater(self.session.info.generation, 1)
        self.assertGreater(len(self.arrays.triangles), 1000)
        self.session.undo()
        self.assertEqual(len(self.session.triangles), len(before[0]), "of what is shown, although no patch was taken")
        self.assertGreater(self.arrays.follow(), 1000)
        self.expect_followed()
        self.assertEqual(sorted(self.arrays.triangles.tolist()), sorted(before[0].tolist()))
        np.testing.assert_array_equal(self.arrays.positions, before[1])
        self.assertEqual(self.session.hash(), before[2])
        self.session.redo()
        self.arrays.follow()
        self.expect_followed()
        self.assertEqual(self.arrays.follow(), 0)
        self.assertEqual(burin.Session(LIBRARY, *grid(6)).info.generation, 0)

    def test_is_done_at_once_where_the_path_is_known(self):
        self.session.begin("org.burin.groove", **STROKE, refine="auto", path=wave())
        begun = self.session.info.generation
        self.assertEqual(begun, 1)
        for position in wave():
            self.session.add(position)
        self.session.end()
        self.assertEqual(self.session.info.generation, begun)
        group = burin.Group([coarse()])
        with group.stroke("org.burin.groove", **STROKE, refine="auto", path=burin.samples(wave())):
            group.add(wave())
        self.assertEqual(hex_hash(group.sessions[0]), hex_hash(self.session))

    def test_has_the_bits_of_the_command_from_a_recording(self):
        with folder() as where:
            burin.write_mesh(Path(where, "coarse.obj"), *grid(6, corners=3))
            with burin.Recorder(Path(where, "one.stroke")) as recorder:
                recorder.begin(brush="org.burin.groove", **STROKE)
                recorder.add(wave())
                recorder.end()
            expected = replayed(["one.stroke", "--mesh", "coarse.obj"], where)
            mesh = burin.read_mesh(Path(where, "coarse.obj"))
            sessions = [burin.Session.of_mesh(LIBRARY, mesh, refines=True) for _ in range(2)]
            sessions[0].replay(Path(where, "one.stroke"), refine="auto")
            sessions[1].draw(burin.read_recording(Path(where, "one.stroke")).strokes[0], refine="auto")
            self.assertEqual([hex_hash(session) for session in sessions], [expected] * 2)

    def test_is_saved_as_it_is_shown(self):
        with folder() as where:
            draw(self.session)
            self.session.save(Path(where, "drawn.ply"))
            self.session.undo()
            self.session.save(Path(where, "undone.ply"))
            drawn, undone = (burin.read_mesh(Path(where, name)) for name in ("drawn.ply", "undone.ply"))
        self.assertGreater(len(drawn.triangles), 1000)
        self.assertEqual((len(undone.triangles), len(undone.positions)), (50, 36))

    def test_leaves_arrays_that_were_given_before_as_they_are(self):
        shown = self.session.values()
        copy = shown.copy()
        draw(self.session)
        self.session.update()
        np.testing.assert_array_equal(shown, copy)
        self.assertGreater(len(self.session.values()), len(shown))

    def test_is_refused_where_it_was_not_asked_for(self):
        session = burin.Session(LIBRARY, *grid(6))
        with self.assertRaisesRegex(burin.InvalidArgument, "refine: must be off"):
            draw(session)
        with self.assertRaisesRegex(burin.InvalidArgument, "that nothing refines"):
            session.take_patch()
        with self.assertRaisesRegex(burin.InvalidArgument, "refines wants the caller's order"):
            burin.Session(LIBRARY, *grid(6), refines=True, order="surface")
        draw(self.session)
        with self.assertRaisesRegex(burin.Error, "made triangles or parts, so that its step stays with the session"):
            self.session.take_step()
        self.assertEqual(self.session.info.undo_count, 1)


class Solids(unittest.TestCase):
    CHAIN = {"brush": "org.burin.chain", "radius": 0.2}

    def drawn(self, session, **settings):
        with session.stroke(**{**self.CHAIN, **settings}):
            session.add(wave()[10:20])
        return session

    def test_beside_the_surface_are_meshes(self):
        session = self.drawn(burin.Session(LIBRARY, *grid()))
        self.assertEqual(session.info.solid_count, 1)
        (chain,) = session.solids()
        edges = np.sort(np.concatenate([chain.triangles[:, pair] for pair in ([0, 1], [1, 2], [2, 0])]), axis=1)
        self.assertTrue((np.unique(edges, axis=0, return_counts=True)[1] == 2).all(), "closed")
        self.assertGreater(len(chain.triangles), 1000)
        session.undo()
        self.assertEqual(session.solids(), [])

    def test_that_are_merged_are_patches_with_the_bits_of_the_command(self):
        ball = burin.refine_mesh(CUBE, CUBE_FACES, levels=4)
        with folder() as where:
            burin.write_mesh(Path(where, "ball.obj"), ball.positions, ball.triangles)
            with burin.Recorder(Path(where, "tube.stroke")) as recorder:
                recorder.begin(brush="org.burin.tube", radius=0.2, params={"height": 0.0})
                angles = np.linspace(-0.4, 0.4, 30)
                recorder.add(np.stack([np.cos(angles), np.sin(angles), 0 * angles], axis=-1) * float(ball.positions.max()))
                recorder.end()
            options = ["--solid", "union", "--voxel", "0.03", "--refine", "off"]
            expected = replayed(["tube.stroke", "--mesh", "ball.obj", *options], where)
            session = burin.Session.of_mesh(LIBRARY, burin.read_mesh(Path(where, "ball.obj")), refines=True)
            arrays = Follower(session)
            session.replay(Path(where, "tube.stroke"), solid="union", voxel=0.03)
        self.assertEqual(hex_hash(session), expected)
        self.assertGreater(arrays.follow(), 100)
        np.testing.assert_array_equal(arrays.positions, session.read())
        np.testing.assert_array_equal(arrays.triangles, session.triangles)

    def test_bent_along_a_stroke_are_meshes(self):
        with folder() as where:
            burin.write_mesh(Path(where, "box.obj"), CUBE, CUBE_FACES)
            session = burin.Session(LIBRARY, *grid())
            with session.stroke(radius=0.1, along_mesh=Path(where, "box.obj")):
                session.add(wave())
        (boxes,) = session.bent_meshes()
        self.assertGreater(len(boxes.triangles), 30)


class Paint(unittest.TestCase):
    class Red(burin.Brush):
        id = "org.example.red"
        inputs = ("t",)
        outputs = ("colour",)

        def evaluate(self, batch):
            batch.colour[:] = (0.75, 0.125, 0.25, 1)

    def test_covers_by_strength_and_mask_without_getting_pale(self):
        library = burin.Library(stock=False)
        library.add(self.Red)
        session = burin.Session(library, *grid())
        session.write("masks", np.full(3600, 0.5))
        with session.stroke(self.Red.id, radius=0.15, strength=0.5):
            session.add(wave())
        colours = session.read("colours")
        painted = colours[:, 3] > 0
        self.assertGreater(painted.sum(), 100)
        np.testing.assert_allclose(colours[painted], np.broadcast_to([0.75, 0.125, 0.25, 0.25], (painted.sum(), 4)), rtol=1e-6)

    def test_is_gone_with_its_stroke_also_from_files(self):
        library = burin.Library(stock=False)
        library.add(self.Red)
        session = burin.Session(library, *grid())
        with folder() as where:
            for has_colours in (True, False):
                if has_colours:
                    with session.stroke(self.Red.id, radius=0.15):
                        session.add(wave())
                else:
                    session.undo()
                self.assertEqual((session.info.has_colours, session.info.has_masks), (has_colours, False))
                session.save(Path(where, "painted.ply"))
                self.assertEqual(burin.read_mesh(Path(where, "painted.ply")).colours is not None, has_colours)

    def test_of_no_strength_is_not_in_files_of_the_command(self):
        with folder() as where:
            burin.write_mesh(Path(where, "grid.obj"), *grid(60, corners=3))
            with burin.Recorder(Path(where, "one.stroke")) as recorder:
                recorder.begin(brush="org.burin.text", radius=0.15, params={"text": "A", "colour": (1, 0, 0, 1)})
                recorder.add(wave())
                recorder.end()
            for strength in (1, 0):
                options = ["--strength", strength, "--refine", "off", "--save-mesh", "after.ply"]
                replayed(["one.stroke", "--mesh", "grid.obj", *options], where)
                self.assertEqual(burin.read_mesh(Path(where, "after.ply")).colours is not None, strength > 0)
