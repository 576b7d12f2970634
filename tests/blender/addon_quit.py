"""Leaves a Blender whose preview runs, as a user does: without disabling the add-on first.

Run by Blender, headless:  blender -b --factory-startup --python addon_quit.py -- FOLDER
Whoever runs this looks whether anything stays in the folder for temporary files.
"""

import pathlib
import sys

import bpy

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))
import addon
import addon_scene

addon_scene.make_known()
module = addon.enable()
addon.write_stand_in(pathlib.Path(sys.argv[sys.argv.index("--") + 1]))
bpy.ops.foveola.preview()
if not (module.session.folder / "scene.glb").exists():
    sys.exit("nothing was exported")
