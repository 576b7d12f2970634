"""A scene of which all is known that the add-on sends, and one of what it cannot send."""

import math

import bpy
import scenes

CAMERA_ROLL_DEG = -12.0


def make_known():
    """A cube of 12 triangles, a point of radius 0.25 m and 40 pi W, a sun of 3 W/m^2 that is 2 degrees
    across, an area light of 12 W on 1.5 m^2, a world of one colour, and a rolled camera."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scenes.add_box("cube", (1.0, 1.0, 1.0), scenes.paint("red"), (0.0, 0.0, 0.5))
    point = scenes.add_light("POINT", 40.0 * math.pi, (1.0, 2.0, 3.0))
    point.color = (1.0, 0.5, 0.25)
    point.shadow_soft_size = 0.25
    scenes.add_light("SUN", 3.0, (0.0, 0.0, 5.0)).angle = math.radians(2.0)
    area = bpy.data.lights.new("panel", "AREA")
    area.shape, area.size, area.size_y, area.energy = "RECTANGLE", 1.5, 1.0, 12.0
    scenes.link("panel", area, (0.0, 0.0, 4.0))
    scenes.set_world((0.25, 0.5, 1.0), 2.0)
    scenes.add_camera((4.0, -5.0, 2.0), (0.0, 0.0, 0.5), roll_deg=CAMERA_ROLL_DEG)


def add_unsent():
    """Things that do not come across; returns the start of the line that names each."""
    scenes.link("blob", bpy.data.metaballs.new("blob"))
    scenes.link("fog", bpy.data.volumes.new("fog"))
    hidden = scenes.add_box("hidden", (1.0, 1.0, 1.0), scenes.paint("blue"), (3.0, 0.0, 0.5))
    hidden.hide_viewport = True
    hairy = scenes.add_box("hairy", (1.0, 1.0, 1.0), with_noise(), (-3.0, 0.0, 0.5))
    hairy.modifiers.new("fur", "PARTICLE_SYSTEM").particle_system.settings.type = "HAIR"
    hairy.modifiers.new("smooth", "SUBSURF").render_levels = 4
    bpy.data.lights["panel"].spread = math.radians(60.0)
    add_flat("flat")
    add_grouped("grouped")
    bpy.context.scene.camera.data.dof.use_dof = True
    tree = bpy.context.scene.world.node_tree
    sky = tree.nodes.new("ShaderNodeTexSky")
    tree.links.new(sky.outputs[0], tree.nodes["Background"].inputs["Color"])
    return [
        "World: Sky Texture is not translated", "blob: metaballs", "fog: volumes",
        "hidden: rendered, but hidden", "hairy: hair", "hairy: modifier smooth",
        "hairy, material noisy: Base Color: Noise Texture", "panel: its spread",
        "flat, material matt: Diffuse BSDF is not translated", "camera: its depth of field",
        "grouped, material mixed: Base Color: node group wood",
    ]


def with_noise():
    material = scenes.principled("noisy")
    nodes = material.node_tree.nodes
    noise = nodes.new("ShaderNodeTexNoise")
    material.node_tree.links.new(
        noise.outputs["Color"], nodes["Principled BSDF"].inputs["Base Color"]
    )
    return material


def add_flat(name):
    material = scenes.principled("matt")
    nodes = material.node_tree.nodes
    diffuse = nodes.new("ShaderNodeBsdfDiffuse")
    material.node_tree.links.new(diffuse.outputs[0], nodes["Material Output"].inputs["Surface"])
    scenes.add_rectangle(name, 1.0, 1.0, material, (0.0, 0.0, 0.01))


def add_grouped(name):
    """A surface whose colour comes from a node group."""
    group = bpy.data.node_groups.new("wood", "ShaderNodeTree")
    group.outputs.new("NodeSocketColor", "Colour")
    material = scenes.principled("mixed")
    nodes, links = material.node_tree.nodes, material.node_tree.links
    node = nodes.new("ShaderNodeGroup")
    node.node_tree = group
    links.new(node.outputs[0], nodes["Principled BSDF"].inputs["Base Color"])
    scenes.add_rectangle(name, 1.0, 1.0, material, (0.0, 0.0, 0.02))
