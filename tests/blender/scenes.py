"""The scenes that Blender exports and renders by itself, beside Foveola's picture of the export.

Each function fills Blender's empty scene with surfaces, lights and a camera, and returns what a person
would add on Foveola's command line for what glTF does not hold. Lengths are metres, powers watts.
"""

import math

import bmesh
import bpy
import mathutils
import numpy

PAINT = {
    "grey": (0.5, 0.5, 0.5),
    "light": (0.75, 0.75, 0.75),
    "red": (0.6, 0.12, 0.08),
    "green": (0.15, 0.45, 0.12),
    "blue": (0.1, 0.2, 0.6),
}

# Cycles' area lights have a radiance of power / (this * area): until Blender 4.0 less than a Lambertian
# emitter of that power.
AREA_LIGHT_SOLID_ANGLE_SR = 4.0 if bpy.app.version < (4, 0) else math.pi

NAME_IN_BLENDER_4 = {
    "Clearcoat": "Coat Weight",
    "Emission": "Emission Color",
    "Specular": "Specular IOR Level",
    "Transmission": "Transmission Weight",
}


def link(name, data, location=(0.0, 0.0, 0.0), rotation_deg=(0.0, 0.0, 0.0)):
    thing = bpy.data.objects.new(name, data)
    thing.location = location
    thing.rotation_euler = [math.radians(angle) for angle in rotation_deg]
    bpy.context.scene.collection.objects.link(thing)
    return thing


def principled_input(inputs, name):
    """The input of a Principled BSDF that has this name in Blender 3."""
    return inputs[name] if name in inputs else inputs[NAME_IN_BLENDER_4[name]]


