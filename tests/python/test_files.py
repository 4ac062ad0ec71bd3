"""Recordings, meshes and snapping, compared with what the command makes of the same files."""

import unittest
from pathlib import Path

import numpy as np

import burin
from support import LIBRARY, SAMPLES, STAMPS, folder, grid, hex_hash, replayed, wave

EWER = SAMPLES / "meshes/ewer.obj"
MEANDER = SAMPLES / "strokes/meander.stroke"


def session_of(mesh):
    return burin.Session.of_mesh(LIBRARY, mesh)


class Hashes(unittest.TestCase):
    """The same strokes have the bits that `burin replay` gives them."""

    def test_of_all_stock_brushes(self):
        brushes = [brush for brush in LIBRARY if brush.outputs]
        self.assertGreater(len(brushes), 17)
        session = burin.Session(LIBRARY, *grid(80, 3))
        with folder() as work:
            burin.write_mesh(Path(work, "plane.ply"), *grid(80, 3))
            with burin.Recorder(Path(work, "all.stroke")) as recorder:
                for number, brush in enumerate(brushes):
                    params = {"stamp": SAMPLES / "stamps" / STAMPS[brush.id]} if brush.id in STAMPS else {}
                    settings = {"radius": 0.12, "params": params, "strength": 0.7, "follow": 0.5}
                    pen = burin.samples(
                        wave() * [1, 1 - number / 10, 1] + [0, number / 50, 0],
                        time=np.linspace(0, 1, 40),
                        pressure=np.linspace(0.5, 1, 40),
                        tilt=(0.1, 0.3),
                    )
                    recorder.begin(brush=brush.id, fields="time pressure tilt", **settings)
                    recorder.add(pen)
                    recorder.end()
                    session.begin(brush.id, fields="time pressure tilt", seed=number, **settings)
                    self.assertEqual(session.add(pen).drawn, 40)
                    session.end()
            expected = replayed(["all.stroke", "--mesh", "plane.ply"], work)
            self.assertEqual(hex_hash(session), expected)

            stroke_by_stroke = session_of(burin.read_mesh(Path(work, "plane.ply")))
            for stroke in burin.read_recording(Path(work, "all.stroke")).strokes:
                self.assertGreater(stroke_by_stroke.draw(stroke).drawn, 0)
            self.assertEqual(hex_hash(stroke_by_stroke), expected)

    def test_of_a_refined_cage_and_other_settings(self):
        expected = replayed(
            [MEANDER, "--mesh", EWER, "--subdivide", "3", "--brush", "org.burin.bead", "--radius", "0.1"], SAMPLES.parent
        )
        session = session_of(burin.read_mesh(EWER, levels=3))
        session.replay(MEANDER, brush="org.burin.bead", radius=0.1)
        self.assertEqual(hex_hash(session), expected)


class Errors(unittest.TestCase):
    def test_have_the_texts_of_the_command(self):
        """But for where the command was told: the file and the number of the stroke."""
        session = session_of(burin.read_mesh(EWER))
        with folder() as work:
            broken = Path(work, "broken.stroke")
            broken.write_text('{"burin_stroke": 1, "space": "object"}\n[1, 2\n')
            for call, arguments in (
                (lambda: burin.read_recording(broken), [broken, "--mesh", EWER]),
                (lambda: session.replay(broken), [broken, "--mesh", EWER]),
                (lambda: burin.read_mesh("/no/such.obj"), [MEANDER, "--mesh", "/no/such.obj"]),
                (lambda: session.begin("none", radius=1), [MEANDER, "--mesh", EWER, "--brush", "none"]),
                (
                    lambda: session.begin("org.burin.bead", radius=1, params={"depth": 1}),
                    [MEANDER, "--mesh", EWER, "--brush", "org.burin.bead", "--param", "depth=1"],
                ),
                (
                    lambda: session.begin("org.burin.scales", radius=1),
                    [MEANDER, "--mesh", EWER, "--brush", "org.burin.scales"],
                ),
            ):
                with self.assertRaises(burin.Error) as raised:
                    call()
                with self.assertRaises(AssertionError) as told:
                    replayed(arguments, work)
                line = str(told.exception).rstrip("\n")
                self.assertTrue(line.endswith(f": {raised.exception}"), f"{line}\n{raised.exception}")


