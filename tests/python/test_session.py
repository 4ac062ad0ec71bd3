"""Sessions over arrays: what they read without copies, what they show, and what they refuse."""

import os
import pickle
import re
import subprocess
import sys
import threading
import time
import unittest
from pathlib import Path

import numpy as np

import burin
from burin._arrays import MeshArrays
from support import BUILD, LIBRARY, folder, grid, hex_hash, wave

DRAWS_WITH_THE_PROBE = """
import burin
from support import grid, wave
for brush in ("org.burin.probe", "org.burin.probe.solid"):
    session = burin.Session(burin.Library(), *grid())
    with session.stroke(brush=brush, radius=0.15):
        session.add(wave())
    session.undo()
"""

GROOVE = {"brush": "org.burin.groove", "radius": 0.15, "params": {"depth": 0.3}}


def groove(session, positions=None):
    with session.stroke(**GROOVE):
        session.add(wave() if positions is None else positions)
    return session


class Isolation(unittest.TestCase):
    def test_draws_the_same(self):
        library = burin.Library(isolate=True)
        self.assertEqual(
            hex_hash(groove(burin.Session(library, *grid()))), hex_hash(groove(burin.Session(LIBRARY, *grid())))
        )


class Probe(unittest.TestCase):
    def test_finds_nothing_wrong_with_the_library_as_a_host(self):
        with folder() as where:
            report = Path(where) / "probe.txt"
            environment = {
                "BURIN_PLUGIN_PATH": str(BUILD / "bin/probe"),
                "BURIN_PROBE_REPORT": str(report),
                "PYTHONPATH": ":".join(sys.path),
            }
            subprocess.run([sys.executable, "-c", DRAWS_WITH_THE_PROBE], env=os.environ | environment, check=True)
            last = report.read_text().splitlines()[-1]
        kept, broken = map(int, re.fullmatch(r"(\d+) rules kept, (\d+) broken, \d+ unseen", last).groups())
        self.assertGreater(kept, 40)
        self.assertEqual(broken, 0)


class Arrays(unittest.TestCase):
    def test_of_every_type_and_stride_give_the_same_surface(self):
        positions, quads = grid()
        expected = hex_hash(groove(burin.Session(LIBRARY, positions, quads)))
        wide = np.zeros((len(positions), 5))
        wide[:, 1:4] = positions
        loops, sizes = quads.ravel().astype(np.int32), np.full(len(quads), 4, np.int32)
        for name, arrays in {
            "float64": (positions.astype(np.float64), quads),
            "strided": (wide[:, 1:4], quads),
            "signed": (positions, quads.astype(np.int32)),
            "64 bits": (positions, quads.astype(np.int64)),
            "16 bits": (positions, quads.astype(np.uint16)),
            "columns first": (np.asfortranarray(positions), np.asfortranarray(quads)),
            "backwards": (positions[::-1][::-1], quads),
            "other bytes first": (positions.astype(">f4"), quads.astype(">u4")),
            "lists": (positions.tolist(), quads.tolist()),
            "polygons": (positions, loops, sizes),
        }.items():
            with self.subTest(name):
                self.assertEqual(hex_hash(groove(burin.Session(LIBRARY, *arrays))), expected)

    def test_are_read_where_they_are(self):
        positions, quads = grid()
        wide = np.zeros((len(positions), 5))
        for one, faces in ((positions, quads), (wide[:, 1:4], quads.astype(np.int64)), (positions[::2], quads[1::3])):
            arrays = MeshArrays(one, faces, None, "caller")
            self.assertIs(arrays.positions, one)
            self.assertIs(arrays.corners, faces)
            self.assertEqual(arrays.mesh.positions, one.ctypes.data)
            self.assertEqual(arrays.mesh.position_stride, one.strides[0])

    def test_of_polygons_of_several_sizes(self):
        house = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0.5, 1.5, 0], [0, 1, 0], [2, 0, 0], [2, 1, 0]])
        session = burin.Session(LIBRARY, house, [0, 1, 2, 3, 4, 1, 5, 6, 2], [5, 4])
        self.assertEqual(session.info.triangle_count, 5)
        self.assertEqual(session.triangles.max(), 6)

    def test_that_are_wrong_are_refused_by_name(self):
        positions, quads = grid(4)
        for arguments, text in (
            ((positions.ravel(), quads), "positions: the shape must be (n, 3), not (48,)"),
            ((positions[:, :2], quads), "positions: the shape must be (n, 3), not (16, 2)"),
            ((positions, quads.ravel()), "faces: the shape must be (m, corners of a face), not (36,)"),
            ((positions, quads.ravel(), [4]), "face_sizes: their sum is 4, but there are 36 corners"),
            ((positions, quads + 1), "corner 34 of the corners is vertex 16, but there are 16"),
            ((positions, quads.astype(np.int32) - 1), "corner 0 of the corners is vertex 4294967295, but there are 16"),
            ((positions * np.float32(np.nan), quads), "vertex 0 has a coordinate that is not finite"),
        ):
            with self.assertRaises(burin.InvalidArgument) as raised:
                burin.Session(LIBRARY, *arguments)
            self.assertEqual(str(raised.exception), text)
        with self.assertRaisesRegex(burin.InvalidArgument, "order: must be 'caller' or 'surface'"):
            burin.Session(LIBRARY, positions, quads, order="mine")


