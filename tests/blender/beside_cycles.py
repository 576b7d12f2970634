"""Renders a scene with Cycles, and its export with Foveola, and says how far the pictures differ.

Run by Blender, headless:  blender -b --factory-startup --python beside_cycles.py -- FOVEOLA SCENE FOLDER
Writes FOLDER/SCENE.glb, both pictures, and SCENE.png with both beside each other; prints a row of a
table for each export, and fails if a mean differs by more than a hundredth.
"""

import math
import pathlib
import subprocess
import sys

import bpy
import numpy

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))
import by_cycles
import scenes

WIDTH, HEIGHT = 256, 144
COLUMNS, ROWS = 8, 4
SAMPLES = 256
VERTICES = 6  # of a path, at most
TOLERANCE = 0.01
LIGHTING_MODES = {"Standard": "SPEC", "Unitless": "COMPAT", "Raw": "RAW"}


def export(path, lighting_mode):
    """As a person would, from the File menu: only the lighting mode is not the default."""
    hidden = [thing for thing in bpy.data.objects if thing.get("rendered_only")]
    for thing in hidden:
        thing.hide_set(True)
    mode = "convert_lighting_mode" if bpy.app.version < (3, 6) else "export_import_convert_lighting_mode"
    bpy.ops.export_scene.gltf(
        filepath=str(path), export_format="GLB", use_visible=True, export_cameras=True,
        export_lights=True, **{mode: lighting_mode},
    )
    for thing in hidden:
        thing.hide_set(False)


def prepare_for_cycles(is_lambertian):
    for thing in bpy.data.objects:
        thing.hide_render = bool(thing.get("exported_only"))
    if is_lambertian:
        for material in bpy.data.materials:
            by_cycles.make_lambertian(material)


def picture_size():
    render = bpy.context.scene.render
    return render.resolution_x, render.resolution_y


def run_foveola(foveola, scene, output, options):
    width, height = picture_size()
    command = [foveola, "render", str(scene), "-o", str(output), "--size", f"{width}x{height}",
               "--spp", str(SAMPLES), "--max-depth", str(VERTICES), *options]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(command)} failed: {done.stderr}")


def load(path):
    """Linear, its first row at the top: [row, column, channel]."""
    image = bpy.data.images.load(str(path))
    image.colorspace_settings.name = "Non-Color"
    width, height = image.size
    pixels = numpy.empty(width * height * 4, numpy.float32)
    image.pixels.foreach_get(pixels)
    return pixels.reshape(height, width, 4)[::-1, :, :3].astype(float)


def blocks(picture):
    """[row of blocks, pixel, column of blocks, pixel]; pixels that fill no block are left out."""
    luminance = picture @ [0.2126, 0.7152, 0.0722]
    height, width = luminance.shape[0] // ROWS, luminance.shape[1] // COLUMNS
    return luminance[: ROWS * height, : COLUMNS * width].reshape(ROWS, height, COLUMNS, width)


def compare(theirs, ours):
    """The greatest relative difference of the channels' means, the greatest of the blocks' means,
    and the number of blocks that this is of: those whose standard error is small enough to tell."""
    means = numpy.abs(ours.mean((0, 1)) / theirs.mean((0, 1)) - 1.0).max()
    block_means = numpy.maximum(blocks(theirs).mean((1, 3)), 1e-9)
    difference = blocks(ours) - blocks(theirs)
    pixels = difference.shape[1] * difference.shape[3]
    error = difference.std((1, 3)) / math.sqrt(pixels) / block_means
    can_tell = (error < TOLERANCE / 3.0) & (block_means > 1e-6)
    relative = numpy.abs(difference.mean((1, 3))) / block_means
    return means, relative[can_tell].max(), numpy.count_nonzero(can_tell)


def write_beside(path, theirs, ours):
    """Both pictures as a screen shows them, the brightest hundredth of pixels white."""
    both = numpy.concatenate([theirs, numpy.ones((theirs.shape[0], 4, 3)), ours], axis=1)
    white = numpy.percentile(theirs, 99.0)
    shown = numpy.clip(both / white, 0.0, 1.0) ** (1.0 / 2.2)
    pixels = numpy.ones((*shown.shape[:2], 4), numpy.float32)
    pixels[..., :3] = shown
    image = bpy.data.images.new("beside", shown.shape[1], shown.shape[0])
    image.colorspace_settings.name = "Non-Color"
    image.pixels.foreach_set(pixels[::-1].ravel())
    image.filepath_raw, image.file_format = str(path), "PNG"
    image.save()


def percent(value):
    return f"{100.0 * value:.2f} %"


def render_export(foveola, name, mode, options, folder):
    """As Foveola shows what that lighting mode wrote, but for the factor that "Raw" is known by."""
    stem = f"{name}-{mode.lower()}"
    units = [] if mode == "Standard" else ["--light-units", "radiometric"]
    run_foveola(foveola, folder / f"{stem}.glb", folder / f"{stem}.exr", options + units)
    picture = load(folder / f"{stem}.exr")
    return picture / scenes.WITH_LIGHTS[name] if mode == "Raw" else picture


def check(foveola, name, folder):
    render = bpy.context.scene.render
    render.resolution_x, render.resolution_y = WIDTH, HEIGHT
    is_lambertian = name in scenes.LAMBERTIAN
    options = {**scenes.LAMBERTIAN, **scenes.PRINCIPLED}[name](folder)
    options += ["--diffuse"] if is_lambertian else []
    bpy.context.view_layer.update()
    modes = LIGHTING_MODES if name in scenes.WITH_LIGHTS else {"Standard": "SPEC"}
    for mode, value in modes.items():
        export(folder / f"{name}-{mode.lower()}.glb", value)
    prepare_for_cycles(is_lambertian)
    by_cycles.render(folder / f"{name}-cycles.exr", SAMPLES, VERTICES)
    theirs = load(folder / f"{name}-cycles.exr")
    is_close = True
    for mode in modes:
        ours = render_export(foveola, name, mode, options, folder)
        if mode == "Standard":
            write_beside(folder / f"{name}.png", theirs, ours)
        means, block_means, count = compare(theirs, ours)
        print(f"| {name} | {mode} | {percent(means)} | {percent(block_means)} | {count} |")
        is_close = is_close and means < TOLERANCE and block_means < TOLERANCE
    return is_close or not is_lambertian


def main():
    foveola, name, folder = sys.argv[sys.argv.index("--") + 1 :]
    bpy.ops.wm.read_factory_settings(use_empty=True)
    if not check(foveola, name, pathlib.Path(folder)):
        sys.exit(f"{name}: the pictures differ by more than {percent(TOLERANCE)}")


if __name__ == "__main__":
    main()
