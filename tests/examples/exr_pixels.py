"""The pixels of an .exr, by OpenImageIO's oiiotool, which knows nothing of Foveola."""
import re
import subprocess

import numpy


def exr_pixels(path):
    """R, G, B and samples, of shape (height, width, 4), to nine decimals."""
    dump = subprocess.run(["oiiotool", "--dumpdata", str(path)], check=True, capture_output=True,
                          text=True).stdout
    width, height = map(int, re.search(r": +(\d+) x +(\d+), 4 channel", dump).groups())
    values = re.findall(r"^ *Pixel \(\d+, \d+\): (.*)$", dump, re.MULTILINE)
    return numpy.array([line.split() for line in values], numpy.float32).reshape(height, width, 4)