class Objects(unittest.TestCase):
    def test_with_a_transform_are_drawn_in_the_world(self):
        positions, quads = grid()
        matrix = np.diag([4.0, 0.5, 1, 1])
        object_positions = (positions / matrix.diagonal()[:3]).astype(np.float32)
        session = groove(burin.Session(LIBRARY, object_positions, quads, transform=matrix))
        self.assertEqual(hex_hash(session), hex_hash(groove(burin.Session(LIBRARY, positions, quads))))
        with self.assertRaisesRegex(burin.InvalidArgument, "makes the object flat"):
            burin.Session(LIBRARY, positions, quads, transform=np.diag([1, 0, 1, 1]))
        with self.assertRaisesRegex(burin.InvalidArgument, r"transform: the shape must be \(4, 4\)"):
            burin.Session(LIBRARY, positions, quads, transform=np.eye(3))

    def test_with_hidden_faces_are_without_them(self):
        positions, faces = grid(corners=3)
        hidden = positions[faces[:, 0], 0] > 0.2
        session = burin.Session(LIBRARY, positions, faces, hidden=np.zeros(len(faces)))
        session.hide(hidden)
        expected = groove(burin.Session(LIBRARY, positions, faces[~hidden]))
        self.assertEqual(hex_hash(groove(session)), hex_hash(expected))
        session.undo()
        session.hide(None)
        self.assertEqual(hex_hash(groove(session)), hex_hash(groove(burin.Session(LIBRARY, positions, faces))))
        with self.assertRaisesRegex(burin.InvalidArgument, "hidden: the shape must be"):
            burin.Session(LIBRARY, positions, faces, hidden=[True])


class Groups(unittest.TestCase):
    def test_draw_on_what_the_pen_meets(self):
        positions, quads = grid()
        sessions = [burin.Session(LIBRARY, positions + np.float32([x, 0, 0]), quads) for x in (-1.25, 1.25)]
        before = [session.read() for session in sessions]
        group = burin.Group(sessions)
        path = np.stack([np.linspace(-2, 2, 60), np.zeros(60), np.full(60, 3)], axis=-1)
        with group.stroke(**GROOVE):
            hit = [group.add(position, direction=[0, 0, -1]).session for position in path]
        self.assertEqual([hit[0], hit[-1]], sessions)
        drawn = [session.read() for session in sessions]
        self.assertTrue(all((a != b).any() for a, b in zip(before, drawn)))
        group.undo()
        np.testing.assert_array_equal([session.read() for session in sessions], before)
        group.redo()
        np.testing.assert_array_equal([session.read() for session in sessions], drawn)
        with self.assertRaises(burin.NotFound):
            group.redo()
        for session in sessions:
            session.close()