class Recordings(unittest.TestCase):
    def test_tell_their_strokes(self):
        with folder() as work:
            path = Path(work, "a.stroke")
            with burin.Recorder(path, device="Tablet") as recorder:
                recorder.begin(
                    brush="org.burin.groove",
                    radius=0.25,
                    params={"depth": 0.5},
                    dynamics={"strength": ("pressure", [0, 0, 1, 1])},
                    fields="pressure barrel",
                    tool="pen",
                    eraser=True,
                )
                recorder.add(wave(), pressure=np.linspace(0, 1, 40), barrel=np.arange(40) % 3 == 0)
                recorder.end()
                recorder.begin(brush="org.burin.text", radius=1, params={"text": "1884"}, closed=True)
                recorder.end()
            recording = burin.read_recording(path)
        first, second = recording.strokes
        self.assertEqual(recording.device, "Tablet")
        self.assertEqual(
            first.settings,
            {
                "brush": "org.burin.groove",
                "radius": 0.25,
                "params": {"depth": "0.5"},
                "dynamics": {"strength": ("pressure", [0, 0, 1, 1])},
            },
        )
        self.assertEqual((first.fields, second.seed), (("pressure", "barrel"), 1))
        np.testing.assert_array_equal(first.samples["position"], wave())
        np.testing.assert_array_equal(first.samples["pressure"], np.linspace(0, 1, 40, dtype=np.float32))
        np.testing.assert_array_equal(first.samples["barrel"], np.arange(40) % 3 == 0)
        self.assertEqual((first.tool, first.eraser, second.tool, second.eraser), ("pen", True, "", False))
        self.assertFalse(first.samples.flags.writeable)
        self.assertEqual(second.settings["params"], {"text": "1884"})

    def test_with_other_settings_are_drawn_as_the_command_does(self):
        stroke = burin.RecordedStroke(
            {"brush": "a", "radius": 1, "params": {"x": "1", "y": "2"}, "dynamics": {"x": ("t", [0]), "radius": ("t", [1])}},
            (),
            0,
            burin.samples([0, 0, 0]),
        )
        same = stroke.settings_with({"params": {"x": 3}, "dynamics": {"radius": ("time", [2])}, "radius": 2, "cap": None})
        self.assertEqual(
            same,
            {"brush": "a", "radius": 2, "params": {"x": 3, "y": "2"}, "dynamics": {"x": ("t", [0]), "radius": ("time", [2])}},
        )
        other = stroke.settings_with({"brush": "b"})
        self.assertEqual(other, {"brush": "b", "radius": 1, "params": {}, "dynamics": {"radius": ("t", [1])}})
        arguments = [MEANDER, "--mesh", EWER, "--subdivide", "1", "--refine", "off", "--brush", "org.burin.bead"]
        session = session_of(burin.read_mesh(EWER, levels=1))
        session.draw(burin.read_recording(MEANDER).strokes[0], brush="org.burin.bead")
        self.assertEqual(hex_hash(session), replayed(arguments, SAMPLES.parent))

    def test_on_a_screen_have_rays(self):
        view = np.eye(4)
        view[2, 3] = -3
        projection = np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, -1.02, -0.2], [0, 0, -1, 0]])
        camera = burin.Camera(view, projection, 800, 600)
        with folder() as work:
            path = Path(work, "a.stroke")
            with burin.Recorder(path, space="screen", camera=camera) as recorder:
                recorder.begin(brush="org.burin.groove", radius=0.1)
                recorder.add([[400, 300, 0], [500, 300, 0]])
                recorder.end()
            samples = burin.read_recording(path).strokes[0].samples
        on_axis, aside = samples["position"]
        np.testing.assert_allclose(on_axis[:2], 0, atol=1e-6)
        self.assertAlmostEqual(aside[0] / (3 - aside[2]), 0.25, 5)  # the eye is 3 above
        np.testing.assert_allclose(samples["direction"][0], [0, 0, -1], atol=1e-6)
        np.testing.assert_allclose(samples["direction"][1], np.array([0.25, 0, -1]) / np.hypot(0.25, 1), atol=1e-6)

    def test_that_are_wrong_name_the_place(self):
        with folder() as work:
            path = Path(work, "a.stroke")
            path.write_text('{"burin_stroke": 1, "space": "object"}\n[1, 2\n')
            with self.assertRaisesRegex(burin.Error, f"^{path}:2: "):
                burin.read_recording(path)
            with self.assertRaisesRegex(burin.Error, "/no/such/folder/a.stroke"):
                burin.Recorder("/no/such/folder/a.stroke")
            with burin.Recorder(path) as recorder:
                with self.assertRaises(burin.InvalidArgument):
                    recorder.begin(radius=-1)

    def test_are_told_of_and_cancelled(self):
        session = session_of(burin.read_mesh(EWER))
        before, told = session.hash(), []
        session.set_progress(lambda stage, done: told.append((stage, done)))
        session.replay(MEANDER)
        self.assertGreater(len(told), 20)
        self.assertEqual(told[-1][1], 1)
        session.undo()

        def stop(stage, done):
            if done > 0.3:
                raise KeyboardInterrupt

        session.set_progress(stop)
        with self.assertRaisesRegex(burin.Error, "cancelled") as raised:
            session.replay(MEANDER)
        self.assertIsInstance(raised.exception.__cause__, KeyboardInterrupt)
        self.assertEqual(session.hash(), before)


