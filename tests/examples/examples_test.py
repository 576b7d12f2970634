#!/usr/bin/env python3
"""Tests of the examples: python3 examples_test.py PROGRAM BUILT, with the module on PYTHONPATH.

PROGRAM is `foveola`; BUILT holds the examples' programs, each in a folder of its example's name.
"""
import array
import fcntl
import json
import math
import re
import subprocess
import sys
import tempfile
import termios
import time
import unittest
from pathlib import Path

import numpy

from exr_pixels import exr_pixels

program = sys.argv.pop(1)
built = Path(sys.argv.pop(1))
here = Path(__file__).resolve().parent
room = here.parent / "package" / "lamp.obj"
steps = here.parents[1] / "examples" / "python" / "first_steps.py"


def run(*arguments, **options):
    return subprocess.run([str(argument) for argument in arguments], check=True,
                          capture_output=True, text=True, **options)


def wait_until_read(process):
    """Waits until it has taken all of its standard input: it first loads a scene."""
    unread = array.array("i", [1])
    while unread[0] > 0 and process.poll() is None:
        time.sleep(0.01)
        fcntl.ioctl(process.stdin, termios.FIONREAD, unread)


def eccentricities_deg(pixels, azimuth_deg, elevation_deg):
    """How far each pixel's middle is from a direction."""
    height, width = pixels.shape[:2]
    azimuth = (numpy.arange(width) + 0.5) / width * 360 - 180
    elevation = 90 - (numpy.arange(height) + 0.5) / height * 180
    azimuth, elevation = numpy.meshgrid(numpy.radians(azimuth - azimuth_deg),
                                        numpy.radians(elevation))
    there = math.radians(elevation_deg)
    cosine = (numpy.sin(elevation) * math.sin(there) +
              numpy.cos(elevation) * math.cos(there) * numpy.cos(azimuth))
    return numpy.degrees(numpy.arccos(numpy.clip(cosine, -1, 1)))


class Examples(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def head_deg(self):
        report = run(program, "render", room, "-o", self.folder / "any.exr", "--method", "od",
                     "--size", "32x16", "--samples", 1, "--json").stdout
        return json.loads(report)["head_deg"]

    def test_the_ring_has_all_samples_and_has_them_evenly(self):
        run(built / "sampler" / "ring", room, self.folder / "ring.exr")
        samples = exr_pixels(self.folder / "ring.exr")[..., 3]
        self.assertEqual(samples.sum(), 1_000_000)
        eccentricity = eccentricities_deg(samples[..., None], *self.head_deg())
        pixel_deg = 360 / samples.shape[1]
        self.assertEqual(samples[eccentricity < 5 - pixel_deg].sum(), 0)
        self.assertEqual(samples[eccentricity > 15 + pixel_deg].sum(), 0)
        # Of steradians between 5 and 10 and between 5 and 15 degrees; 6 standard deviations.
        share = ((math.cos(math.radians(5)) - math.cos(math.radians(10))) /
                 (math.cos(math.radians(5)) - math.cos(math.radians(15))))
        inner = samples[eccentricity < 10].sum() / samples.sum()
        self.assertAlmostEqual(inner, share, delta=0.02)

    def test_fv_follows_the_lines(self):
        image = self.folder / "followed.exr"
        eye = subprocess.Popen([str(built / "tracker" / "spoken_gaze"), str(room), str(image)],
                               stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        for line in ("40 10", "blink", "40 10"):
            eye.stdin.write(line + "\n")
            eye.stdin.flush()
            wait_until_read(eye)
            time.sleep(1.0)
        said, _ = eye.communicate()
        self.assertEqual(eye.returncode, 0)
        tracked, lost = map(int, re.search(r"in (\d+) frames and lost in (\d+)", said).groups())
        self.assertGreater(tracked, 1)
        self.assertGreater(lost, 1)

    def test_the_sign_test_counts_participants(self):
        study = self.folder / "study.sqlite"
        run(program, "study", "simulate", "demo", "--db", study, "--participants", 6, "--seed", 3,
            "--predicted", "--inject", "faster:fv:20")
        said = run(built / "analysis" / "sign_test", study).stdout
        self.assertIn("participants: 6, simulated", said)
        # All six are sooner with an effect of 20 times: P = 2 / 2^6.
        self.assertRegex(said, r"outline, fv against od: 6 sooner, 0 later, P = 0\.031")

    def test_first_steps_in_python(self):
        study = self.folder / "study.sqlite"
        run(program, "study", "simulate", "demo", "--db", study, "--participants", 2, "--seed", 3,
            "--predicted")
        said = run(sys.executable, steps, room, study).stdout
        around = {method: float(count) for method, count in re.findall(
            r"(od|fv): ([0-9.]+) samples a pixel around the gaze", said)}
        self.assertGreater(around["fv"], 20 * around["od"])
        self.assertIn("participants: simulated", said)
        self.assertRegex(said, r"(?m)^fv\b")

    def test_a_wrong_call_is_one_line_and_no_success(self):
        for example in ("sampler/ring", "tracker/spoken_gaze", "analysis/sign_test"):
            with self.subTest(example):
                ended = subprocess.run([str(built / example), *(["nowhere"] * 2)][:3 if "sign"
                                       not in example else 2], capture_output=True, text=True,
                                       stdin=subprocess.DEVNULL)
                self.assertEqual(ended.returncode, 1)
                self.assertEqual(ended.stderr.count("\n"), 1)
                self.assertIn("nowhere", ended.stderr)


if __name__ == "__main__":
    unittest.main()