def principled(name, **values):
    """A material of one Principled BSDF, the only kind that the exporter knows, with these inputs."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    inputs = material.node_tree.nodes["Principled BSDF"].inputs
    for key, value in values.items():
        principled_input(inputs, key.replace("_", " ")).default_value = value
    return material


def paint(colour):
    """Lambertian once exported: fully rough, without reflection."""
    return principled(colour, Base_Color=(*PAINT[colour], 1.0), Roughness=1.0, Specular=0.0)


def emitter(name, colour, strength, shines_from_behind=False):
    material = principled(
        name, Base_Color=(0.0, 0.0, 0.0, 1.0), Roughness=1.0, Specular=0.0,
        Emission=(*colour, 1.0), Emission_Strength=strength,
    )
    material.use_backface_culling = not shines_from_behind
    return material


def add_mesh(name, corners, faces, material, location=(0.0, 0.0, 0.0), rotation_deg=(0.0, 0.0, 0.0)):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(corners, [], faces)
    mesh.materials.append(material)
    return link(name, mesh, location, rotation_deg)


def add_rectangle(name, width, depth, material, location, rotation_deg=(0.0, 0.0, 0.0)):
    """Faces +Z before it is turned."""
    x, y = width / 2, depth / 2
    corners = [(-x, -y, 0), (x, -y, 0), (x, y, 0), (-x, y, 0)]
    return add_mesh(name, corners, [(0, 1, 2, 3)], material, location, rotation_deg)


def add_box(name, size, material, location, rotation_deg=(0.0, 0.0, 0.0), inwards=False):
    x, y, z = (length / 2 for length in size)
    corners = [(sx * x, sy * y, sz * z) for sz in (-1, 1) for sy in (-1, 1) for sx in (-1, 1)]
    faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    if inwards:
        faces = [face[::-1] for face in faces]
    return add_mesh(name, corners, faces, material, location, rotation_deg)


def add_light(kind, energy, location, rotation_deg=(0.0, 0.0, 0.0), colour=(1.0, 1.0, 1.0)):
    """Without size, since the exporter does not write sizes. energy: W, of a sun W/m^2."""
    light = bpy.data.lights.new(kind.lower(), kind)
    light.energy = energy
    light.color = colour
    if kind == "SUN":
        light.angle = 0.0
    else:
        light.shadow_soft_size = 0.0
    link(light.name, light, location, rotation_deg)
    return light


def add_camera(location, target, lens_mm=35.0, roll_deg=0.0):
    camera = bpy.data.cameras.new("camera")
    camera.lens = lens_mm
    thing = link("camera", camera, location)
    direction = mathutils.Vector(target) - mathutils.Vector(location)
    turned = direction.to_track_quat("-Z", "Y") @ mathutils.Quaternion(
        (0, 0, 1), math.radians(roll_deg)
    )
    thing.rotation_euler = turned.to_euler()
    bpy.context.scene.camera = thing
    return camera


def set_world(colour, strength=1.0):
    world = bpy.data.worlds.new("world")
    world.use_nodes = True
    background = world.node_tree.nodes["Background"]
    background.inputs["Color"].default_value = (*colour, 1.0)
    background.inputs["Strength"].default_value = strength
    bpy.context.scene.world = world
    return world


def add_table_top():
    """A floor, a wall, and three boxes."""
    add_rectangle("floor", 8.0, 8.0, paint("grey"), (0.0, 0.0, 0.0))
    add_rectangle("wall", 8.0, 4.0, paint("light"), (0.0, 3.0, 2.0), (90.0, 0.0, 0.0))
    add_box("red box", (1.0, 1.0, 1.0), paint("red"), (-1.2, 0.4, 0.5), (0.0, 0.0, 30.0))
    add_box("green box", (0.7, 0.7, 1.6), paint("green"), (0.6, 0.9, 0.8), (0.0, 0.0, -20.0))
    add_box("blue box", (0.8, 0.5, 0.6), paint("blue"), (1.5, -0.6, 0.3), (0.0, 0.0, 55.0))


def sun(folder):
    add_table_top()
    add_light("SUN", 3.0, (0.0, 0.0, 5.0), (40.0, 15.0, 20.0), (1.0, 0.9, 0.7))
    add_camera((0.5, -5.0, 2.5), (0.0, 0.5, 0.6))
    return []


def point(folder):
    add_table_top()
    add_light("POINT", 250.0, (1.0, -1.5, 3.0), colour=(1.0, 0.8, 0.6))
    add_camera((-1.0, -5.0, 2.0), (0.0, 0.5, 0.7), lens_mm=28.0)
    return []


def spot(folder):
    add_table_top()
    wide = add_light("SPOT", 600.0, (-2.0, -2.0, 3.5), (35.0, 0.0, -35.0), (0.7, 0.8, 1.0))
    wide.spot_size, wide.spot_blend = math.radians(70.0), 0.6
    narrow = add_light("SPOT", 400.0, (2.0, -1.0, 3.5), (0.0, 20.0, 0.0), (1.0, 0.9, 0.8))
    narrow.spot_size, narrow.spot_blend = math.radians(40.0), 0.15
    add_camera((0.0, -5.5, 3.0), (0.0, 0.3, 0.5))
    return []


def emission(folder):
    add_table_top()
    lamp = emitter("tube", (1.0, 0.7, 0.4), 12.0)
    add_box("tube", (2.0, 0.15, 0.15), lamp, (0.3, 1.5, 2.2), (0.0, 0.0, 10.0))
    sign = emitter("sign", (0.3, 0.5, 1.0), 0.8)
    add_rectangle("sign", 1.0, 0.6, sign, (-2.0, 2.9, 1.6), (90.0, 0.0, 0.0))
    add_camera((0.5, -5.0, 2.0), (0.0, 0.5, 1.0))
    return []


def area(folder):
    """The exporter leaves area lights out: the export has a panel of their radiance instead."""
    add_table_top()
    width_m, depth_m, power_w = 1.5, 0.8, 120.0
    light = bpy.data.lights.new("area", "AREA")
    light.shape, light.size, light.size_y = "RECTANGLE", width_m, depth_m
    light.energy = power_w
    pose = {"location": (-0.5, -0.8, 3.2), "rotation_deg": (10.0, 15.0, 25.0)}
    thing = link("area", light, **pose)
    thing["rendered_only"] = True
    radiance = power_w / (AREA_LIGHT_SOLID_ANGLE_SR * width_m * depth_m)
    panel = add_rectangle("panel", width_m, depth_m, emitter("panel", (1.0, 1.0, 1.0), radiance), **pose)
    panel.data.flip_normals()  # area lights shine towards their -Z
    panel["exported_only"] = True
    add_camera((0.5, -5.0, 2.5), (0.0, 0.5, 0.6))
    return []


def world_colour(folder):
    add_table_top()
    set_world((0.4, 0.6, 1.0), 1.5)
    add_camera((-0.5, -5.0, 3.0), (0.0, 0.5, 0.6))
    return ["--environment", "0.6,0.9,1.5"]


def write_environment(path):
    """A lat-long image whose every direction differs, so that no wrong turn goes unseen."""
    width, height = 256, 128
    azimuth = (numpy.arange(width) + 0.5) / width
    elevation = 0.5 - (numpy.arange(height) + 0.5) / height
    u, v = numpy.meshgrid(azimuth, elevation)
    pixels = numpy.ones((height, width, 4), numpy.float32)
    pixels[..., 0] = 0.2 + 4.0 * numpy.exp(-(((u - 0.2) / 0.06) ** 2) - ((v - 0.2) / 0.08) ** 2)
    pixels[..., 1] = 0.3 + 3.0 * numpy.exp(-(((u - 0.55) / 0.08) ** 2) - ((v - 0.1) / 0.1) ** 2)
    pixels[..., 2] = 0.2 + 1.2 * (v + 0.5)
    image = bpy.data.images.new("sky", width, height, float_buffer=True)
    image.pixels.foreach_set(pixels[::-1].ravel())
    image.filepath_raw = str(path)
    image.file_format = "HDR"
    image.save()
    return bpy.data.images.load(str(path))


def sky_of_blender(folder, strength):
    """A world image; its middle is +X in Blender, and -Z, Blender's +Y, in Foveola."""
    nodes = set_world((0.0, 0.0, 0.0), strength).node_tree
    sky = folder / "sky.hdr"
    texture = nodes.nodes.new("ShaderNodeTexEnvironment")
    texture.image = write_environment(sky)
    nodes.links.new(texture.outputs["Color"], nodes.nodes["Background"].inputs["Color"])
    return ["--environment", str(sky), "--environment-strength", str(strength),
            "--environment-rotation", "90"]


