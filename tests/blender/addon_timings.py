"""Times how long an edit takes until the file is renamed, in a Blender with a window.

Run by Blender:  blender --factory-startup --python addon_timings.py
Prints a row of a table for each number of triangles: medians of the time from the edit to the rename,
and of what of it the export takes; the rest is waiting until the edit has come to rest, and drawing.
"""

import math
import os
import pathlib
import statistics
import sys
import tempfile
import time

import bpy

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))
import addon
import addon_scene
import addon_window
import scenes

EDITS = 7


def add_grid(triangles):
    """A square grid of about so many triangles, in waves, so that no normals are equal."""
    side = round(math.sqrt(triangles / 2))
    corners = [(x / side, y / side, 0.05 * math.sin(x) * math.sin(y))
               for y in range(side + 1) for x in range(side + 1)]
    faces = [(i, i + 1, i + side + 2, i + side + 1)
             for y in range(side) for i in range(y * (side + 1), y * (side + 1) + side)]
    return scenes.add_mesh("grid", corners, faces, scenes.paint("grey"))


def steps(folder):
    for triangles in (10_000, 100_000, 500_000):
        addon_scene.make_known()
        session = addon.enable().session
        grid = add_grid(triangles)
        addon.write_stand_in(folder)
        with addon_window.view():
            bpy.ops.foveola.preview()
        yield 2.0
        totals, exports = [], []
        for _ in range(EDITS):
            count, start = session.export_count, time.time()
            grid.location.x += 0.1
            yield lambda count=count: session.export_count > count
            totals.append(os.stat(session.folder / "scene.glb").st_ctime - start)
            exports.append(session.export_s)
            yield 0.5
        print(f"| {triangles} | {statistics.median(totals):.2f} s | "
              f"{statistics.median(exports):.2f} s |", flush=True)
        addon.disable()


def main():
    folder = pathlib.Path(tempfile.mkdtemp())
    driver = addon_window.Driver(steps(folder))
    bpy.app.timers.register(driver, first_interval=0.5, persistent=True)


if __name__ == "__main__":
    main()
