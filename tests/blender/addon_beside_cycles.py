"""Renders scenes with Cycles, and with Foveola what the add-on makes of them, and compares the means.

Run by Blender, headless:
  blender -b --factory-startup --python addon_beside_cycles.py -- FOVEOLA SCENE FOLDER
The scenes have what Blender's glTF exporter leaves out: sizes of lights, area lights, nodes of lights,
worlds. Foveola is told nothing but the number of samples, and --diffuse. Prints a row of a table, and
fails if a mean differs by more than a hundredth.
"""

import math
import pathlib
import sys

import bpy
import numpy

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))
import addon
import addon_cells
import beside_cycles
import by_cycles
import scenes


def add_area_light(shape, size, power_w, **pose):
    light = bpy.data.lights.new(shape.lower(), "AREA")
    light.shape, light.energy = shape, power_w
    light.size, light.size_y = size
    return scenes.link(light.name, light, **pose)


def area_lights(_folder):
    """A rectangle that its object stretches, a round one, and one that is mirrored by its scale."""
    scenes.add_table_top()
    stretched = add_area_light(
        "RECTANGLE", (1.0, 0.8), 90.0, location=(-1.5, -0.8, 3.2), rotation_deg=(10.0, 25.0, 25.0)
    )
    stretched.scale = (1.5, 0.7, 2.0)
    stretched.data.color = (1.0, 0.7, 0.5)
    add_area_light(
        "ELLIPSE", (1.4, 0.6), 60.0, location=(1.8, -1.2, 3.0), rotation_deg=(-20.0, -35.0, 0.0)
    )
    mirrored = add_area_light("SQUARE", (0.5, 0.0), 20.0, location=(0.2, 0.2, 3.5))
    mirrored.scale = (-1.0, 1.0, 1.0)
    scenes.add_camera((0.5, -5.0, 2.5), (0.0, 0.5, 0.6))


def wide_sun(_folder):
    scenes.add_table_top()
    light = scenes.add_light("SUN", 3.0, (0.0, 0.0, 5.0), (40.0, 15.0, 20.0), (1.0, 0.9, 0.7))
    light.angle = math.radians(12.0)
    scenes.add_camera((0.5, -5.0, 2.5), (0.0, 0.5, 0.6))


def bulbs(_folder):
    """A point and a spot with radii, the spot with nodes of its own colour and strength. Cycles' bulbs
    are discs that face what they light, and give less where it is near: I / (d^2 + r^2), 0.4 % here."""
    scenes.add_table_top()
    point = scenes.add_light("POINT", 200.0, (1.0, -1.5, 3.0), colour=(1.0, 0.8, 0.6))
    point.shadow_soft_size = 0.15
    spot = scenes.add_light("SPOT", 600.0, (-2.0, -2.0, 3.5), (35.0, 0.0, -35.0), (0.7, 0.8, 1.0))
    spot.spot_size, spot.spot_blend = math.radians(70.0), 0.6
    spot.shadow_soft_size = 0.05
    spot.use_nodes = True
    emission = spot.node_tree.nodes["Emission"].inputs
    emission["Color"].default_value, emission["Strength"].default_value = (0.5, 1.0, 0.7, 1.0), 1.7
    scenes.add_camera((-1.0, -5.0, 2.0), (0.0, 0.5, 0.7), lens_mm=28.0)


def turned_world(folder):
    """A world's image, turned about the vertical."""
    scenes.add_table_top()
    scenes.add_camera((0.5, -5.0, 2.0), (0.0, 0.5, 1.2), lens_mm=24.0)
    scenes.sky_of_blender(folder, 1.2)
    tree = bpy.context.scene.world.node_tree
    texture = next(node for node in tree.nodes if node.type == "TEX_ENVIRONMENT")
    mapping = tree.nodes.new("ShaderNodeMapping")
    mapping.inputs["Rotation"].default_value[2] = math.radians(70.0)
    coordinates = tree.nodes.new("ShaderNodeTexCoord")
    tree.links.new(coordinates.outputs["Generated"], mapping.inputs["Vector"])
    tree.links.new(mapping.outputs["Vector"], texture.inputs["Vector"])


