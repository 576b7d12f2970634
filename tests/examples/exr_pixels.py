"""The pixels of an .exr, by OpenImageIO's oiiotool, which knows nothing of Foveola."""
import subprocess

import numpy


def exr_pixels(path):
    """R, G, B and samples, of shape (height, width, 4)."""
    dump = subprocess.run(["oiiotool", str(path), "--ch", "R,G,B,samples", "--dumpdata"],
                          check=True, capture_output=True, text=True).stdout
    pixels = {}
    for line in dump.splitlines():
        if line.lstrip().startswith("Pixel"):
            place, values = line.split(":", 1)
            x, y = place[place.index("(") + 1:place.index(")")].split(",")
            pixels[int(y), int(x)] = [float(value) for value in values.split()[-4:]]
    height = 1 + max(y for y, _ in pixels)
    width = 1 + max(x for _, x in pixels)
    return numpy.array([[pixels[y, x] for x in range(width)] for y in range(height)],
                       dtype=numpy.float32)