def world_image(folder):
    add_table_top()
    add_camera((0.5, -5.0, 2.0), (0.0, 0.5, 1.2), lens_mm=24.0)
    return sky_of_blender(folder, 1.2)


def checkered(name):
    """An image in sRGB, whose middle greys show a colour space that is wrong."""
    size = 512
    texels = numpy.ones((size, size, 4), numpy.float32)
    row, column = numpy.mgrid[0:size, 0:size] // 64
    odd = (row + column) % 2 == 1
    texels[..., 0] = numpy.where(odd, 0.35, 0.7)
    texels[..., 1] = numpy.where(odd, 0.5, 0.6)
    texels[..., 2] = 0.3 + 0.5 * column / column.max()
    image = bpy.data.images.new(name, size, size)
    image.pixels.foreach_set(texels.ravel())
    image.pack()
    material = paint("light")
    nodes = material.node_tree
    texture = nodes.nodes.new("ShaderNodeTexImage")
    texture.image = image
    nodes.links.new(
        texture.outputs["Color"], nodes.nodes["Principled BSDF"].inputs["Base Color"]
    )
    return material


def give_texture_coordinates(thing):
    layer = thing.data.uv_layers.new(name="UVMap")
    for loop, where in zip(thing.data.loops, layer.data):
        x, y, _ = thing.data.vertices[loop.vertex_index].co
        where.uv = (x * 0.25 + 0.1, y * 0.25 + 0.3)


def room(folder):
    """All kinds of light together, and what the walls send on; the camera looks around a corner."""
    add_box("walls", (6.0, 7.0, 3.0), paint("light"), (0.0, 0.0, 1.5), inwards=True)
    carpet = add_rectangle("carpet", 5.0, 6.0, checkered("carpet"), (0.0, 0.0, 0.01))
    give_texture_coordinates(carpet)
    add_box("cupboard", (0.6, 2.0, 1.9), paint("red"), (-2.4, 1.0, 0.95))
    add_box("table", (1.6, 0.9, 0.75), paint("blue"), (0.6, 1.2, 0.375), (0.0, 0.0, 25.0))
    add_light("POINT", 60.0, (1.8, 2.2, 2.2), colour=(1.0, 0.8, 0.6))
    light = add_light("SPOT", 150.0, (-1.0, -1.5, 2.8), (25.0, 0.0, 20.0), (0.8, 0.9, 1.0))
    light.spot_size, light.spot_blend = math.radians(80.0), 0.3
    add_rectangle(
        "ceiling lamp", 1.2, 0.6, emitter("lamp", (1.0, 0.95, 0.9), 6.0), (0.3, 0.0, 2.98),
        (180.0, 0.0, 0.0),
    )
    add_camera((1.8, -3.0, 1.7), (-0.2, 1.0, 1.0), lens_mm=20.0, roll_deg=7.0)
    return []