def painted_world(folder):
    """A world's image that is in no file: 8 bits, in sRGB, with texels so small that it does not matter
    whether neighbours are blended before or after decoding; and a sign that only emits."""
    turned_world(folder)
    tree = bpy.context.scene.world.node_tree
    texture = next(node for node in tree.nodes if node.type == "TEX_ENVIRONMENT")
    image = bpy.data.images.new("painted", 512, 256)
    pixels = numpy.ones((256, 512, 4), numpy.float32)
    row, column = numpy.mgrid[0:256, 0:512]
    pixels[..., 0], pixels[..., 1] = row / 255.0, 0.2 + 0.6 * column / 511.0
    pixels[..., 2] = 0.3 + 0.4 * ((row // 64 + column // 64) % 2)
    image.pixels.foreach_set(pixels.ravel())
    texture.image = image
    material = bpy.data.materials.new("sign")
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    emission = nodes.new("ShaderNodeEmission")
    emission.inputs["Color"].default_value = (0.3, 0.5, 1.0, 1.0)
    emission.inputs["Strength"].default_value = 2.5
    links.new(emission.outputs[0], nodes["Material Output"].inputs["Surface"])
    nodes.remove(nodes["Principled BSDF"])
    scenes.add_rectangle("sign", 1.0, 0.6, material, (-2.0, 2.9, 1.6), (90.0, 0.0, 0.0))


def rolled_camera(_folder):
    scenes.camera(None)


def cells(_folder):
    addon_cells.add_all()


SCENES = {
    function.__name__.replace("_", "-"): function
    for function in (area_lights, wide_sun, bulbs, turned_world, painted_world, rolled_camera, cells)
}


def make_lambertian():
    """All Principled BSDFs but those whose alpha counts, which are black."""
    for material in bpy.data.materials:
        principled = material.node_tree and material.node_tree.nodes.get("Principled BSDF")
        if principled and not principled.mute and principled.inputs["Alpha"].default_value == 1.0:
            material.use_backface_culling = False  # of which Cycles knows nothing
            by_cycles.make_lambertian(material)


def compare_cells(theirs, ours):
    """As beside_cycles.compare, of blocks that are one surface each; relative to the background."""
    background = theirs.max()
    difference = numpy.abs((ours - theirs).mean((0, 1))).max() / background
    in_blocks = beside_cycles.blocks(ours) - beside_cycles.blocks(theirs)
    means = numpy.abs(in_blocks.mean((1, 3))) / background
    print("cells that differ:", numpy.argwhere(means >= beside_cycles.TOLERANCE).tolist())
    return difference, means.max(), means.size


def check(foveola, name, folder):
    render = bpy.context.scene.render
    render.resolution_x, render.resolution_y = beside_cycles.WIDTH, beside_cycles.HEIGHT
    SCENES[name](folder)
    bpy.context.view_layer.update()
    place = folder / f"addon-{name}"
    place.mkdir(exist_ok=True)
    addon.export(addon.enable(), place)
    make_lambertian()
    by_cycles.render(place / "cycles.exr", beside_cycles.SAMPLES, beside_cycles.VERTICES)
    theirs = beside_cycles.load(place / "cycles.exr")
    beside_cycles.run_foveola(foveola, place / "scene.glb", place / "foveola.exr", ["--diffuse"])
    ours = beside_cycles.load(place / "foveola.exr")
    beside_cycles.write_beside(place / "beside.png", theirs, ours)
    compare = compare_cells if name == "cells" else beside_cycles.compare
    means, block_means, count = compare(theirs, ours)
    percent = beside_cycles.percent
    print(f"| {name} | {percent(means)} | {percent(block_means)} | {count} |")
    return max(means, block_means) < beside_cycles.TOLERANCE


def main():
    foveola, name, folder = sys.argv[sys.argv.index("--") + 1 :]
    bpy.ops.wm.read_factory_settings(use_empty=True)
    if not check(foveola, name, pathlib.Path(folder)):
        sys.exit(f"{name}: the pictures differ by more than a hundredth")


if __name__ == "__main__":
    main()
