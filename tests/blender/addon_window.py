"""Tests the add-on in a Blender with a window, where Blender itself calls its timer.

Run by Blender:  blender --factory-startup --python addon_window.py -- FOLDER
Each step is a function that waits with `yield`: seconds, or a function that says when to go on.
"""

import pathlib
import sys
import time
import traceback

import bmesh
import bpy

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))
import addon
import addon_scene

QUIET_S = 1.0  # several times what an export waits for


def require(condition, what):
    if not condition:
        raise AssertionError(what)


class Probe:
    """The add-on under test, and how often it exported."""

    def __init__(self):
        self.module = addon.enable()
        self.count = 0

    @property
    def session(self):
        return self.module.session

    def exported(self):
        """Waits for one more export, and that none follows."""
        self.count += 1
        yield lambda: self.session.export_count >= self.count or self.session.failure
        yield from self.quiet()

    def quiet(self):
        yield QUIET_S
        require(not self.session.failure, self.session.failure)
        require(self.session.export_count == self.count,
                f"{self.session.export_count} exports instead of {self.count}")


def window():
    return bpy.context.window_manager.windows[0]


def view():
    """What operators need that act on the 3D view."""
    area = next(area for area in window().screen.areas if area.type == "VIEW_3D")
    region = next(region for region in area.regions if region.type == "WINDOW")
    return bpy.context.temp_override(window=window(), area=area, region=region)


def move_cube(by):
    """That of the scene in the window: copies have other names."""
    cube = next(thing for thing in window().scene.objects if thing.name.startswith("cube"))
    cube.location.x += by


def test_moving(probe):
    move_cube(1.0)
    yield from probe.exported()
    debounce_s, probe.module.DEBOUNCE_S = probe.module.DEBOUNCE_S, 3.0
    for _ in range(6):  # as a hand moves it: one export at the end, on a busy machine too
        move_cube(0.1)
        yield 0.05
    yield from probe.exported()
    probe.module.DEBOUNCE_S = debounce_s
    with view():
        bpy.ops.object.select_all(action="TOGGLE")
    yield from probe.quiet()


def test_toggle(probe):
    bpy.context.window_manager.foveola_is_live = False
    move_cube(1.0)
    yield from probe.quiet()
    with view():
        require(bpy.ops.foveola.update() == {"FINISHED"}, "no update")
    yield from probe.exported()
    bpy.context.window_manager.foveola_is_live = True


def test_copying(probe):
    bpy.data.lights["panel"].spread = 1.0
    bpy.context.scene.camera.data.dof.use_dof = True
    move_cube(0.1)  # what does not come across makes no new file
    yield from probe.exported()
    bpy.ops.foveola.copy_report()
    lines = bpy.context.window_manager.clipboard.splitlines()
    require(len(lines) == 2 and lines == probe.session.missing, lines)


def test_undo(probe):
    with view():
        bpy.ops.ed.undo_push(message="before")
        move_cube(1.0)
        bpy.ops.ed.undo_push(message="after")
    yield from probe.exported()
    with view():
        bpy.ops.ed.undo()
    yield from probe.exported()


def test_edit_mode(probe):
    """In Edit Mode a mesh's data are old, and the user is not thrown out of it."""
    cube = bpy.data.objects["cube"]
    with view():
        bpy.context.view_layer.objects.active = cube
        bpy.ops.object.mode_set(mode="EDIT")
        mesh = bmesh.from_edit_mesh(cube.data)
        for vertex in mesh.verts:
            vertex.co.z += 0.5
        bmesh.update_edit_mesh(cube.data)
    yield lambda: "Edit Mesh" in probe.session.waits_for
    yield from probe.quiet()
    require(cube.mode == "EDIT", "the user was thrown out of Edit Mode")
    with view():
        bpy.ops.object.mode_set(mode="OBJECT")
    yield from probe.exported()


def test_rendering(probe):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.time_limit = 1 << 24, 8.0
    scene.cycles.use_denoising = scene.cycles.use_adaptive_sampling = False
    bpy.context.preferences.view.render_display_type = "NONE"
    yield from probe.quiet()
    bpy.ops.render.render("INVOKE_DEFAULT")
    yield lambda: bpy.app.is_job_running("RENDER")
    move_cube(0.5)
    yield from probe.quiet()
    require(bpy.app.is_job_running("RENDER"), "the rendering ended before the test did")
    yield lambda: not bpy.app.is_job_running("RENDER")
    yield from probe.exported()


def test_animation(probe):
    cube = bpy.data.objects["cube"]
    cube.keyframe_insert("location", index=1, frame=1)
    cube.location.y = 3.0
    cube.keyframe_insert("location", index=1, frame=20)
    yield from probe.exported()
    with view():
        bpy.ops.screen.animation_play()
    yield from probe.quiet()
    with view():
        bpy.ops.screen.animation_cancel(restore_frame=False)
        bpy.context.scene.frame_set(7)
    yield from probe.exported()


def test_scenes_and_files(probe, folder):
    with view():
        bpy.ops.scene.new(type="FULL_COPY")
    yield from probe.exported()
    bpy.ops.wm.save_as_mainfile(filepath=str(folder / "saved.blend"))
    move_cube(1.0)
    yield from probe.exported()
    bpy.ops.wm.open_mainfile(filepath=str(folder / "saved.blend"))
    yield from probe.exported()


def steps(folder):
    addon_scene.make_known()
    probe = Probe()
    arguments = addon.write_stand_in(folder)
    with view():
        bpy.ops.foveola.preview()
    yield from probe.exported()
    require(arguments.exists(), "the preview was not started")
    yield from test_moving(probe)
    yield from test_toggle(probe)
    yield from test_copying(probe)
    yield from test_undo(probe)
    yield from test_edit_mode(probe)
    yield from test_animation(probe)
    yield from test_rendering(probe)
    yield from test_scenes_and_files(probe, folder)
    place = probe.session.folder
    addon.disable()
    require(not place.exists(), "the folder stays")
    require(addon.handlers_of(addon.NAME) == [], "a handler stays")
    yield QUIET_S


class Driver:
    """Runs the steps in Blender's own loop."""

    LONGEST_S = 60.0

    def __init__(self, generator):
        self.generator = generator
        self.condition = None
        self.since = 0.0

    def __call__(self):
        try:
            return self.step()
        except StopIteration:
            print("the add-on works in a window", flush=True)
        except Exception:
            traceback.print_exc()
        sys.stdout.flush()
        bpy.ops.wm.quit_blender()
        return None

    def step(self):
        if self.condition is not None and not self.condition():
            require(time.monotonic() - self.since < self.LONGEST_S, "nothing happens for a minute")
            return 0.02
        wait = next(self.generator)
        self.condition = wait if callable(wait) else None
        self.since = time.monotonic()
        return 0.02 if callable(wait) else wait


def main():
    folder = pathlib.Path(sys.argv[sys.argv.index("--") + 1])
    bpy.app.timers.register(Driver(steps(folder)), first_interval=0.5, persistent=True)


if __name__ == "__main__":
    main()
