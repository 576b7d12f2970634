"""Tests the add-on in a Blender without a window, where its timer is called by hand.

Run by Blender:  blender -b --factory-startup --python addon_headless.py -- FOVEOLA FOLDER
"""

import json
import math
import pathlib
import stat
import subprocess
import sys
import tempfile
import time
import tomllib

import bpy

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))
import addon
import addon_scene
import scenes

EDITS = 40


def require(condition, what):
    if not condition:
        raise AssertionError(what)


def require_near(actual, expected, what, tolerance=1e-4):
    close = all(abs(a - b) <= tolerance for a, b in zip(actual, expected, strict=True))
    require(close, f"{what}: {actual} instead of {expected}")


def wait_for(path):
    end = time.monotonic() + 30.0
    while not path.exists():
        require(time.monotonic() < end, f"{path.name} does not come")
        time.sleep(0.02)


def info_of(foveola, file):
    done = subprocess.run(
        [foveola, "scene", "info", str(file), "--json"], capture_output=True, text=True, check=True
    )
    return json.loads(done.stdout)


def settle(session):
    """Updates Blender's scene and lets the timer run until a change would have been exported."""
    bpy.context.view_layer.update()
    session.tick()
    time.sleep(0.21)
    session.tick()


def test_start(module, folder):
    arguments = addon.write_stand_in(folder)
    bpy.ops.foveola.preview()
    wait_for(arguments)
    session = module.session
    file = session.folder / "scene.glb"
    require(arguments.read_text().splitlines() == ["preview", "--watch", str(file)], arguments.read_text())
    require(session.folder.parent == pathlib.Path(tempfile.gettempdir()), session.folder)
    require(stat.S_IMODE(session.folder.stat().st_mode) == 0o700, "others may enter the folder")
    process = session.process
    bpy.ops.foveola.preview()
    require(session.process is process, "a second preview was started")
    return file


def test_content(foveola, file):
    """What Foveola reads back, and what it reads by the lights' extras and the descriptor."""
    info = info_of(foveola, file)
    require(info["emissive_triangles"] == 2 and info["triangles"] == 14, info)
    kinds = {kind["kind"]: (kind["count"], kind["unit"]) for kind in info["light_kinds"]}
    require(kinds == {"point": (1, "W/sr"), "directional": (1, "W/m^2")}, kinds)
    require("environment" in info["features"], info["features"])
    expected = ("with the settings of scene.toml beside it", "camera roll is used by")
    said = [line for line in info["warnings"] if not any(words in line for words in expected)]
    require(len(info["warnings"]) == 2 and not said, info["warnings"])
    descriptor = tomllib.loads(file.with_suffix(".toml").read_text())
    require_near(descriptor["environment_radiance"], [0.5, 1.0, 2.0], "the world")
    require(descriptor["light_units"] == "radiometric", descriptor)
    ours, theirs = descriptor["camera"], info["cameras"][0]
    require_near(ours["position"], [4.0, 2.0, 5.0], "the camera")
    require_near(ours["position"], theirs["position"], "the camera's position")
    require_near([ours["azimuth_deg"], ours["elevation_deg"]], theirs["head_deg"], "its heading")
    require_near([ours["roll_deg"]], [theirs["roll_deg"]], "its roll")
    require_near([abs(ours["roll_deg"])], [abs(addon_scene.CAMERA_ROLL_DEG)], "its roll")
    for key in ("vertical_fov_deg", "aspect_ratio"):
        require_near([ours[key]], [theirs[key]], key)


def test_lights(module, file):
    document = module.Glb(file.read_bytes()).document
    lights = {light["name"]: light for light in document["extensions"]["KHR_lights_punctual"]["lights"]}
    point, sun = lights["point"], lights["sun"]
    require_near([point["intensity"], *point["color"]], [10.0, 1.0, 0.5, 0.25], "the point")
    require_near([point["extras"]["foveola"]["radius_m"]], [0.25], "its radius")
    require_near([sun["intensity"]], [3.0], "the sun")
    require_near([sun["extras"]["foveola"]["angular_radius_rad"]], [math.radians(1.0)], "its size")
    panel = next(entry for entry in document["materials"] if entry["name"] == "panel")
    strength = panel["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"]
    require_near([strength], [12.0 / (scenes.AREA_LIGHT_SOLID_ANGLE_SR * 1.5)], "the area light's radiance")


