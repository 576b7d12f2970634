"""Renders Blender's scene with Cycles to a linear image, without anything that makes a mean untrue."""

import bpy
import scenes


def make_lambertian(material):
    """Replaces a Principled BSDF by a Diffuse one: Principled's diffuse part is not Lambertian."""
    nodes, links = material.node_tree.nodes, material.node_tree.links
    principled = nodes["Principled BSDF"].inputs
    colour = principled["Base Color"]
    diffuse = nodes.new("ShaderNodeBsdfDiffuse")
    if colour.is_linked:
        links.new(colour.links[0].from_socket, diffuse.inputs["Color"])
    else:
        diffuse.inputs["Color"].default_value = colour.default_value
    emission = nodes.new("ShaderNodeEmission")
    emission.inputs["Color"].default_value = scenes.principled_input(principled, "Emission").default_value
    emission.inputs["Strength"].default_value = principled["Emission Strength"].default_value
    if material.use_backface_culling:  # glTF's single-sided emitters are dark from behind
        geometry = nodes.new("ShaderNodeNewGeometry")
        front = nodes.new("ShaderNodeMath")
        front.operation = "SUBTRACT"
        front.inputs[0].default_value = 1.0
        links.new(geometry.outputs["Backfacing"], front.inputs[1])
        strength = nodes.new("ShaderNodeMath")
        strength.operation = "MULTIPLY"
        strength.inputs[1].default_value = emission.inputs["Strength"].default_value
        links.new(front.outputs[0], strength.inputs[0])
        links.new(strength.outputs[0], emission.inputs["Strength"])
    both = nodes.new("ShaderNodeAddShader")
    links.new(diffuse.outputs[0], both.inputs[0])
    links.new(emission.outputs[0], both.inputs[1])
    links.new(both.outputs[0], nodes["Material Output"].inputs["Surface"])


def render(path, samples, vertices):
    """vertices: the most surface vertices of a path, as of Foveola's --max-depth."""
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.resolution_percentage = 100
    settings = scene.cycles
    settings.device = "CPU"
    settings.samples = samples
    settings.use_adaptive_sampling = False
    settings.use_denoising = False
    settings.light_sampling_threshold = 0.0
    settings.sample_clamp_direct = settings.sample_clamp_indirect = 0.0
    settings.pixel_filter_type, settings.filter_width = "BOX", 1.0
    settings.blur_glossy = 0.0
    settings.caustics_reflective = settings.caustics_refractive = True
    settings.min_light_bounces = 0
    settings.max_bounces = settings.diffuse_bounces = vertices - 1
    settings.glossy_bounces = settings.transmission_bounces = vertices - 1
    scene.view_settings.view_transform = "Raw"
    image = scene.render.image_settings
    image.file_format, image.color_mode, image.color_depth = "OPEN_EXR", "RGB", "32"
    scene.render.filepath = str(path)
    scene.render.use_file_extension = False
    bpy.ops.render.render(write_still=True)