def camera(folder):
    """A tall picture, from a camera that is rolled and looks down, with its lens set by height."""
    add_table_top()
    add_light("SUN", 2.0, (0.0, 0.0, 5.0), (30.0, -20.0, 0.0))
    set_world((0.5, 0.5, 0.5), 0.5)
    lens = add_camera((2.0, -3.5, 3.5), (0.0, 0.5, 0.6), lens_mm=30.0, roll_deg=-20.0)
    lens.sensor_fit, lens.sensor_height = "VERTICAL", 24.0
    bpy.context.scene.render.resolution_x = 160
    bpy.context.scene.render.resolution_y = 224
    return ["--environment", "0.25,0.25,0.25"]


def add_sphere(name, radius, material, location):
    mesh = bpy.data.meshes.new(name)
    shape = bmesh.new()
    bmesh.ops.create_uvsphere(shape, u_segments=64, v_segments=32, radius=radius)
    shape.to_mesh(mesh)
    shape.free()
    for face in mesh.polygons:
        face.use_smooth = True
    mesh.materials.append(material)
    link(name, mesh, location)


def add_socket(group, kind, name, in_out):
    """in_out: "INPUT" or "OUTPUT" of a node group."""
    if bpy.app.version < (4, 0):
        (group.inputs if in_out == "INPUT" else group.outputs).new(kind, name)
    else:
        group.interface.new_socket(name, in_out=in_out, socket_type=kind)


def add_thickness(material):
    """The node by which the exporter knows that a mesh bounds a volume."""
    group = bpy.data.node_groups.new("glTF Material Output", "ShaderNodeTree")
    add_socket(group, "NodeSocketFloat", "Thickness", "INPUT")
    group.nodes.new("NodeGroupInput")
    node = material.node_tree.nodes.new("ShaderNodeGroup")
    node.node_tree = group
    node.inputs["Thickness"].default_value = 1.0
    return material


def materials(folder):
    """What the eye judges: metal, glass with and without a thickness, a coat, and plastic."""
    add_rectangle("floor", 12.0, 12.0, paint("grey"), (0.0, 0.0, 0.0))
    red = (0.6, 0.05, 0.03, 1.0)
    glass = {"Base_Color": (1.0, 1.0, 1.0, 1.0), "Transmission": 1.0, "Roughness": 0.0}
    kinds = [
        principled("gold", Base_Color=(1.0, 0.75, 0.3, 1.0), Metallic=1.0, Roughness=0.15),
        principled("steel", Base_Color=(0.6, 0.6, 0.6, 1.0), Metallic=1.0, Roughness=0.5),
        principled("thin glass", **glass),
        add_thickness(principled("solid glass", **glass)),
        principled("lacquer", Base_Color=red, Roughness=0.6, Clearcoat=1.0),
        principled("smooth plastic", Base_Color=(0.05, 0.2, 0.5, 1.0), Roughness=0.1),
        principled("rough plastic", Base_Color=(0.1, 0.4, 0.1, 1.0), Roughness=0.6),
    ]
    for i, material in enumerate(kinds):
        add_sphere(material.name, 0.5, material, (1.1 * (i - 3), 0.0, 0.5))
    lamp = emitter("lamp", (1.0, 0.9, 0.8), 20.0)
    add_rectangle("lamp", 1.5, 1.0, lamp, (-1.0, -2.0, 4.0), (200.0, 0.0, 0.0))
    add_camera((0.0, -7.0, 1.6), (0.0, 0.0, 0.5))
    return sky_of_blender(folder, 0.6)


LAMBERTIAN = {
    function.__name__.replace("_", "-"): function
    for function in (sun, point, spot, area, emission, world_colour, world_image, camera, room)
}

PRINCIPLED = {"materials": materials}

# Those with nothing but the exporter's lights, and how many times too bright "Raw" makes them.
WITH_LIGHTS = {"sun": 1.0, "point": 4.0 * math.pi, "spot": 4.0 * math.pi}