def test_hidden_area_light(module, file):
    """An area light that the viewport hides is as little sent as anything else that it hides."""
    panel = bpy.data.objects["panel"]
    for is_hidden in (True, False):
        panel.hide_set(is_hidden)
        settle(module.session)
        names = [entry["name"] for entry in module.Glb(file.read_bytes()).document["materials"]]
        require(("panel" in names) != is_hidden, names)


def test_instanced_collection(module, foveola, file):
    """An area light of a collection that stands in two more places, and what is said of it."""
    collection = bpy.data.collections.new("lamps")
    lamp = bpy.data.lights.new("lamp", "AREA")
    lamp.spread = 1.0
    collection.objects.link(bpy.data.objects.new("lamp", lamp))
    places = [scenes.link(name, None, (x, 0.0, 6.0)) for name, x in (("left", -1.0), ("right", 1.0))]
    for place in places:
        place.instance_type, place.instance_collection = "COLLECTION", collection
    settle(module.session)
    require(info_of(foveola, file)["emissive_triangles"] == 6, "area lights of a collection")
    require(module.session.missing == ["lamp: its spread is not sent: it emits to its whole front"],
            module.session.missing)
    for place in places:
        bpy.data.objects.remove(place)
    settle(module.session)
    require(module.session.missing == [], module.session.missing)


def test_edits(session, file):
    """Each is exported once and after it has come to rest; nothing else is, and nothing stays."""
    cube = bpy.data.objects["cube"]
    first = session.export_count
    for edit in range(EDITS):
        count, before = session.export_count, file.stat().st_ino
        cube.location.x = 0.05 * (edit + 1)
        bpy.context.view_layer.update()
        session.tick()
        require(session.export_count == count, "exported before the change came to rest")
        settle(session)
        require(session.export_count == count + 1, f"edit {edit}: {session.failure}")
        require(file.stat().st_ino != before, "the file was written in place")
    for _ in range(3):
        cube.select_set(not cube.select_get())
        settle(session)
    require(session.export_count == first + EDITS, "exported without a change")
    names = sorted(path.name for path in file.parent.iterdir())
    require(names == ["preview.log", "scene.glb", "scene.toml"], names)


def test_what_counts_as_a_change(session):
    """Changes of which no object, material or world tells."""
    scene, cube = bpy.context.scene, bpy.data.objects["cube"]
    group = bpy.data.collections.new("group")
    scene.collection.children.link(group)
    group.objects.link(cube)
    scene.collection.objects.unlink(cube)
    settle(session)
    changes = {
        "disabled collection": lambda: setattr(group, "hide_render", True),
        "enabled collection": lambda: setattr(group, "hide_render", False),
        "hidden": lambda: cube.hide_set(True),
        "shown": lambda: cube.hide_set(False),
        "resolution": lambda: setattr(scene.render, "resolution_x", 300),
        "frame": lambda: (cube.keyframe_insert("location", frame=1), setattr(cube.location, "y", 2.0),
                          cube.keyframe_insert("location", frame=9), scene.frame_set(9)),
        "world": lambda: scenes.set_world((0.1, 0.2, 0.3)),
        "sun": lambda: setattr(bpy.data.lights["sun"], "angle", 0.1),
        "deleted": lambda: bpy.data.objects.remove(cube),
    }
    for name, change in changes.items():
        count = session.export_count
        change()
        settle(session)
        require(session.export_count == count + 1, f"{name}: not exported {session.failure}")


def test_failure(module, file):
    """The old file stays, and the panel says why."""
    session, scene = module.session, bpy.context.scene
    camera, before = scene.camera, file.read_bytes()
    scene.camera = None
    settle(session)
    require("no active camera" in session.failure, session.failure)
    require(session.failure in addon.panel_words(module), addon.panel_words(module))
    require(file.read_bytes() == before, "the old file is gone")
    scene.camera = camera
    settle(session)
    require(not session.failure, session.failure)


def test_missing(module):
    session = module.session
    require(session.missing == [], session.missing)
    expected = addon_scene.add_unsent()
    settle(session)
    for start in expected:
        require(any(line.startswith(start) for line in session.missing),
                f"'{start}' is not in {session.missing}")
    words = addon.panel_words(module)
    require(words[-1] == f"and {len(session.missing) - 10} more", words)
    require(module.shown_lines(["a"] * 10) == ["a"] * 10, "ten lines are shown")


