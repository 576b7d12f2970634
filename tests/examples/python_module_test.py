#!/usr/bin/env python3
"""Tests of the Python module: python3 module_test.py PROGRAM, with the module on PYTHONPATH.

PROGRAM is `foveola`, which makes the study that is read and the image that is compared with.
"""
import csv
import math
import os
import signal
import sqlite3
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import warnings
from pathlib import Path

import numpy
import pandas

import foveola
from exr_pixels import exr_pixels

program = sys.argv.pop(1)
room = Path(__file__).resolve().parents[1] / "package" / "lamp.obj"


def run(*arguments):
    subprocess.run([program, *map(str, arguments)], check=True, capture_output=True, text=True)


class Scenes(unittest.TestCase):
    def test_a_file_that_is_not_there_is_an_error_of_one_line(self):
        with self.assertRaises(foveola.Error) as raised:
            foveola.load_scene("nowhere.glb")
        self.assertIn("nowhere.glb", str(raised.exception))
        self.assertNotIn("\n", str(raised.exception))

    def test_an_error_names_a_file_whose_name_is_no_utf8(self):
        with self.assertRaisesRegex(foveola.Error, r"none\\xfb\.obj"):
            foveola.load_scene(b"/tmp/none\xfb.obj".decode(errors="surrogateescape"))

    def test_a_scene_is_named_by_a_text_or_a_path(self):
        self.assertEqual(foveola.load_scene(room).triangles,
                         foveola.load_scene(str(room)).triangles)
        with self.assertRaises(TypeError):
            foveola.load_scene(3)
        for function in (foveola.load_scene, foveola.read_study):
            with self.assertRaises(foveola.UsageError):
                function(str(room) + "\0")

    def test_camera_and_head_are_where_they_are_put(self):
        scene = foveola.load_scene(str(room), camera_m=(0.5, 1.0, 0.25), head_deg=(30.0, -10.0))
        numpy.testing.assert_allclose(scene.camera_m, (0.5, 1.0, 0.25), atol=1e-6)
        numpy.testing.assert_allclose(scene.head_deg, (30.0, -10.0), atol=1e-9)
        self.assertGreater(scene.triangles, 0)

    def test_what_loading_warns_of_is_a_warning_of_python(self):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            foveola.load_scene(str(room))
        self.assertTrue(any("camera" in str(warning.message) for warning in caught))