class Views(unittest.TestCase):
    def setUp(self):
        self.session = burin.Session(LIBRARY, *grid())

    def test_change_with_updates_and_nothing_else_is_reported(self):
        shown = self.session.values()
        before = shown.copy()
        groove(self.session)
        np.testing.assert_array_equal(shown, before)
        ranges = self.session.update(gap=0, most=5000)
        changed = np.zeros(len(shown), bool)
        for begin, end in ranges:
            changed[begin:end] = True
        np.testing.assert_array_equal(changed, (shown != before).any(axis=1))
        self.assertGreater(changed.sum(), 100)
        self.assertEqual(len(self.session.update()), 0)
        few = burin.Session(LIBRARY, *grid())
        few.update()
        groove(few)
        self.assertLessEqual(len(few.update(gap=0, most=3)), 3)

    def test_are_not_copies_and_cannot_be_written(self):
        one, other = self.session.values(), self.session.values()
        self.assertTrue(np.shares_memory(one, other))
        with self.assertRaises(ValueError):
            one[0] = 0

    def test_live_longer_than_their_session(self):
        shown = groove(self.session).values()
        expected = shown.copy()
        self.session.close()
        del self.session
        np.testing.assert_array_equal(shown, expected)

    def test_have_the_shapes_of_their_attributes(self):
        shapes = {name: self.session.values(name).shape for name in burin.ATTRIBUTES}
        self.assertEqual(shapes, {"positions": (3600, 3), "normals": (3600, 3), "colours": (3600, 4), "masks": (3600,)})
        with self.assertRaisesRegex(burin.InvalidArgument, "there is no attribute 'colors', but positions, normals"):
            self.session.update("colors")

    def test_in_the_order_of_the_surface_are_maps_away(self):
        by_surface = burin.Session(LIBRARY, *grid(), order="surface")
        groove(by_surface)
        groove(self.session)
        to_surface = by_surface.map_to_surface()
        np.testing.assert_array_equal(by_surface.read()[to_surface], self.session.read())
        np.testing.assert_array_equal(to_surface[by_surface.map_from_surface()], np.arange(3600))
        self.assertEqual(hex_hash(by_surface), hex_hash(self.session))

    def test_are_read_and_written_with_any_stride(self):
        groove(self.session)
        wide = np.full((20, 6), 7.0)
        self.session.read("positions", 1800, 1820, out=wide[:, 2:5])
        np.testing.assert_array_equal(wide[:, 2:5], self.session.read("positions", 1800, 1820))
        self.assertTrue((wide[:, [0, 1, 5]] == 7).all())
        wide[:, 4] += 0.25
        self.session.write("positions", wide[:, 2:5], begin=1800)
        np.testing.assert_array_equal(self.session.read()[1800:1820], wide[:, 2:5].astype(np.float32))
        self.session.write("masks", np.zeros(5), begin=3)
        self.assertEqual(self.session.read("masks").sum(), 3595)
        shown = self.session.values()
        for out in (shown[:5], wide[4::-1, 2:5], wide[:5, :6:2], np.broadcast_to(np.zeros(3), (5, 3)), np.zeros((5, 3), ">f4")):
            with self.assertRaisesRegex(burin.InvalidArgument, "out: must be float32 or float64, writable"):
                self.session.read("positions", 0, 5, out=out)
        with self.assertRaisesRegex(burin.InvalidArgument, r"out: the shape must be \(5, 3\), not \(4, 3\)"):
            self.session.read("positions", 0, 5, out=np.zeros((4, 3)))
        self.session.write("colours", np.broadcast_to([0.5, 0, 0, 1], (7, 4)))
        self.session.write("colours", self.session.read("colours", 0, 3)[::-1], begin=7)
        self.assertTrue((self.session.read("colours", 0, 10) == [0.5, 0, 0, 1]).all())
        with self.assertRaisesRegex(burin.InvalidArgument, r"values: the shape must be \(2, 3\), not \(2, 4\)"):
            self.session.write("positions", np.zeros((2, 4)))
        with self.assertRaisesRegex(burin.InvalidArgument, "a value is not from 0 to 1"):
            self.session.write("masks", [2.0])
        with self.assertRaisesRegex(burin.InvalidArgument, "the range is not one of vertices"):
            self.session.read("masks", 0, 3601)