class Meshes(unittest.TestCase):
    def test_are_views_of_the_file(self):
        mesh = burin.read_mesh(EWER)
        self.assertIsNotNone(mesh.positions.base)
        self.assertFalse(mesh.positions.flags.writeable or mesh.triangles.flags.writeable)
        self.assertEqual(mesh.origin, (0, 0, 0))
        positions = mesh.positions
        expected = positions.copy()
        del mesh
        np.testing.assert_array_equal(positions, expected)

    def test_have_their_texture_coordinates(self):
        positions, triangles = grid(6, 3)
        uv = np.random.default_rng(1).integers(0, 256, (len(triangles), 3, 2)).astype(np.float32) / 256
        with folder() as work:
            for name in ("a.obj", "a.ply", "a.glb"):
                burin.write_mesh(Path(work, name), positions, triangles, uv=uv)
                mesh = burin.read_mesh(Path(work, name))
                np.testing.assert_array_equal(mesh.positions[mesh.triangles], positions[triangles].astype(np.float32))
                np.testing.assert_array_equal(mesh.uv, uv)
            with self.assertRaises(burin.InvalidArgument):
                burin.write_mesh(Path(work, "b.obj"), positions, triangles, uv=uv[1:])
        self.assertIsNone(burin.read_mesh(EWER).uv)

    def test_are_refined(self):
        coarse, fine = burin.read_mesh(EWER), burin.read_mesh(EWER, target_triangles=5000)
        self.assertGreaterEqual(len(fine.triangles), 5000)
        self.assertLess(len(coarse.triangles), 5000)
        cage = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], np.float64)
        quads = np.array([[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]])
        by_arrays = burin.refine_mesh(cage, quads.ravel(), [4] * 6, levels=3)
        with folder() as work:
            faces = "".join("f %d %d %d %d\n" % tuple(quad + 1) for quad in quads)
            Path(work, "cube.obj").write_text("".join("v %g %g %g\n" % tuple(at) for at in cage) + faces)
            by_file = burin.read_mesh(Path(work, "cube.obj"), levels=3)
        np.testing.assert_array_equal(by_arrays.positions, by_file.positions)
        np.testing.assert_array_equal(by_arrays.triangles, by_file.triangles)
        with self.assertRaisesRegex(burin.Error, "edge"):
            burin.refine_mesh(cage, [[0, 1, 2], [0, 1, 3], [0, 1, 4]], levels=1)
        with self.assertRaisesRegex(burin.InvalidArgument, "levels: must be 0 to 15, not 16"):
            burin.read_mesh(EWER, levels=16)
        with self.assertRaisesRegex(burin.Error, "/no/such.obj"):
            burin.read_mesh("/no/such.obj")

    def test_are_saved_with_what_is_painted(self):
        session = burin.Session(LIBRARY, *grid(50))
        with session.stroke("org.burin.groove", radius=0.2):
            session.add(wave())
        with folder() as work:
            session.save(Path(work, "a.ply"))
            plain = burin.read_mesh(Path(work, "a.ply"))
            np.testing.assert_array_equal(plain.positions, session.read())
            self.assertIsNone(plain.colours)
            self.assertIsNone(plain.masks)
            session.write("colours", [[1, 0, 0, 1]] * 100)
            session.write("masks", np.full(100, 0.5), begin=50)
            session.save(Path(work, "b.ply"))
            painted = burin.read_mesh(Path(work, "b.ply"))
            self.assertTrue(painted.colours.any() and painted.masks.any())
            again = session_of(painted)
            self.assertEqual(hex_hash(again), hex_hash(session))
            by_surface = burin.Session.of_mesh(LIBRARY, painted, order="surface")
            self.assertEqual(hex_hash(by_surface), hex_hash(session))
            self.assertEqual(replayed(["none.stroke", "--mesh", "b.ply"], self.empty(work)), hex_hash(session))
            with self.assertRaisesRegex(burin.Error, "a.doc"):
                session.save(Path(work, "a.doc"))
            with self.assertRaisesRegex(burin.InvalidArgument, r"masks: the shape must be \(4,\), not \(3,\)"):
                burin.write_mesh(Path(work, "c.ply"), np.zeros((4, 3)), [[0, 1, 2]], masks=[1, 1, 1])

    @staticmethod
    def empty(work):
        """A recording whose only stroke misses the surface."""
        with burin.Recorder(Path(work, "none.stroke")) as recorder:
            recorder.begin(brush="org.burin.groove", radius=0.1)
            recorder.add([9, 9, 9])
            recorder.end()
        return work