def test_world_image(module, foveola, file, folder):
    """A new image gets a new name, and no more than two are kept."""
    session = module.session
    for strength in (1.0, 2.0, 3.0):
        scenes.sky_of_blender(folder, strength)
        bpy.context.scene.world.node_tree.nodes["Background"].inputs["Strength"].default_value = strength
        image = next(node for node in bpy.context.scene.world.node_tree.nodes
                     if node.type == "TEX_ENVIRONMENT").image
        image.filepath = str(folder / f"sky{strength}.hdr")
        (folder / "sky.hdr").rename(folder / f"sky{strength}.hdr")
        settle(session)
        require(not session.failure, session.failure)
    kept = list(file.parent.glob("environment-*"))
    require(len(kept) == 2, kept)
    descriptor = tomllib.loads(file.with_suffix(".toml").read_text())
    require((file.parent / descriptor["environment_file"]) in kept, descriptor)
    require_near([descriptor["environment_rotation_deg"]], [90.0], "the image's turn")
    info_of(foveola, file)
    image.source, image.filepath = "FILE", str(folder / "gone.hdr")
    settle(session)
    require(any("gone.hdr cannot be read" in line for line in session.missing), session.missing)
    descriptor = tomllib.loads(file.with_suffix(".toml").read_text())
    require(descriptor["environment_radiance"] == [0.0, 0.0, 0.0], descriptor)


def test_other_scenes(session, folder):
    """Another scene in the window, and another file."""
    count = session.export_count
    other = bpy.data.scenes.new("other")
    window = bpy.context.window_manager.windows[0]
    eye = bpy.data.objects.new("eye", bpy.data.cameras.new("eye"))
    other.collection.objects.link(eye)
    other.camera = eye
    window.scene = other
    other.view_layers[0].update()
    settle(session)
    title = (session.folder / "scene.toml").read_text().splitlines()[0]
    require(title == 'title = "other"', title)
    bpy.ops.wm.save_as_mainfile(filepath=str(folder / "saved.blend"))
    bpy.ops.object.camera_add()
    settle(session)
    require(session.export_count > count + 1, session.failure)
    count = session.export_count
    bpy.ops.wm.open_mainfile(filepath=str(folder / "saved.blend"))
    settle(session)
    require(session.export_count == count + 1, f"not exported after loading: {session.failure}")


def test_bad_end(module, folder):
    session = module.session
    session.stop()
    program = folder / "fails"
    program.write_text("#!/bin/sh\necho 'something' >&2\necho 'foveola: error: no display' >&2\nexit 1\n")
    program.chmod(0o700)
    session.start(str(program))
    session.process.wait()
    require(session.tick() is None, "the timer goes on without a preview")
    require(session.failure == "foveola: error: no display", session.failure)
    bpy.context.preferences.addons[addon.NAME].preferences.program = "/nowhere/foveola"
    try:
        bpy.ops.foveola.preview()
    except RuntimeError as failure:
        require("/nowhere/foveola is not a program here" in str(failure), failure)
    else:
        require(False, "a program that is not there was started")


def test_end(module):
    """Nothing of the add-on stays, and it comes and goes again."""
    folder, timer = module.session.folder, module.session._timer
    process = module.session.process
    addon.disable()
    require(not folder.exists(), "the folder stays")
    require(process is None or process.poll() is not None, "the preview stays")
    require(not bpy.app.timers.is_registered(timer), "the timer stays")
    require(addon.handlers_of(addon.NAME) == [], addon.handlers_of(addon.NAME))
    require(not hasattr(bpy.types, "FOVEOLA_PT_preview"), "the panel stays")
    require(not hasattr(bpy.types.WindowManager, "foveola_is_live"), "the property stays")
    for _ in range(2):
        require(len(addon.handlers_of(addon.enable().__name__)) == 5, "handlers")
        addon.disable()


def main():
    foveola, folder = sys.argv[sys.argv.index("--") + 1 :]
    folder = pathlib.Path(folder)
    addon_scene.make_known()
    module = addon.enable()
    file = test_start(module, folder)
    test_content(foveola, file)
    test_lights(module, file)
    test_hidden_area_light(module, file)
    test_instanced_collection(module, foveola, file)
    test_edits(module.session, file)
    test_missing(module)
    test_what_counts_as_a_change(module.session)
    test_failure(module, file)
    test_world_image(module, foveola, file, folder)
    test_other_scenes(module.session, folder)
    addon.write_stand_in(folder)
    test_bad_end(module, folder)
    test_end(module)
    print("the add-on works without a window")


main()
