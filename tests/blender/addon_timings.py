"""Times how long an edit takes until the preview beside Blender shows it, in a Blender with a window.

Run by Blender:  blender --factory-startup --python addon_timings.py -- FOVEOLA
Prints a row of a table for each number of triangles, with medians: of the time from the edit to the
file's rename; of what of it the export takes, the rest being waiting until the edit has come to rest,
and drawing; and of the time from the rename to the first frame with the new scene.
"""

import json
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
OPENING_S = 8.0
SHOWING_S = 3.0  # longer than a preview takes for a file that it was sent


def add_grid(triangles):
    """A square grid of about so many triangles, in waves, so that no normals are equal."""
    side = round(math.sqrt(triangles / 2))
    corners = [(x / side, y / side, 0.05 * math.sin(x) * math.sin(y))
               for y in range(side + 1) for x in range(side + 1)]
    faces = [(i, i + 1, i + side + 2, i + side + 1)
             for y in range(side) for i in range(y * (side + 1), y * (side + 1) + side)]
    return scenes.add_mesh("grid", corners, faces, scenes.paint("grey"))


def preview_of(folder, foveola):
    """Has the add-on start Foveola so that it writes down, at its end, when it showed changes."""
    program, report = folder / "preview", folder / "preview.json"
    program.write_text(f"#!/bin/sh\nexec '{foveola}' \"$@\" --json > '{report}'\n")
    program.chmod(0o700)
    bpy.context.preferences.addons[addon.NAME].preferences.program = str(program)
    return report


def steps(folder, foveola):
    for triangles in (10_000, 100_000, 500_000):
        addon_scene.make_known()
        session = addon.enable().session
        grid = add_grid(triangles)
        report = preview_of(folder, foveola)
        with addon_window.view():
            bpy.ops.foveola.preview()
        yield OPENING_S
        totals, exports = [], []
        for _ in range(EDITS):
            count, start = session.export_count, time.time()
            grid.location.x += 0.1
            yield lambda count=count: session.export_count > count
            totals.append(os.stat(session.folder / "scene.glb").st_ctime - start)
            exports.append(session.export_s)
            yield SHOWING_S
        addon.disable()
        changes = json.loads(report.read_text())["changes"]
        addon_window.require(len(changes) == EDITS, f"{len(changes)} changes were shown")
        shown = [change["seconds_to_first_frame"] for change in changes]
        print(f"| {triangles} | {statistics.median(totals):.2f} s | "
              f"{statistics.median(exports):.2f} s | {statistics.median(shown):.2f} s |", flush=True)


def main():
    folder = pathlib.Path(tempfile.mkdtemp())
    foveola = sys.argv[sys.argv.index("--") + 1]
    driver = addon_window.Driver(steps(folder, foveola))
    bpy.app.timers.register(driver, first_interval=0.5, persistent=True)


if __name__ == "__main__":
    main()
