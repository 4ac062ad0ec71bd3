"""Brushes that are written in Python: the same bits as those of modules, and failures that cost the stroke alone."""

import concurrent.futures
import gc
import threading
import unittest

import numpy as np

import burin
from every_param import EveryParam
from support import TEST_BRUSHES, grid, hex_hash, wave


class RaiseTo(burin.Brush):
    """tests/host/modules/raise_to.cpp in Python."""

    id = "org.example.raise-to"
    inputs = ("position", "normal")

    def evaluate(self, batch):
        batch.up = (np.float32(0.1) - batch.position[:, 2]) / batch.normal[:, 2]


class Everything(EveryParam):
    id = "org.example.everything"
    help = "Declares all there is."
    inputs = burin.INPUTS
    outputs = burin.OUTPUTS
    overlap = "latest"
    features = ("procedural",)
    seen = []

    def begin(self, start):
        assert float(start[self.height]) == np.float32(0.2) and start[self.word] == "Größe"
        assert start[self.tint].shape == (4,)
        return {"radius": start.stroke.radius_max}

    def evaluate(self, batch):
        values = {name: getattr(batch, name) for name in dir(batch) if not name.startswith("_")}
        values |= {param.id: batch[param] for param in self.params()}
        self.seen.append({name: np.array(value) for name, value in values.items() if isinstance(value, (np.ndarray, str))})
        assert batch.state == {"radius": batch.stroke.radius_max}
        batch.up = batch[self.height] * np.interp(np.abs(batch.d) / batch.radius, *batch[self.profile].T)
        batch.mask = 0.5
        batch.colour = batch[self.tint]


def failing(evaluate, brush_id="org.example.failing", **members):
    return type("Failing", (burin.Brush,), {"id": brush_id, "evaluate": evaluate, **members})


def draw(session, brush, radius=0.15, **settings):
    with session.stroke(brush, radius=radius, **settings):
        session.add(wave())