class Renders(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scene = foveola.load_scene(str(room), camera_m=(0.0, 1.0, 0.0), head_deg=(0.0, 0.0))

    def test_shapes_and_types(self):
        image = foveola.render(self.scene, "fv", size=(64, 32), samples=5000)
        self.assertEqual(image.radiance.shape, (32, 64, 3))
        self.assertEqual(image.radiance.dtype, numpy.float32)
        self.assertEqual(image.samples.shape, (32, 64))
        self.assertEqual(int(image.samples.sum()), 5000)
        self.assertEqual(image.dropped, [])

    def test_the_same_seed_is_the_same_image(self):
        images = [foveola.render(self.scene, "od", size=(64, 32), samples_per_pixel=4, seed=seed)
                  for seed in (7, 7, 8)]
        numpy.testing.assert_array_equal(images[0].radiance, images[1].radiance)
        self.assertFalse(numpy.array_equal(images[0].radiance, images[2].radiance))

    def test_the_image_is_what_the_program_renders(self):
        with tempfile.TemporaryDirectory() as folder:
            film = Path(folder) / "image.exr"
            run("render", room, "-o", film, "--method", "vp", "--camera", "0,1,0", "--head", "0,0",
                "--size", "64x32", "--samples", 3000, "--seed", 5)
            image = foveola.render(self.scene, "vp", size=(64, 32), samples=3000, seed=5)
            written = exr_pixels(film)
        numpy.testing.assert_allclose(image.radiance, written[..., :3], rtol=1e-7, atol=1e-9)
        numpy.testing.assert_array_equal(image.samples, written[..., 3])

    def test_fv_gives_most_samples_to_the_gaze(self):
        image = foveola.render(self.scene, "fv", gaze_deg=(90.0, 0.0), size=(360, 180),
                               samples=50_000)
        row, column = numpy.unravel_index(image.samples.argmax(), image.samples.shape)
        self.assertLess(abs(column - 270), 6)
        self.assertLess(abs(row - 90), 6)

    def test_a_picture_needs_no_method(self):
        image = foveola.render(self.scene, size=(48, 27), samples_per_pixel=2)
        self.assertEqual(image.radiance.shape, (27, 48, 3))

    def test_settings_without_sense_are_usage_errors(self):
        for settings in ({"samples": 10, "seconds": 1.0}, {"samples_per_pixel": 0.0},
                         {"max_depth": 0}, {"gaze_deg": (0.0, 0.0)},
                         {"samples_per_pixel": math.inf}, {"seconds": math.inf}, {"size": (0, 1)},
                         {"method": "fv", "gaze_deg": (math.nan, 0.0)},
                         {"method": "fv", "gaze_deg": (0.0, 1e300)}, {"method": "fv\0"}):
            with self.subTest(settings), self.assertRaises(foveola.UsageError):
                foveola.render(self.scene, **settings)
        for settings in ({"camera_m": (0.0, math.nan, 0.0)}, {"camera_m": (1e30, 0.0, 0.0)},
                         {"head_deg": (math.inf, 0.0)}, {"threads": -1}):
            with self.subTest(settings), self.assertRaises(foveola.UsageError):
                foveola.load_scene(room, **settings)
        with self.assertRaises(foveola.Error):
            foveola.render(self.scene, "no-such-method")

    def test_two_threads_render_before_anything_else_needs_numpy(self):
        script = f"""
import threading, warnings, foveola
warnings.simplefilter("ignore")
scene = foveola.load_scene({str(room)!r})
threads = [threading.Thread(target=foveola.render, args=(scene, "od"), kwargs=dict(
    size=(32, 16), samples=1000)) for _ in range(8)]
[thread.start() for thread in threads]
[thread.join() for thread in threads]
"""
        subprocess.run([sys.executable, "-c", script], check=True, timeout=600)

    def test_a_process_renders_if_it_was_forked_before_loading_and_is_refused_otherwise(self):
        """Forked while others render, a child's render waited for threads that stayed behind."""
        script = f"""
import os, threading, warnings, foveola
warnings.simplefilter("ignore")
scene = None

def render():
    return foveola.render(scene or foveola.load_scene({str(room)!r}), "od", size=(64, 32), samples=4000)

def render_until_stopped():
    while not stopped.is_set():
        render()

def refused(function):
    try:
        function()
    except foveola.Error as error:
        return "forked" in str(error)

def code_of_child(function):
    child = os.fork()
    if child == 0:
        raise SystemExit(0 if function() else 1)  # with all that Python does at its end
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])

assert code_of_child(render) == 0
scene = foveola.load_scene({str(room)!r}, threads=4)
stopped = threading.Event()
thread = threading.Thread(target=render_until_stopped)
thread.start()
codes = [code_of_child(lambda: refused(render) and refused(lambda: foveola.load_scene({str(room)!r})))
         for _ in range(8)]
stopped.set()
thread.join()
assert codes == [0] * 8, codes
render()
"""
        subprocess.run([sys.executable, "-c", script], check=True, timeout=600)

    def test_an_interrupt_stops_it_soon(self):
        # It would be ignored where a shell has started this in the background.
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        self.addCleanup(signal.signal, signal.SIGINT, before)
        interrupt = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
        began = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            interrupt.start()
            foveola.render(self.scene, "od", seconds=600.0)
        self.assertLess(time.monotonic() - began, 60.0)


class Studies(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        folder = Path(cls.folder.name)
        cls.study = folder / "study.sqlite"
        run("study", "simulate", "demo", "--db", cls.study, "--participants", 2, "--seed", 3,
            "--predicted")
        run("analyze", cls.study, "-o", folder / "analysis")
        cls.analysis = folder / "analysis"
        cls.frames = foveola.read_study(cls.study)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_every_value_is_that_of_the_exported_files(self):
        for frame, file in (("trials", "trials_long"), ("answers", "answers_long"),
                            ("trials_timed_again", "trials_timed_again"),
                            ("participants", "participants_wide")):
            with self.subTest(frame), open(self.analysis / f"{file}.csv", newline="") as table:
                rows = list(csv.reader(table))
                data = self.frames[frame]
                self.assertEqual(list(data.columns), rows[0])
                self.assertEqual(len(data), len(rows) - 1)
                for number, row in enumerate(rows[1:]):
                    for name, text in zip(rows[0], row):
                        if file == "answers_long" and text.startswith("'"):
                            text = text[1:]  # guarded, as the codebook says
                        self.assert_same(data[name].iloc[number], text, f"{name}, row {number}")

    def assert_same(self, value, text, where):
        if text == "":
            self.assertTrue(pandas.isna(value) or value == "", where)
        elif isinstance(value, (bool, numpy.bool_)):
            self.assertEqual(str(bool(value)).upper(), text, where)
        elif isinstance(value, str):
            self.assertEqual(value, text, where)
        else:
            self.assertEqual(float(value), float(text), where)

    def test_simulated_data_say_that_they_are_simulated(self):
        for frame in self.frames.values():
            self.assertEqual(frame.attrs["participant_kind"], "simulated")
        self.assertTrue((self.frames["trials"]["participant_kind"] == "simulated").all())

    def test_columns_have_units_and_meanings(self):
        attributes = self.frames["trials"].attrs
        self.assertEqual(set(attributes["units"]), set(self.frames["trials"].columns))
        self.assertIn("s", attributes["units"].values())
        self.assertNotIn("", attributes["meanings"].values())

    def test_a_changed_file_is_refused_unless_it_is_asked_for(self):
        changed = Path(self.folder.name) / "changed.sqlite"
        changed.write_bytes(self.study.read_bytes())
        connection = sqlite3.connect(changed)
        guards = connection.execute(
            "SELECT name, sql FROM sqlite_master WHERE type = 'trigger' AND tbl_name = 'event'"
        ).fetchall()
        self.assertNotEqual(guards, [])
        for name, _ in guards:
            connection.execute(f"DROP TRIGGER {name}")
        connection.execute(
            "UPDATE event SET payload = json_object('time_ns', payload ->> 'time_ns' + 1)"
            " WHERE type = 'marked'"
        )
        for _, sql in guards:
            connection.execute(sql)
        connection.commit()
        connection.close()
        with self.assertRaisesRegex(foveola.Error, "failed its verification"):
            foveola.read_study(changed)
        frames = foveola.read_study(changed, unverified=True)
        self.assertEqual(frames["trials"].attrs["record"], "changed")

    def test_what_is_no_study_is_an_error(self):
        other = Path(self.folder.name) / "other.sqlite"
        other.write_text("no database")
        with self.assertRaisesRegex(foveola.Error, "other.sqlite"):
            foveola.read_study(other)


class Documents(unittest.TestCase):
    def test_the_three_functions_are_documented(self):
        for function in (foveola.load_scene, foveola.render, foveola.read_study):
            self.assertGreater(len(function.__doc__), 300)


if __name__ == "__main__":
    unittest.main()
