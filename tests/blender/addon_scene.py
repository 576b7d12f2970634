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
    return add_listed() + [
        "World: Sky Texture is not translated", "blob: metaballs", "fog: volumes",
        "hidden: rendered, but hidden", "hairy: hair", "hairy: modifier smooth",
        "hairy, material noisy: Base Color: Noise Texture", "panel: its spread",
        "flat, material matt: Diffuse BSDF is not translated", "camera: its depth of field",
        "grouped, material mixed: Base Color: node group wood",
    ]


def add_listed():
    """What Cycles shows and the preview does otherwise, as pictures of both show; returns the lines."""
    scene, panel = bpy.context.scene, bpy.data.objects["panel"]
    scene.render.film_transparent = scene.render.use_motion_blur = True
    scene.cycles.film_exposure = 2.0
    scene.world.cycles_visibility.diffuse = panel.visible_diffuse = False
    scene.camera.data.clip_end = 5.0
    held = bpy.data.collections.new("held")
    scene.collection.children.link(held)
    bpy.context.view_layer.layer_collection.children["held"].holdout = True
    return [
        "Scene: the transparent film is not sent", "Scene: motion blur is not sent",
        "Scene: the film's exposure is not sent", "World: seen by all rays", "panel: seen by all rays",
        "camera: its clipping is not sent", "Collection held: seen by all rays, in spite of its holdout",
        *add_shapes(), *add_textured(),
    ]


def add_shapes():
    place = scenes.link("place", None)
    place.instance_type, place.instance_collection = "COLLECTION", bpy.data.collections["held"]
    scenes.add_rectangle("child", 1.0, 1.0, scenes.paint("red"), (0.0, 0.0, 0.0)).parent = place
    stretched = scenes.link("stretched", None)
    stretched.scale = (2.0, 0.5, 1.0)
    sheared = scenes.add_rectangle("sheared", 1.0, 1.0, scenes.paint("red"), (0.0, 0.0, 0.0), (0, 0, 45))
    sheared.parent = stretched
    bent = scenes.add_rectangle("bent", 1.0, 1.0, scenes.paint("red"), (0.0, 0.0, 0.0))
    bent.parent, bent.parent_type = scenes.link("lattice", bpy.data.lattices.new("lattice")), "LATTICE"
    keyed = scenes.add_rectangle("keyed", 1.0, 1.0, scenes.paint("red"), (0.0, 0.0, 0.0))
    keyed.shape_key_add(name="Basis")
    keyed.shape_key_add(name="muted").mute = True
    bow = bpy.data.curves.new("bow", "CURVE")
    bow.render_resolution_u = 30
    bow.materials.append(None)
    bow.materials.append(scenes.paint("red"))
    scenes.link("bow", bow).modifiers.new("screw", "SCREW").render_steps = 30
    return [
        "child: not sent, since its parent", "sheared: its shear", "bent: its parent's deformation",
        "keyed: its muted, pinned or grouped shape keys", "bow: its resolution", "bow: its materials",
        "bow: modifier screw",
    ]


def add_textured():
    """Base colours with a texture, each with a fault of its own."""
    def missing(_tree, texture):
        texture.image = None

    def linear(_tree, texture):
        texture.image.colorspace_settings.name = "Non-Color"

    def clipped(_tree, texture):
        texture.extension = "CLIP"

    def muted(_tree, texture):
        texture.mute = True

    def by_object(tree, texture):
        coordinates = tree.nodes.new("ShaderNodeTexCoord")
        tree.links.new(coordinates.outputs["Object"], texture.inputs["Vector"])

    def tilted(tree, texture):
        mapping = tree.nodes.new("ShaderNodeMapping")
        mapping.inputs["Rotation"].default_value[0] = 1.0
        tree.links.new(mapping.outputs[0], texture.inputs["Vector"])

    def other_uv(tree, texture):
        node = tree.nodes.new("ShaderNodeUVMap")
        node.uv_map = "elsewhere"
        tree.links.new(node.outputs[0], texture.inputs["Vector"])

    def one_channel(tree, texture):
        node = tree.nodes.new("ShaderNodeSeparateColor")
        tree.links.new(texture.outputs[0], node.inputs[0])
        tree.links.new(node.outputs[0], tree.nodes["Principled BSDF"].inputs["Base Color"])

    def multiplied(tree, texture, factor=0.5):
        node = tree.nodes.new("ShaderNodeMix")
        node.data_type, node.blend_type = "RGBA", "MULTIPLY"
        node.inputs[0].default_value = factor
        tree.links.new(texture.outputs[0], node.inputs[6])
        tree.links.new(node.outputs[2], tree.nodes["Principled BSDF"].inputs["Base Color"])
        return node

    def squared(tree, texture):
        tree.links.new(texture.outputs[0], multiplied(tree, texture, 1.0).inputs[7])

    def coloured(tree, texture):
        node = tree.nodes.new("ShaderNodeVertexColor")
        node.layer_name = "elsewhere"
        tree.links.new(node.outputs[0], multiplied(tree, texture, 1.0).inputs[7])

    def for_eevee(tree, _texture):
        output = tree.nodes["Material Output"]
        other = tree.nodes.new("ShaderNodeOutputMaterial")
        other.target, output.target, output.is_active_output = "CYCLES", "EEVEE", True

    faults = {
        missing: "its image is missing", linear: "image linear is read as sRGB, not Non-Color",
        clipped: "Image Texture is shown flat", muted: "Image Texture is not translated",
        by_object: "Texture Coordinate is not translated", tilted: "Mapping is not translated",
        other_uv: "UV map elsewhere has not the same place", one_channel: "Separate Color",
        multiplied: "Mix is not translated", squared: "Mix is not translated",
        coloured: "the colour attribute elsewhere is not sent",
    }
    lines = []
    for change in (*faults, for_eevee):
        name = change.__name__
        material = scenes.principled(name)
        tree = material.node_tree
        texture = tree.nodes.new("ShaderNodeTexImage")
        texture.image = bpy.data.images.new(name, 4, 4)
        tree.links.new(texture.outputs[0], tree.nodes["Principled BSDF"].inputs["Base Color"])
        change(tree, texture)
        scenes.give_texture_coordinates(
            scenes.add_rectangle(name, 0.1, 0.1, material, (0.0, 0.0, 0.0)))
        fault = faults.get(change)
        lines.append(f"{name}, material {name}: " + (f"Base Color: {fault}" if fault else "its output for"))
    return lines


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
    scenes.add_socket(group, "NodeSocketColor", "Colour", "OUTPUT")
    group.nodes.new("NodeGroupOutput")
    material = scenes.principled("mixed")
    nodes, links = material.node_tree.nodes, material.node_tree.links
    node = nodes.new("ShaderNodeGroup")
    node.node_tree = group
    links.new(node.outputs[0], nodes["Principled BSDF"].inputs["Base Color"])
    scenes.add_rectangle(name, 1.0, 1.0, material, (0.0, 0.0, 0.02))
