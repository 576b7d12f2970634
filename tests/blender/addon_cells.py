"""Cells of a picture, one for each thing that Cycles decides and the glTF exporter decides otherwise.

The camera looks down on squares that fill a block of the picture each, before a world of 0.5. What
must not be seen is bright, so that no cell is right by chance.
"""

import bpy
import scenes

COLUMNS, ROWS, SIZE = 8, 4, 1.0
WIDTH = SIZE * COLUMNS
ASPECT_RATIO = 16.0 / 9.0


def square(material, name="square"):
    """At the origin, as large as a cell; material: None for none."""
    x, y = SIZE / 2, WIDTH / ASPECT_RATIO / ROWS / 2
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata([(-x, -y, 0), (x, -y, 0), (x, y, 0), (-x, y, 0)], [], [(0, 1, 2, 3)])
    if material is not None:
        mesh.materials.append(material)
    return scenes.link(name, mesh)


def bright():
    return scenes.emitter("bright", (1.0, 1.0, 1.0), 3.0, shines_from_behind=True)


def paint(**values):
    return scenes.principled("paint", Roughness=1.0, Specular=0.0, **values)


def collection(parent=None, is_disabled=False):
    made = bpy.data.collections.new("collection")
    made.hide_render = is_disabled
    if parent is not None:
        parent.children.link(made)
    return made


def move(thing, target):
    for place in list(thing.users_collection):
        place.objects.unlink(thing)
    target.objects.link(thing)
    return thing


def instance(target):
    place = scenes.link("instance", None)
    place.instance_type, place.instance_collection = "COLLECTION", target
    return place


# ---- What is disabled in renders ---------------------------------------------------------------


def object_in_instance():
    target = collection()
    move(square(bright()), target).hide_render = True
    instance(target)


def instanced_collection():
    target = collection(is_disabled=True)
    move(square(bright()), target)
    instance(target)


def collection_in_instance():
    target = collection()
    move(square(bright()), collection(target, is_disabled=True))
    instance(target)


def collection_below_disabled():
    top = collection(bpy.context.scene.collection, is_disabled=True)
    move(square(bright()), collection(top))


def instance_in_instance():
    inner, outer = collection(), collection()
    move(square(bright()), inner)
    move(instance(inner), outer).hide_render = True
    instance(outer)


def collection_beside_other():
    """Also in a collection that is in no scene."""
    thing = move(square(bright()), collection(bpy.context.scene.collection, is_disabled=True))
    collection().objects.link(thing)


def child_outside_instance():
    target = collection()
    shown = move(square(paint(Base_Color=(0.4, 0.4, 0.4, 1.0))), target)
    child = move(square(bright()), collection())
    child.parent, child.location.z = shown, 0.01
    instance(target)


def emitter_of_particles():
    thing = square(bright())
    thing.modifiers.new("particles", "PARTICLE_SYSTEM")
    thing.show_instancer_for_render = False


def area_light_in_instance():
    light = bpy.data.lights.new("area", "AREA")
    light.energy, light.size = 100.0, 0.2
    target = collection()
    move(scenes.link("area", light, (0.0, 0.0, 0.5)), collection(target, is_disabled=True))
    instance(target)


# ---- Surfaces ----------------------------------------------------------------------------------


def no_material():
    square(None)


def empty_slot():
    square(None).data.materials.append(None)


def text_without_material():
    curve = bpy.data.curves.new("curve", "CURVE")
    curve.dimensions, curve.fill_mode = "2D", "BOTH"
    spline = curve.splines.new("POLY")
    spline.points.add(3)
    for point, (x, y) in zip(spline.points, [(-1, -1), (1, -1), (1, 1), (-1, 1)]):
        point.co = (0.5 * SIZE * x, 0.5 * WIDTH / ASPECT_RATIO / ROWS * y, 0.0, 1.0)
    spline.use_cyclic_u = True
    scenes.link("curve", curve)


def material_without_nodes(metallic=0.0):
    material = bpy.data.materials.new("without nodes")
    material.diffuse_color = (0.6, 0.3, 0.1, 1.0)
    material.metallic = metallic
    square(material)


def metal_without_nodes():
    material_without_nodes(1.0)


def material_without_surface():
    material = paint()
    material.node_tree.nodes.remove(material.node_tree.nodes["Principled BSDF"])
    square(material)


def muted_surface():
    material = paint()
    material.node_tree.nodes["Principled BSDF"].mute = True
    square(material)


def colour_that_no_material_uses():
    add_colour(square(paint(Base_Color=(0.75, 0.75, 0.75, 1.0))))


def colour_of_roughness():
    material = paint(Base_Color=(0.75, 0.75, 0.75, 1.0))
    add_colour(square(material))
    use_colour(material, "Roughness")


def colour_for_rendering():
    material = paint()
    thing = square(material)
    add_colour(thing, "other", (1.0, 1.0, 1.0, 1.0))
    add_colour(thing, "rendered", (0.7, 0.2, 0.1, 1.0))
    thing.data.color_attributes.render_color_index = 1
    use_colour(material, "Base Color")


def add_colour(thing, name="colour", colour=(0.05, 0.05, 0.05, 1.0)):
    for value in thing.data.color_attributes.new(name, "FLOAT_COLOR", "CORNER").data:
        value.color = colour


def use_colour(material, socket):
    tree = material.node_tree
    node = tree.nodes.new("ShaderNodeVertexColor")
    tree.links.new(node.outputs["Color"], tree.nodes["Principled BSDF"].inputs[socket])


def alpha_of_opaque():
    square(paint(Base_Color=(0.0, 0.0, 0.0, 1.0), Alpha=0.3))


def alpha_of_clip():
    material = paint(Base_Color=(0.0, 0.0, 0.0, 1.0), Alpha=0.3)
    material.blend_method = "CLIP"
    square(material)


def culled_lamp():
    material = paint()
    tree = material.node_tree
    lamp = tree.nodes.new("ShaderNodeEmission")
    lamp.inputs["Color"].default_value = (0.4, 0.3, 0.2, 1.0)
    tree.links.new(lamp.outputs[0], tree.nodes["Material Output"].inputs["Surface"])
    tree.nodes.remove(tree.nodes["Principled BSDF"])
    material.use_backface_culling = True
    square(material).rotation_euler.x = 3.14159265


CELLS = (
    object_in_instance, instanced_collection, collection_in_instance, collection_below_disabled,
    instance_in_instance, collection_beside_other, child_outside_instance, emitter_of_particles,
    area_light_in_instance, no_material, empty_slot, text_without_material, material_without_nodes,
    metal_without_nodes, material_without_surface, muted_surface, colour_that_no_material_uses,
    colour_of_roughness, colour_for_rendering, alpha_of_opaque, alpha_of_clip, culled_lamp,
)


def add_all():
    scene = bpy.context.scene
    scenes.set_world((0.5, 0.5, 0.5))
    height = WIDTH / ASPECT_RATIO / ROWS
    for number, add in enumerate(CELLS):
        before = set(scene.objects)
        add()
        row, column = divmod(number, COLUMNS)
        for thing in set(scene.objects) - before:
            if thing.parent is None:
                thing.location.x += (column - 0.5 * (COLUMNS - 1)) * SIZE
                thing.location.y -= (row - 0.5 * (ROWS - 1)) * height
    # A sensor 36 mm wide behind 36 mm: as wide as it is far.
    scenes.add_camera((0.0, 0.0, WIDTH), (0.0, 0.0, 0.0), lens_mm=36.0)