class PythonBrushes(unittest.TestCase):
    def setUp(self):
        self.library = burin.Library(stock=False)
        self.session = burin.Session(self.library, *grid())
        self.before = self.session.hash()

    def failure(self, brush):
        """The error of a stroke with a brush; the surface is as before it and the session goes on."""
        self.library.add(brush)
        with self.assertRaises(burin.Error) as raised:
            draw(self.session, brush.id)
        self.assertEqual(self.session.hash(), self.before)
        self.assertFalse(self.session.info.stroke_open)
        self.library.add(RaiseTo)
        draw(self.session, RaiseTo.id)
        self.assertNotEqual(self.session.hash(), self.before)
        self.session.undo()
        return raised.exception

    def test_have_the_bits_of_modules(self):
        self.library.load(TEST_BRUSHES / "raise_to.burin")
        self.library.add(RaiseTo)
        draw(self.session, "org.burin.test.raise-to")
        expected = hex_hash(self.session)
        self.session.undo()
        draw(self.session, RaiseTo.id)
        self.assertEqual(hex_hash(self.session), expected)

    def test_read_all_inputs_and_write_all_outputs(self):
        Everything.seen.clear()
        self.library.add(Everything)
        draw(self.session, Everything.id, params={"height": 0.2}, fields="pressure", dynamics={"height": ("t", [0, 0, 10, 1])})
        one = max(Everything.seen, key=lambda seen: len(seen["t"]))
        count = len(one["t"])
        vectors = {"position", "normal", "e1", "laplacian", "displacement", "foot", "foot_normal"}
        for name in vectors | {"fine_position", "fine_normal"}:
            self.assertEqual(one[name].shape, (count, 3), name)
        np.testing.assert_allclose(np.linalg.norm(one["e1"], axis=1), 1, atol=1e-5)
        np.testing.assert_allclose(one["normal"], [[0, 0, 1]] * count, atol=1e-5)
        self.assertEqual((one["sheet"].dtype, one["node_id"].dtype), (np.uint32, np.uint32))
        inside = (one["t"] > 0) & (one["t"] < 1)
        np.testing.assert_allclose(one["height"][inside], 0.2 * one["t"][inside] / 1.5, rtol=1e-4)
        self.assertTrue((one["count"] == 3).all() and (one["on"] == 1).all() and (one["form"] == 1).all())
        np.testing.assert_array_equal(one["tint"], [[1, 0.5, 0.25, 1]] * count)
        np.testing.assert_array_equal(one["profile"], [[0, 1], [1, 0]])
        self.assertEqual((str(one["word"]), str(one["file"])), ("Größe", ""))
        painted = self.session.read("colours")
        np.testing.assert_allclose(painted[painted[:, 3] == 1][0], [1, 0.5, 0.25, 1], atol=1e-3)
        self.assertAlmostEqual(float(self.session.read("masks").min()), 0.5, 5)

    def test_know_distances_to_the_stroke_and_its_ends(self):
        seen = []

        def evaluate(self, batch):
            seen.append((batch.position.copy(), batch.distance(), batch.t.copy(), batch.stroke.final))

        self.library.add(failing(evaluate, "org.example.distance", inputs=("position", "t", "d")))
        with self.session.stroke("org.example.distance", radius=0.3):
            self.session.add([[-0.5, 0.1, 0], [0, 0.1, 0], [0.5, 0.1, 0]])
        beyond = 0
        for position, distance, t, final in seen:
            if final:
                x, y, _ = position.astype(np.float64).T
                np.testing.assert_allclose(distance, np.hypot(np.maximum(np.abs(x) - 0.5, 0), y - 0.1), atol=1e-5)
                beyond += (t < 0).sum() + (t > 1).sum()
        self.assertGreater(beyond, 50)

    def test_describe_themselves(self):
        self.library.add(Everything)
        info = self.library[Everything.id]
        self.assertEqual((info.name, info.overlap, info.features), ("Everything", "latest", ("procedural",)))
        self.assertEqual((info.inputs, info.outputs), (tuple(burin.INPUTS), burin.OUTPUTS))
        self.assertEqual([param.type for param in info.params], "float int bool choice colour file curve text".split())
        height = info.param("height")
        self.assertEqual((height.name, height.help, height.unit, height.dynamic), ("Height", "How high.", "radius", True))
        self.assertEqual((height.hard, height.soft), ((0, 1), (0, 0.5)))
        defaults = [param.default for param in info.params[1:]]
        self.assertEqual(defaults, [3, True, "flat", (1, 0.5, 0.25, 1), "", ((0, 1), (1, 0)), "Größe"])
        with self.assertRaises(KeyError):
            info.param("width")

    def test_that_raise_cost_their_stroke_alone(self):
        error = self.failure(failing(lambda self, batch: 1 // 0))
        self.assertIn("org.example.failing: ZeroDivisionError: integer division or modulo by zero", str(error))
        self.assertIsInstance(error.__cause__, ZeroDivisionError)
        self.assertEqual(error.__cause__.__traceback__.tb_next.tb_frame.f_code.co_filename, __file__)

    def test_that_raise_are_the_causes_of_errors_of_groups(self):
        def other(self, batch):
            raise KeyError("of the other library")

        self.library.add(failing(lambda self, batch: 1 // 0))
        group = burin.Group([self.session, burin.Session(self.library, *grid())])
        error = self.failure_of(group)
        self.assertIsInstance(error.__cause__, ZeroDivisionError)
        self.assertEqual(self.session.hash(), self.before)
        second = burin.Library(stock=False)
        second.add(failing(other))
        error = self.failure_of(burin.Group([burin.Session(second, *grid()), self.session]))
        self.assertIn("KeyError: 'of the other library'", str(error))
        self.assertIsInstance(error.__cause__, KeyError)

    def failure_of(self, group):
        with self.assertRaises(burin.Error) as raised:
            with group.stroke("org.example.failing", radius=0.15):
                group.add(wave())
        return raised.exception

    def test_that_read_what_they_do_not_declare_are_told(self):
        error = self.failure(failing(lambda self, batch: batch.normal))
        self.assertIn("AttributeError: the brush does not declare normal among its inputs", str(error))
        error = self.failure(failing(lambda self, batch: setattr(batch, "mask", 1)))
        self.assertIn("the brush does not declare mask among its outputs", str(error))

    def test_cannot_write_inputs(self):
        def evaluate(self, batch):
            batch.t[:] = 0

        self.assertIn("ValueError: assignment destination is read-only", str(self.failure(failing(evaluate))))

    def test_that_return_nan_are_refused(self):
        def evaluate(self, batch):
            batch.up = np.nan

        self.assertIn("org.example.failing", str(self.failure(failing(evaluate))))

    def test_that_refuse_a_stroke_say_why(self):
        def begin(self, start):
            raise ValueError(f"radius {start.stroke.radius_max:g} is too small")

        error = self.failure(failing(lambda self, batch: None, begin=begin))
        self.assertIn("ValueError: radius 0.15 is too small", str(error))
        self.assertIsInstance(error.__cause__, ValueError)

        def make(self):
            raise OSError("no licence")

        self.assertIn("cannot be created: OSError: no licence", str(self.failure(failing(None, __init__=make))))

    def test_may_have_several_passes(self):
        passes = set()

        def begin(self, start):
            start.passes = 3

        def evaluate(self, batch):
            passes.add(batch.stroke.pass_number)
            batch.up = batch.displacement[:, 2] + 0.01

        members = {"begin": begin, "inputs": ("displacement",)}
        self.library.add(failing(evaluate, "org.example.passes", **members))
        draw(self.session, "org.example.passes")
        self.assertEqual(passes, {0, 1, 2})
        self.assertAlmostEqual(float(self.session.read()[:, 2].max()), 0.03, 5)

    def test_are_replaced_by_those_of_the_same_name(self):
        for height in (0.1, 0.2):

            def evaluate(self, batch, height=height):
                batch.up = height

            self.library.add(failing(evaluate))
            draw(self.session, "org.example.failing")
            self.assertAlmostEqual(float(self.session.read()[:, 2].max()), height, 5)
            self.session.undo()
        self.assertEqual(len(self.library), 1)
        with self.assertRaisesRegex(burin.Error, "brush org.example.failing is already there, from "):
            self.library.add(failing(evaluate), name="another")

    def test_that_break_the_rules_are_refused(self):
        for brush, text in (
            (failing(None, inputs=("tt",)), "inputs: there is no 'tt', but t, d, radius"),
            (failing(None, outputs=("up",)), "outputs: there is no 'up', but displacement, mask, colour"),
            (failing(None, overlap="most"), "overlap: there is no 'most', but strongest"),
            (failing(None, a=burin.FloatParam(2, hard=(0, 1))), "parameter 'a'"),
            (failing(None, a=burin.FloatParam(1, hard=(0, 1), unit="metre")), "unit: there is no 'metre', but none"),
        ):
            with self.assertRaisesRegex(burin.Error, text):
                self.library.add(brush)
        self.assertEqual(len(self.library), 0)
        with self.assertRaisesRegex(burin.InvalidArgument, "the default 'c' is none of the choices a, b"):
            burin.ChoiceParam(("a", "b"), "c")

    def test_are_evaluated_on_several_threads_without_deadlock(self):
        """The calling thread must not hold the interpreter's lock while the library's threads want it."""
        threads, batches = set(), []

        def evaluate(self, batch):
            threads.add(threading.get_ident())
            batches.append(batch.size)
            batch.up = 0.01 * np.cos(np.sqrt(np.abs(np.sin(batch.t))))

        self.library.add(failing(evaluate))
        session = burin.Session(self.library, *grid(500))
        draw(session, "org.example.failing", radius=0.5)
        self.assertGreater(sum(batches), 50000)
        self.assertLessEqual(max(batches), 1024)
        self.assertGreaterEqual(len(threads), 1)

    def test_are_let_go_with_their_sessions_and_libraries(self):
        from burin import _application_brushes as kept

        before = (len(kept._instances), len(kept._factories))
        for _ in range(3):
            library = burin.Library(stock=False)
            library.add(RaiseTo)
            session = burin.Session(library, *grid(20))
            draw(session, RaiseTo.id)
            self.assertGreater(len(kept._instances), before[0])
            del library, session
        gc.collect()
        self.assertEqual((len(kept._instances), len(kept._factories)), before)

    def test_of_several_sessions_draw_at_once(self):
        self.library.add(RaiseTo)
        sessions = [burin.Session(self.library, *grid(150)) for _ in range(3)]
        for session in sessions:  # the first stroke with a brush belongs on the main thread
            session.begin(RaiseTo.id, radius=0.15)
            session.cancel()
        threads = [threading.Thread(target=lambda one=one: draw(one, RaiseTo.id, radius=0.4)) for one in sessions]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join(60)
            self.assertFalse(thread.is_alive())
        draw(self.session, RaiseTo.id)
        self.assertEqual(len({session.hash() for session in sessions}), 1)

    def test_belong_to_sessions_that_outlive_their_library(self):
        self.library.add(RaiseTo)
        del self.library
        draw(self.session, RaiseTo.id)
        self.assertNotEqual(self.session.hash(), self.before)


class Libraries(unittest.TestCase):
    def test_run_on_threads_that_are_lent(self):
        expected = burin.Session(burin.Library(), *grid(200))
        draw(expected, "org.burin.rope", radius=0.3)
        used, calls = set(), []

        def run(task, count):
            def noted(number):
                used.add(threading.get_ident())
                task(number)

            calls.append(count)
            list(pool.map(noted, range(count)))

        with concurrent.futures.ThreadPoolExecutor(3) as pool:
            session = burin.Session(burin.Library(run=run, threads=3), *grid(200))
            draw(session, "org.burin.rope", radius=0.3)
        self.assertEqual(hex_hash(session), hex_hash(expected))
        self.assertGreater(len(calls), 20)
        self.assertGreater(len(used), 1)
        self.assertNotIn(threading.get_ident(), used)

    def test_tell_what_lent_threads_raise(self):
        fails = False

        def run(task, count):
            for number in reversed(range(count)):
                task(number)
                task(number)  # of which the library hears once
                if fails:
                    raise OSError("no threads left")

        session = burin.Session(burin.Library(run=run), *grid(200))
        before, fails = session.hash(), True
        with self.assertRaisesRegex(burin.Error, "the application has not run all tasks") as raised:
            draw(session, "org.burin.rope", radius=0.3)
        self.assertIsInstance(raised.exception.__cause__, OSError)
        fails = False
        self.assertEqual(session.hash(), before)
        draw(session, "org.burin.rope", radius=0.3)
        self.assertNotEqual(session.hash(), before)

    def test_pass_lines_on_to_logging(self):
        lines = []
        library = burin.Library(stock=False, log=lambda level, line: lines.append((level, line)))
        library.load(TEST_BRUSHES)
        with self.assertRaisesRegex(burin.Error, "/no/such.burin"):
            library.load("/no/such.burin")
        broken = TEST_BRUSHES.parent / "test-plugins"
        library.load(broken)
        self.assertEqual([line for level, line in lines if level == 30][: len(library.refused)], list(library.refused))
        self.assertGreater(len(library.refused), 0)
        with self.assertLogs("burin", "WARNING"):
            burin.Library(broken)

    def test_tell_what_there_is(self):
        library = burin.Library()
        self.assertIn("org.burin.groove", library)
        self.assertEqual(library["org.burin.groove"].param("depth").unit, "radius")
        with self.assertRaisesRegex(burin.NotFound, "no brush 'org.burin.grove'; there are: org.burin.arrow"):
            library["org.burin.grove"]


if __name__ == "__main__":
    unittest.main()