class Strokes(unittest.TestCase):
    def setUp(self):
        self.session = burin.Session(LIBRARY, *grid())
        self.before = self.session.hash()

    def test_sample_by_sample_or_at_once_are_the_same(self):
        at_once = hex_hash(groove(self.session))
        self.session.undo()
        self.session.begin(**GROOVE)
        for position in wave():
            event = self.session.add(position)
        self.session.end()
        self.assertEqual((event.drawn, event.on_surface, hex_hash(self.session)), (1, True, at_once))

    def test_have_pens_if_they_report_what_they_do(self):
        pen = burin.samples(wave(), time=np.linspace(0, 1, 40), pressure=np.linspace(0.2, 1, 40), tilt=(0.1, 0.2))
        with_pressure = {"strength": ("pressure", [0, 0, 1, 1])}
        hashes = set()
        for fields in ("", "pressure", ("time", "pressure", "tilt")):
            with self.session.stroke(**GROOVE, fields=fields, dynamics=with_pressure):
                self.session.add(pen)
            hashes.add(self.session.hash())
            self.session.undo()
        self.assertEqual(len(hashes), 2)
        with self.assertRaisesRegex(burin.InvalidArgument, "fields: a pen reports no 'pressur', but time, pressure"):
            self.session.begin(**GROOVE, fields="pressur")

    def test_of_rays_meet_the_surface(self):
        with self.session.stroke(**GROOVE):
            self.session.add(wave() + [0, 0, 5], direction=(0, 0, -1))
        rays = hex_hash(self.session)
        self.session.undo()
        self.assertEqual(hex_hash(groove(self.session)), rays)
        with self.session.stroke(**GROOVE):
            self.assertFalse(self.session.add([9, 9, 9]).on_surface)

    def test_are_undone_and_made_again(self):
        after = groove(self.session).hash()
        self.assertEqual((self.session.info.undo_count, self.session.info.redo_count), (1, 0))
        self.session.undo()
        self.assertEqual(self.session.hash(), self.before)
        self.session.redo()
        self.assertEqual(self.session.hash(), after)
        with self.assertRaisesRegex(burin.NotFound, "there is no stroke to make again"):
            self.session.redo()
        self.session.limit_undo(0)
        self.assertEqual(self.session.info.undo_bytes, 0)

    def test_are_steps_of_an_application(self):
        session = burin.Session(LIBRARY, *grid())
        states, steps = [session.read()], []
        for _ in range(2):
            groove(session)
            states.append(session.read())
            steps.append(pickle.loads(pickle.dumps(session.take_step())))
        self.assertEqual(session.info.undo_count, 0)
        with self.assertRaisesRegex(burin.InvalidArgument, "the surface is not in the state that the step belongs to"):
            session.apply(steps[0])
        for i in (1, 0):
            session.apply(steps[i])
            np.testing.assert_array_equal(session.read(), states[i])
        session.apply(steps[0])
        np.testing.assert_array_equal(session.read(), states[1])
        self.assertGreaterEqual(steps[0].bytes, 16 * steps[0].vertex_count)
        with self.assertRaises(burin.NotFound):
            session.take_step()
        with self.assertRaisesRegex(burin.Error, "a saved step is damaged or cut off"):
            burin.Step.load(steps[0].save()[:-1])

    def test_are_cancelled_by_exceptions(self):
        with self.assertRaises(KeyError):
            with self.session.stroke(**GROOVE):
                self.session.add(wave())
                self.assertNotEqual(self.session.hash(), self.before)
                raise KeyError("of the application")
        self.assertEqual(self.session.hash(), self.before)
        self.assertFalse(self.session.info.stroke_open)

    def test_with_wrong_settings_are_refused_by_name(self):
        for settings, kind, text in (
            ({"colour": 1}, burin.InvalidArgument, "settings: there is no setting 'colour'"),
            ({"strength": "much"}, burin.InvalidArgument, "settings: strength: must be a number, not 'much'"),
            ({"radius": None}, burin.InvalidArgument, "settings lack the radius"),
            ({"cap": "flat"}, burin.InvalidArgument, "settings: cap: must be one of butt, round, not 'flat'"),
            ({"params": {"depht": 1}}, burin.Error, "org.burin.groove has no parameter 'depht'; there are: depth, width"),
            ({"brush": "none"}, burin.NotFound, "no brush 'none'; there are: "),
            ({"join": {"a": 1}}, burin.InvalidArgument, "join: takes no names and values"),
            ({"dynamics": {"strength": "t"}}, burin.InvalidArgument, "dynamics: strength: must be (source, curve)"),
        ):
            with self.assertRaises(kind) as raised:
                self.session.begin(**{**GROOVE, **settings})
            self.assertTrue(str(raised.exception).startswith(text), raised.exception)
            self.assertFalse(self.session.info.stroke_open)
        with self.assertRaisesRegex(burin.InvalidArgument, "no stroke is open"):
            self.session.end()

    def test_take_settings_of_every_form(self):
        self.session.begin(
            "org.burin.groove",
            radius=np.float32(0.1),
            strength=1,
            clamp=True,
            closed="auto",
            mirror="x",
            symmetry_centre=(0, 0, 1),
            dabs=np.int64(2),
            stabilise="string:0.02",
            params={"depth": 0.1, "profile": "v"},
            dynamics={"strength": ("t", np.array([0, 0, 4, 1]))},
            follow=None,
        )
        self.session.add(wave())
        self.session.end()
        self.assertNotEqual(self.session.hash(), self.before)

    def test_may_be_closed(self):
        angle = np.linspace(0, 2 * np.pi, 40)
        circle = 0.5 * np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=-1)
        for closed in (True, "auto", "yes", False):
            with self.session.stroke("org.burin.groove", radius=0.15, closed=closed):
                self.session.add(circle)
            self.assertEqual(self.session.chart().closed, bool(closed))

    def test_have_charts(self):
        with self.session.stroke("org.burin.groove", radius=0.2):
            self.session.add([[-0.5, 0.1, 0], [0, 0.1, 0], [0.5, 0.1, 0]])
        chart = self.session.chart()
        x, y, _ = grid()[0][chart.nodes["vertex"]].astype(np.float64).T
        beside = (x > -0.5) & (x < 0.5)
        self.assertGreater(beside.sum(), 150)
        np.testing.assert_allclose(chart.nodes["t"][beside], x[beside] + 0.5, atol=1e-5)
        np.testing.assert_allclose(chart.nodes["d"][beside], y[beside] - 0.1, atol=1e-5)
        self.assertAlmostEqual(chart.length, 1, 5)
        self.assertFalse(chart.closed)

    def test_leave_the_interpreter_to_other_threads(self):
        """Another thread runs while a call does: the interpreter's lock is not held."""
        session = burin.Session(LIBRARY, *grid(400))
        during, done = [], threading.Event()

        def count():
            while not done.is_set():
                during.append(time.perf_counter())
                time.sleep(0.001)

        thread = threading.Thread(target=count)
        thread.start()
        session.begin(**GROOVE)
        begin = time.perf_counter()
        session.add(wave(400))
        end = time.perf_counter()
        done.set()
        thread.join()
        session.end()
        self.assertGreater(sum(begin < moment < end for moment in during), 3)


class Samples(unittest.TestCase):
    def test_are_the_bytes_of_c(self):
        import ctypes

        from burin import _c

        self.assertEqual(burin.SAMPLE.itemsize, ctypes.sizeof(_c.Sample))
        for name, member in (("pressure", "pressure"), ("position", "position"), ("tilt", "tilt_x"), ("twist", "twist")):
            self.assertEqual(burin.SAMPLE.fields[name][1], getattr(_c.Sample, member).offset)

    def test_of_their_own_type_are_not_copied(self):
        from burin.samples import as_samples

        given = burin.samples(wave())
        self.assertIs(as_samples(given, {}), given)


if __name__ == "__main__":
    unittest.main()