class Snapping(unittest.TestCase):
    def setUp(self):
        positions, faces = grid(120)
        positions[:, 2] = 0.1 / (1 + 60 * positions[:, 1] ** 2)
        self.session = burin.Session(LIBRARY, positions, faces)
        self.stroke = np.stack([np.linspace(-0.6, 0.5, 12), np.full(12, 0.06), np.full(12, 1.0)], axis=-1)

    def test_moves_strokes_to_ridges_and_crests_of_values(self):
        before = self.session.hash()
        found = self.session.snap("ridge", self.stroke, direction=(0, 0, -1), radius=0.2)
        self.assertGreater(found.share, 0.7)
        self.assertLess(np.abs(found.samples["position"][20:-20, 1]).max(), 0.01)
        self.assertEqual(self.session.hash(), before)
        self.session.begin("org.burin.groove", radius=0.1)
        self.assertGreater(self.session.add(found.samples).drawn, 10)
        self.session.cancel()
        y = self.session.read()[:, 1]
        crest = self.session.snap(
            "high", self.stroke, direction=(0, 0, -1), radius=0.2, values=1 / (1 + 200 * (y - 0.1) ** 2)
        )
        self.assertAlmostEqual(float(crest.samples["position"][len(crest.samples) // 2, 1]), 0.1, 2)

    def test_is_refused_by_name(self):
        with self.assertRaisesRegex(burin.InvalidArgument, "there is no line 'rim', but ridge"):
            self.session.snap("rim", self.stroke, radius=0.2)
        with self.assertRaisesRegex(burin.InvalidArgument, "the line wants a view"):
            self.session.snap("silhouette", self.stroke, radius=0.2)
        with self.assertRaisesRegex(burin.InvalidArgument, r"values: the shape must be \(14400,\), not \(3,\)"):
            self.session.snap("low", self.stroke, radius=0.2, values=[1, 2, 3])


if __name__ == "__main__":
    unittest.main()
