"""Shows Blender's scene in Foveola's live preview, and shows it again whenever it changes.

A panel in the 3D view's sidebar starts `foveola preview` beside Blender. What Blender's glTF exporter
writes is completed with what it leaves out: the sizes of lights, area lights, the world and the active
camera; what still does not come across is listed. README.md beside this says how to install it.
"""

import array
import atexit
import contextlib
import functools
import hashlib
import importlib.util
import io
import json
import math
import os
import pathlib
import shutil
import struct
import subprocess
import tempfile
import textwrap
import time

import bpy
from bpy.app.handlers import persistent
from mathutils import Matrix, Vector

bl_info = {
    "name": "Foveola Preview",
    "description": "A live, path-traced preview by Foveola beside Blender",
    "author": "The makers of Foveola",
    "version": (1, 0, 0),
    "blender": (3, 4, 0),
    "location": "3D View > Sidebar > Foveola",
    "category": "Render",
}

DEBOUNCE_S = 0.2  # a scene is exported when it has not changed for so long
TICK_S = 0.05
MOST_LINES = 10  # of what does not come across, in the panel
MODES_WITH_DATA = {"OBJECT", "POSE", "PAINT_VERTEX", "PAINT_WEIGHT", "PAINT_TEXTURE"}


class ExportError(Exception):
    """A failure, in one line for the panel."""


# ---- Nodes -------------------------------------------------------------------------------------


def link_into(socket):
    """The socket whose value this one takes, through reroutes; None if it has a value of its own."""
    while socket.is_linked:
        source = socket.links[0].from_socket
        if source.node.type != "REROUTE":
            return source
        socket = source.node.inputs[0]
    return None


def nodes_above(sockets):
    """All nodes that the values of these sockets depend on, those of groups left out."""
    found, waiting = {}, list(sockets)
    while waiting:
        source = link_into(waiting.pop())
        if source is not None and source.node.name not in found:
            found[source.node.name] = source.node
            waiting.extend(source.node.inputs)
    return list(found.values())


def label_of(node):
    is_group = node.type == "GROUP" and node.node_tree is not None
    return f"node group {node.node_tree.name}" if is_group else node.bl_label


def constant(socket):
    """The socket's value, and whether it is all there is: a value node counts, a texture does not."""
    source = link_into(socket)
    if source is not None and source.node.type in {"RGB", "VALUE"}:
        return source.default_value, True
    return socket.default_value, source is None


def surface_of(tree, target="CYCLES"):
    """The node that the active output shows; None if there is none."""
    output = tree.get_output_node(target) if tree is not None else None
    source = link_into(output.inputs["Surface"]) if output is not None else None
    return source.node if source is not None and not source.node.mute else None


def has_volume(tree):
    output = tree.get_output_node("CYCLES")
    return output is not None and output.inputs["Volume"].is_linked


# ---- Units and directions: Blender's +Z is up, glTF's +Y ---------------------------------------


def to_gltf(vector):
    return [vector[0], vector[2], -vector[1]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(vector):
    length = math.sqrt(dot(vector, vector))
    if length == 0.0:
        raise ExportError("the object has a scale of zero and thus no direction; give it a size")
    return [value / length for value in vector]


def power_of(light):
    """Its linear colour in W (of suns, W/m^2), and whether its nodes are all in that."""
    power = [max(0.0, light.energy * channel) for channel in light.color]
    if not light.use_nodes:
        return power, True
    surface = surface_of(light.node_tree, "ALL")
    if surface is None or surface.type != "EMISSION":
        return power, False
    colour, colour_is_all = constant(surface.inputs["Color"])
    strength, strength_is_all = constant(surface.inputs["Strength"])
    return (
        [max(0.0, value * channel * strength) for value, channel in zip(power, colour)],
        colour_is_all and strength_is_all,
    )


# ---- What Cycles renders -----------------------------------------------------------------------


def rendered_in(place):
    """The objects that Cycles renders of an instanced collection, or of a layer collection. A
    collection that is disabled in renders disables all collections below it."""
    collection = getattr(place, "collection", place)
    if collection.hide_render:
        return set()
    things = [] if getattr(place, "exclude", False) else collection.objects
    found = {thing for thing in things if not thing.hide_render}
    return found.union(*(rendered_in(child) for child in place.children))


def instanced_by(thing):
    """The collection that an object instances; None if it instances none."""
    return thing.instance_collection if thing.instance_type == "COLLECTION" else None


class RenderedTree:
    """A hook in Blender's exporter. Leaves in its tree of nodes what Cycles renders, and notes area
    lights, which it does not write, and objects that the tree lacks."""

    def __init__(self, view_layer):
        self.is_complete = False
        self.area_lights = []  # (name, light, pose)
        self.left_out = []
        self._view_layer = view_layer
        self._rendered_in = functools.cache(rendered_in)

    def gather_tree_filter_tag_hook(self, tree, _settings):
        members = {}
        for node in tree.nodes.values():
            thing, instancer = node.blender_object, instancer_above(tree, node)
            is_hidden_emitter = thing.particle_systems and not thing.show_instancer_for_render
            node.keep_tag = node.keep_tag and self._is_rendered(tree, node) and not is_hidden_emitter
            members.setdefault(instancer, set()).add(thing)
            if node.keep_tag and instanced_by(thing) is not None:
                members.setdefault(node, set())
            if node.keep_tag and thing.type == "LIGHT" and thing.data.type == "AREA":
                if not getattr(getattr(thing.data, "cycles", None), "is_portal", False):
                    self.area_lights.append((thing.name, thing.data, pose_in(tree, node)))
        for instancer, things in members.items():
            if instancer is None or instancer.keep_tag:
                self._note_left_out(instancer, things)
        self.is_complete = True

    def _rendered_with(self, instancer):
        place = self._view_layer.layer_collection
        if instancer is not None:
            place = instanced_by(instancer.blender_object)
        return self._rendered_in(place)

    def _is_rendered(self, tree, node):
        instancer = instancer_above(tree, node)
        return node.blender_object in self._rendered_with(instancer) and (
            instancer is None or self._is_rendered(tree, instancer)
        )

    def _note_left_out(self, instancer, things):
        for thing in self._rendered_with(instancer) - things:
            is_seen = thing.type in SHOWN_TYPES or instanced_by(thing) is not None
            if is_seen and (instancer or thing.visible_get(view_layer=self._view_layer)):
                self.left_out.append(thing.name)


def instancer_above(tree, node):
    """The node of the collection's instance that a node is in; None outside of all."""
    while node.parent_uuid is not None:
        node = tree.nodes[node.parent_uuid]
        if instanced_by(node.blender_object) is not None:
            return node
    return None


def pose_in(tree, node):
    """An object's pose in the world. The exporter turns its own of lights, and leaves out offsets."""
    parent = tree.nodes.get(node.parent_uuid)
    if parent is not None and parent.blender_object.instance_type in {"VERTS", "FACES"}:
        return node.matrix_world.copy()
    instancer = instancer_above(tree, node)
    pose = node.blender_object.matrix_world.copy()
    if instancer is None:
        return pose
    offset = instanced_by(instancer.blender_object).instance_offset
    return pose_in(tree, instancer) @ Matrix.Translation(-offset) @ pose


# ---- The descriptor: what Foveola reads beside the file, see scenes/DESCRIPTORS.md -------------


def text_of(value):
    """As TOML writes it; what JSON leaves as it is and TOML does not allow is DEL."""
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, list):
        return "[" + ", ".join(text_of(element) for element in value) + "]"
    return repr(float(value))


def camera_keys(scene, depsgraph):
    camera = scene.camera
    if camera is None or camera.type != "CAMERA":
        raise ExportError("the scene has no active camera; add one (Shift A, Camera)")
    pose = camera.evaluated_get(depsgraph).matrix_world
    forward = unit(to_gltf([-value for value in pose.col[2][:3]]))
    right = unit(to_gltf(pose.col[0]))
    level = math.hypot(forward[0], forward[2])
    azimuth = math.atan2(forward[0], -forward[2]) if level > 1e-6 else 0.0
    level_right = [math.cos(azimuth), 0.0, math.sin(azimuth)]
    level_up = cross(level_right, forward)
    roll = math.atan2(-dot(right, level_up), dot(right, level_right))
    keys = {
        "position": to_gltf(pose.col[3]),
        "azimuth_deg": math.degrees(azimuth),
        "elevation_deg": math.degrees(math.atan2(forward[1], level)),
        "roll_deg": math.degrees(roll),
    }
    if camera.data.type == "PERSP":
        keys.update(picture_keys(camera.data, scene))
    return keys


def picture_keys(camera, scene):
    right_up, _, left_down, _ = camera.view_frame(scene=scene)
    width, height = right_up.x - left_down.x, right_up.y - left_down.y
    fov_deg = math.degrees(2.0 * math.atan2(0.5 * height, -right_up.z))
    return {
        "vertical_fov_deg": min(max(fov_deg, 0.001), 179.99),
        "aspect_ratio": min(max(width / height, 0.001), 1000.0),
    }


def world_keys(scene, folder):
    """The descriptor's keys of the world, and what of it does not come across. Writes its image."""
    world = scene.world
    if world is None:
        return {"environment_radiance": [0.0, 0.0, 0.0]}, []
    if not world.use_nodes:
        return {"environment_radiance": list(world.color)}, []
    surface = surface_of(world.node_tree)
    missing = ["its volume is not sent"] if has_volume(world.node_tree) else []
    if surface is None:
        return {"environment_radiance": [0.0, 0.0, 0.0]}, missing
    if surface.type != "BACKGROUND":
        missing.append(f"{label_of(surface)} is not translated, only a Background above it")
        backgrounds = [node for node in nodes_above(surface.inputs) if node.type == "BACKGROUND"]
        if not backgrounds:
            return {"environment_radiance": [0.0, 0.0, 0.0]}, missing
        surface = backgrounds[0]
    strength, is_all = constant(surface.inputs["Strength"])
    if not is_all:
        missing.append("the nodes of its Strength are not translated")
    colour, is_all = constant(surface.inputs["Color"])
    if is_all:
        radiance = [max(0.0, strength * channel) for channel in list(colour)[:3]]
        return {"environment_radiance": radiance}, missing
    return textured_world(surface.inputs["Color"], max(0.0, strength), folder, missing)


def textured_world(socket, strength, folder, missing):
    """Blender shows the middle of the image at +X, Foveola at -Z, which is Blender's +Y."""
    texture = link_into(socket).node
    if texture.type != "TEX_ENVIRONMENT":
        missing.append(f"{label_of(texture)} is not translated, only an Environment Texture above it")
        textures = [node for node in nodes_above([socket]) if node.type == "TEX_ENVIRONMENT"]
        texture = textures[0] if textures else None
    if texture is None or texture.image is None:
        missing.append("its colour is shown black")
        return {"environment_radiance": [0.0, 0.0, 0.0]}, missing
    if texture.projection != "EQUIRECTANGULAR":
        missing.append("its image is a mirror ball and is shown black")
        return {"environment_radiance": [0.0, 0.0, 0.0]}, missing
    try:
        name = environment_file(texture.image, folder)
    except ExportError as failure:
        missing.append(f"{failure}; it is shown black")
        return {"environment_radiance": [0.0, 0.0, 0.0]}, missing
    turn_deg, reason = turn_of(texture.inputs["Vector"])
    missing.extend(reason)
    return {
        "environment_file": name,
        "environment_rotation_deg": math.remainder(90.0 + turn_deg, 360.0),
        "environment_strength": strength,
    }, missing


def turn_of(socket):
    """By how many degrees the image turns about the vertical, clockwise as seen from above."""
    mapping = link_into(socket)
    if mapping is None or mapping.node.type == "TEX_COORD" and mapping.name == "Generated":
        return 0.0, []
    mapping = mapping.node
    if mapping.type != "MAPPING":
        return 0.0, [f"its image is not turned by {label_of(mapping)}"]
    inputs = {name: constant(mapping.inputs[name]) for name in ("Rotation", "Scale")}
    rotation, scale = (list(inputs[name][0]) for name in ("Rotation", "Scale"))
    location = list(mapping.inputs["Location"].default_value) if "Location" in mapping.inputs else []
    is_turn = not any(rotation[:2]) and scale == [1.0, 1.0, 1.0] and not any(location)
    turn_deg = math.degrees(rotation[2]) * (-1.0 if mapping.vector_type == "TEXTURE" else 1.0)
    if is_turn and all(is_all for _, is_all in inputs.values()):
        return turn_deg, []
    return turn_deg, ["of its Mapping only the rotation about Z is translated"]


# ---- The world's image -------------------------------------------------------------------------

SIGNATURES = {
    b"\x89PNG": ".png",
    b"\xff\xd8\xff": ".jpg",
    b"#?RADIANCE": ".hdr",
    b"#?RGBE": ".hdr",
    b"\x76\x2f\x31\x01": ".exr",
}
LINEAR = {"Linear", "Linear Rec.709", "Non-Color", "Raw"}


def extension_of(start):
    """The extension of a file that begins so, of those that Foveola reads; empty otherwise."""
    return next((name for mark, name in SIGNATURES.items() if start.startswith(mark)), "")


def means_the_same(image, extension):
    """Whether Foveola decodes the file as Blender does: .hdr and .exr linear, the others sRGB."""
    space = image.colorspace_settings.name
    return space in LINEAR if extension in {".hdr", ".exr"} else space == "sRGB"


def environment_file(image, folder):
    """Writes the image into the folder, unless it is there; returns its name, new for new content."""
    if image.source not in {"FILE", "GENERATED"}:
        raise ExportError(f"its image {image.name} is a sequence, a film or tiled")
    if not image.is_dirty and image.source == "FILE":
        name = copied_file(image, folder)
        if name:
            return name
    return written_pixels(image, folder)


def copied_file(image, folder):
    """The name of a copy of the image's own file; empty if Foveola does not read such a file."""
    if image.packed_file is not None:
        data = image.packed_file.data
        extension, key = extension_of(data[:16]), hashlib.sha1(data)
    else:
        path = pathlib.Path(bpy.path.abspath(image.filepath, library=image.library))
        try:
            with open(path, "rb") as file:
                extension, status = extension_of(file.read(16)), os.fstat(file.fileno())
        except OSError as failure:
            raise ExportError(f"its image {path} cannot be read ({failure.strerror})") from failure
        key = hashlib.sha1(f"{path}|{status.st_mtime_ns}|{status.st_size}".encode())
    if not extension or not means_the_same(image, extension):
        return ""
    name = f"environment-{key.hexdigest()[:16]}{extension}"
    if not (folder / name).exists():
        if image.packed_file is not None:
            write_by_rename(folder / name, [data])
        else:
            shutil.copyfile(path, folder / (name + ".part"))
            os.replace(folder / (name + ".part"), folder / name)
    return name


def written_pixels(image, folder):
    """Pixels of 8 bits come in the image's own colour space, others linear."""
    width, height = image.size
    if width * height == 0:
        raise ExportError(f"its image {image.name} has no pixels")
    pixels = array.array("f", bytes(16 * width * height))
    image.pixels.foreach_get(pixels)
    is_encoded = not image.is_float and image.colorspace_settings.name == "sRGB"
    digest = hashlib.sha1(pixels)
    digest.update(bytes([is_encoded]))
    name = f"environment-{digest.hexdigest()[:16]}.exr"
    if not (folder / name).exists():
        if is_encoded:
            decoded = {value: linear_from_srgb(value) for value in set(pixels)}
            pixels = array.array("f", [decoded[value] for value in pixels])
        write_by_rename(folder / name, exr_parts(width, height, pixels))
    return name


def linear_from_srgb(value):
    """IEC 61966-2-1."""
    return value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4


def exr_parts(width, height, rgba):
    """An OpenEXR file of floats without compression. rgba: the lowest row first, as Blender has it."""

    def attribute(name, kind, data):
        return name + b"\0" + kind + b"\0" + struct.pack("<i", len(data)) + data

    channels = b"".join(name + b"\0" + struct.pack("<iiii", 2, 0, 1, 1) for name in (b"B", b"G", b"R"))
    window = struct.pack("<iiii", 0, 0, width - 1, height - 1)
    header = b"".join([
        struct.pack("<ii", 20000630, 2),
        attribute(b"channels", b"chlist", channels + b"\0"),
        attribute(b"compression", b"compression", b"\0"),
        attribute(b"dataWindow", b"box2i", window),
        attribute(b"displayWindow", b"box2i", window),
        attribute(b"lineOrder", b"lineOrder", b"\0"),
        attribute(b"pixelAspectRatio", b"float", struct.pack("<f", 1.0)),
        attribute(b"screenWindowCenter", b"v2f", struct.pack("<ff", 0.0, 0.0)),
        attribute(b"screenWindowWidth", b"float", struct.pack("<f", 1.0)),
        b"\0",
    ])
    row_bytes = 8 + 12 * width
    first = len(header) + 8 * height
    parts = [header, struct.pack(f"<{height}Q", *(first + y * row_bytes for y in range(height)))]
    for y in range(height):
        row = rgba[4 * width * (height - 1 - y) : 4 * width * (height - y)]
        parts.append(struct.pack("<ii", y, 12 * width))
        parts.extend(row[channel::4].tobytes() for channel in (2, 1, 0))
    return parts


def write_by_rename(path, parts):
    """Whoever watches the file sees it whole."""
    unfinished = path.with_name(path.name + ".part")
    with open(unfinished, "wb") as file:
        file.writelines(parts)
    os.replace(unfinished, path)


# ---- The .glb: completed after Blender's exporter has written it -------------------------------


class Glb:
    """A binary glTF file: its document, its geometry, and what is added to that. Large scenes are
    copied as seldom as possible."""

    def __init__(self, data):
        length = struct.unpack_from("<I", data, 12)[0]
        self.document = json.loads(data[20 : 20 + length])
        self.geometry = memoryview(data)[28 + length :]  # whole words, by the specification
        self.added = bytearray()

    def binary_length(self):
        return len(self.geometry) + len(self.added)

    def parts(self):
        """The file, in pieces."""
        self.added.extend(b"\0" * (-len(self.added) % 4))
        length = self.binary_length()
        if length > 0:
            self.document["buffers"][0]["byteLength"] = length
        text = json.dumps(self.document, ensure_ascii=False, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        start = struct.pack("<II", len(text), 0x4E4F534A) + text
        start += struct.pack("<II", length, 0x004E4942) if length > 0 else b""
        header = struct.pack("<III", 0x46546C67, 2, 12 + len(start) + length)
        return [header + start, self.geometry, self.added]

    def add(self, array_name, element):
        elements = self.document.setdefault(array_name, [])
        elements.append(element)
        return len(elements) - 1

    def use_extension(self, name):
        used = self.document.setdefault("extensionsUsed", [])
        if name not in used:
            used.append(name)

    def add_accessor(self, data, **properties):
        self.document.setdefault("buffers", [{"byteLength": 0}])
        self.added.extend(b"\0" * (-len(self.added) % 4))
        view = {"buffer": 0, "byteOffset": self.binary_length(), "byteLength": len(data)}
        self.added.extend(data)
        return self.add("accessors", {"bufferView": self.add("bufferViews", view), **properties})


def complete_lights(glb):
    """Every light's own power, by the nodes it has, and its size, which glTF has no word for."""
    extension = glb.document.get("extensions", {}).get("KHR_lights_punctual", {})
    for entry in extension.get("lights", []):
        light = bpy.data.lights.get(entry["name"])
        power, _ = power_of(light)
        brightest = max(power)
        per_watt = 1.0 if light.type == "SUN" else 1.0 / (4.0 * math.pi)
        entry["color"] = [value / brightest for value in power] if brightest > 0.0 else [1, 1, 1]
        entry["intensity"] = brightest * per_watt
        entry.pop("range", None)  # Eevee's: Cycles has none
        if light.type == "SUN":
            size = {"angular_radius_rad": min(0.5 * light.angle, math.pi / 4.0)}
        else:
            size = {"radius_m": light.shadow_soft_size}
        entry.setdefault("extras", {})["foveola"] = size


def complete_materials(glb):
    """What Cycles shows, where the exporter goes by Eevee's settings, or by none."""
    for entry in glb.document.get("materials", []):
        material = bpy.data.materials.get(entry.get("name", ""))
        if material is None:
            continue
        entry["doubleSided"] = True
        surface = surface_of(material.node_tree) if material.use_nodes else None
        if surface is not None and surface.type not in {"BSDF_PRINCIPLED", "EMISSION"}:
            continue
        entry.pop("alphaCutoff", None)
        entry["alphaMode"] = "OPAQUE"
        if not material.use_nodes:
            make_lambertian(glb, entry, material.diffuse_color[:3])
        elif surface is None and has_volume(material.node_tree):
            make_lambertian(glb, entry, [0, 0, 0], alpha=0)
            entry["alphaMode"] = "BLEND"
        elif surface is None or surface.type == "EMISSION":
            make_lambertian(glb, entry, [0, 0, 0])
        else:
            alpha, is_all = constant(surface.inputs["Alpha"])
            if alpha < 1.0 or not is_all:
                entry["alphaMode"] = "BLEND"


def make_lambertian(glb, entry, colour, alpha=1):
    entry["pbrMetallicRoughness"] = {
        "baseColorFactor": [*colour, alpha], "metallicFactor": 0, "roughnessFactor": 1,
    }
    entry.setdefault("extensions", {})["KHR_materials_specular"] = {"specularFactor": 0}
    glb.use_extension("KHR_materials_specular")


def complete_surfaces(glb):
    """Cycles' surface without a material is Lambertian, of 0.8, and only nodes show colour attributes."""
    default = None
    for mesh in glb.document.get("meshes", []):
        data = bpy.data.meshes.get(mesh.get("name", ""))
        for primitive in mesh["primitives"]:
            if "material" not in primitive:
                if default is None:
                    entry = {"name": "no material", "doubleSided": True}
                    make_lambertian(glb, entry, [0.8, 0.8, 0.8])
                    default = glb.add("materials", entry)
                primitive["material"] = default
            name = glb.document["materials"][primitive["material"]].get("name", "")
            asked = colours_of(bpy.data.materials.get(name))
            if not asked & {"", render_colour_of(data)}:
                primitive["attributes"].pop("COLOR_0", None)


def colours_of(material):
    """The names of the colour attributes that the base colour takes, empty for that of rendering."""
    surface = surface_of(material.node_tree) if material is not None and material.use_nodes else None
    if surface is None or surface.type != "BSDF_PRINCIPLED":
        return set()
    above = nodes_above([surface.inputs["Base Color"]])
    return {node.layer_name for node in above if node.type == "VERTEX_COLOR"}


def render_colour_of(mesh):
    """The name of the colour attribute that the exporter writes; empty if there is none."""
    colours = mesh.color_attributes if mesh is not None else []
    index = colours.render_color_index if colours else -1
    return colours[index].name if 0 <= index < len(colours) else ""


def outline_of(light, pose):
    """Corners around the light's middle, in glTF's directions, and its area. Cycles' ellipse is a
    polygon of the same area here."""
    is_round = light.shape in {"DISK", "ELLIPSE"}
    size_y = light.size_y if light.shape in {"RECTANGLE", "ELLIPSE"} else light.size
    u = [light.size * value for value in to_gltf(pose.col[0])]
    v = [size_y * value for value in to_gltf(pose.col[1])]
    area = math.sqrt(dot(u, u)) * math.sqrt(dot(v, v))
    corners = [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)]
    if is_round:
        count = 64
        step = 2.0 * math.pi / count
        radius = 0.5 * math.sqrt(step / math.sin(step))
        corners = [(radius * math.cos(i * step), radius * math.sin(i * step)) for i in range(count)]
        area *= math.pi / 4.0
    shining = to_gltf([-value for value in pose.col[2][:3]])
    if dot(cross(u, v), shining) < 0.0:
        corners.reverse()  # a front is counter-clockwise
    return [[x * a + y * b for a, b in zip(u, v)] for x, y in corners], area


def add_area_light(glb, name, light, pose):
    """Cycles' area lights emit to one side. Their radiance is power / (pi area), as of a Lambertian
    emitter; before Blender 4.0 it is power / (4 area)."""
    power, _ = power_of(light)
    corners, area = outline_of(light, pose)
    solid_angle_sr = 4.0 if bpy.app.version < (4, 0) else math.pi
    radiance = [value / (solid_angle_sr * area) for value in power] if area > 0.0 else [0.0]
    brightest = max(radiance)
    if brightest <= 0.0:
        return
    material = {
        "name": name,
        "emissiveFactor": [value / brightest for value in radiance],
        "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": brightest}},
    }
    glb.use_extension("KHR_materials_emissive_strength")
    make_lambertian(glb, material, [0, 0, 0])
    fan = [index for i in range(1, len(corners) - 1) for index in (0, i, i + 1)]
    values = array.array("f", [value for corner in corners for value in corner])
    axes = [values[axis::3] for axis in range(3)]
    position = glb.add_accessor(
        values.tobytes(), componentType=5126, count=len(corners), type="VEC3",
        min=[min(axis) for axis in axes], max=[max(axis) for axis in axes],
    )
    indices = glb.add_accessor(
        struct.pack(f"<{len(fan)}H", *fan), componentType=5123, count=len(fan), type="SCALAR"
    )
    primitive = {
        "attributes": {"POSITION": position}, "indices": indices,
        "material": glb.add("materials", material),
    }
    mesh = glb.add("meshes", {"name": name, "primitives": [primitive]})
    node = {"name": name, "mesh": mesh, "translation": to_gltf(pose.col[3])}
    scenes = glb.document.setdefault("scenes", [{}])
    scene = scenes[glb.document.setdefault("scene", 0)]
    scene.setdefault("nodes", []).append(glb.add("nodes", node))


# ---- What does not come across -----------------------------------------------------------------

UNSENT_TYPES = {
    "META": "metaballs", "CURVES": "hair curves", "POINTCLOUD": "point clouds",
    "VOLUME": "volumes", "GPENCIL": "grease pencil", "GREASEPENCIL": "grease pencil",
}
SHOWN_TYPES = {"MESH", "CURVE", "SURFACE", "FONT", "LIGHT", *UNSENT_TYPES}
TRANSLATED_NODES = {"RGB", "VALUE", "UVMAP"}
SEPARATING_NODES = {"SEPRGB", "SEPARATE_COLOR"}
UNSENT_INPUTS = (
    "Subsurface", "Subsurface Weight", "Anisotropic", "Sheen", "Transmission Roughness",
)


def missing_lines(scene, view_layer, depsgraph):
    """A line for each thing that the preview shows otherwise than Cycles, without repetition."""
    lines = missing_of_scene(scene, view_layer)
    lines += collection_lines(view_layer.layer_collection)
    shown_materials, shown_surfaces = {}, {}
    for thing, is_visible in rendered_things(view_layer):
        if not is_visible:
            lines.append(f"{thing.name}: rendered, but hidden in the viewport, and not sent")
            continue
        lines += [f"{thing.name}: {what}" for what in missing_of_object(thing)]
        for slot in thing.material_slots:
            if slot.material is not None:
                shown_materials.setdefault(slot.material, thing.name)
                shown_surfaces.setdefault((thing.data, slot.material), thing.name)
    for material, user in shown_materials.items():
        lines += [f"{user}, material {material.name}: {what}" for what in missing_of_material(material)]
    for (data, material), user in shown_surfaces.items():
        lines += [f"{user}, material {material.name}: {what}"
                  for what in missing_of_mesh(data, material)]
    lines += instancer_lines(view_layer, depsgraph)
    lines += [f"{scene.camera.name}: {what}" for what in missing_of_camera(scene.camera.data)]
    if is_clipped(scene.camera, view_layer):
        lines.append(f"{scene.camera.name}: its clipping is not sent")
    return list(dict.fromkeys(lines))


def missing_of_scene(scene, view_layer):
    render, cycles = scene.render, getattr(scene, "cycles", None)
    filters = ("use_sky", "use_solid", "use_strand", "use_volumes")
    unsent = {
        "the background set": scene.background_set is not None,
        "the material override": view_layer.material_override is not None,
        "the view layer's filter": not all(getattr(view_layer, name, True) for name in filters),
        "Simplify": render.use_simplify,
        "the transparent film": render.film_transparent,
        "motion blur": render.use_motion_blur,
        "the render region": render.use_border,
        "the film's exposure": cycles is not None and cycles.film_exposure != 1.0,
    }
    lines = [f"Scene: {what} is not sent" for what, is_used in unsent.items() if is_used]
    rays = getattr(scene.world, "cycles_visibility", None)
    names = ("camera", "diffuse", "glossy", "transmission", "scatter")
    if not all(getattr(rays, name, True) for name in names):
        lines.append("World: seen by all rays, in spite of its ray visibility")
    return lines


def collection_lines(layer):
    """Of a layer collection and those below it."""
    lines = [f"Collection {layer.name}: seen by all rays, in spite of {name}"
             for name, is_on in (("its holdout", layer.holdout), ("indirect only", layer.indirect_only))
             if is_on and not layer.exclude]
    return lines + [line for child in layer.children for line in collection_lines(child)]


def rendered_things(view_layer):
    """(object, whether it is visible in the viewport), those of instanced collections among them."""
    rendered = rendered_in(view_layer.layer_collection)
    for thing in view_layer.objects:
        is_visible = thing.visible_get(view_layer=view_layer)
        if thing in rendered and thing.type in SHOWN_TYPES:
            yield thing, is_visible
        elif thing in rendered and is_visible:
            yield from ((part, True) for part in parts_of(thing))


def parts_of(thing):
    """What an instance of a collection shows."""
    collection = instanced_by(thing)
    rendered = rendered_in(collection) if collection is not None else set()
    for part in collection.all_objects if rendered else []:
        if part in rendered and part.type in SHOWN_TYPES:
            yield part
        elif part in rendered:
            yield from parts_of(part)


def missing_of_object(thing):
    lines = []
    # New lights are shadow catchers that no camera sees. README.md says how lights are seen.
    is_light = thing.type == "LIGHT"
    names = RAY_VISIBILITY[1:] if is_light else RAY_VISIBILITY
    is_caught = getattr(thing, "is_holdout", False) or getattr(thing, "is_shadow_catcher", False)
    if not all(getattr(thing, name, True) for name in names) or is_caught and not is_light:
        lines.append("seen by all rays, in spite of its ray visibility")
    if thing.type in UNSENT_TYPES:
        return [f"{UNSENT_TYPES[thing.type]} are not sent"]
    if thing.type == "LIGHT":
        return lines + missing_of_light(thing.data)
    lines += [
        f"{'hair' if system.settings.type == 'HAIR' else 'particles'} '{system.name}' not sent"
        for system in thing.particle_systems
    ]
    lines += [f"modifier {modifier.name} is applied as in the viewport, not as rendered"
              for modifier in thing.modifiers if is_rendered_otherwise(modifier)]
    if getattr(getattr(thing, "cycles", None), "use_adaptive_subdivision", False):
        lines.append("its adaptive subdivision is not sent")
    return lines + missing_of_shape(thing)


RAY_VISIBILITY = (
    "visible_camera", "visible_diffuse", "visible_glossy", "visible_transmission",
    "visible_volume_scatter", "visible_shadow",
)
VIEWPORT_AND_RENDER = (
    ("levels", "render_levels"), ("steps", "render_steps"), ("viewport_resolution", "resolution"),
)


def is_rendered_otherwise(modifier):
    if not modifier.show_viewport and not modifier.show_render:
        return False
    return modifier.show_viewport != modifier.show_render or any(
        getattr(modifier, viewport, 0) != getattr(modifier, render, 0)
        for viewport, render in VIEWPORT_AND_RENDER if hasattr(modifier, viewport)
    )


def missing_of_shape(thing):
    lines, data = [], thing.data
    for axis in "uv":
        rendered = getattr(data, f"render_resolution_{axis}", 0)
        if rendered not in {0, getattr(data, f"resolution_{axis}", 0)}:
            lines.append("its resolution is that of the viewport, not of rendering")
    materials = [slot.material for slot in thing.material_slots]
    if thing.type != "MESH" and None in materials and any(materials):
        lines.append("its materials are those of other slots, since one is empty")
    if thing.parent is not None and thing.parent_type in {"ARMATURE", "LATTICE"}:
        lines.append("its parent's deformation is not sent; use a modifier")
    keys = getattr(data, "shape_keys", None)
    if keys is not None and not thing.modifiers and (
        not keys.use_relative or thing.show_only_shape_key
        or any(key.mute or key.vertex_group or key.relative_key != keys.reference_key
               for key in keys.key_blocks[1:])
    ):
        lines.append("its muted, pinned or grouped shape keys are sent otherwise; add any modifier")
    x, y, z = (axis.normalized() for axis in thing.matrix_world.to_3x3().col)
    if max(abs(x.dot(y)), abs(y.dot(z)), abs(z.dot(x))) > 1e-4:
        lines.append("its shear is not sent; apply its parent's scale")
    return lines


def is_clipped(camera, view_layer):
    """Whether Cycles cuts off what the preview shows, in front or behind."""
    if camera.data.clip_start > 0.1 + 1e-6:  # Blender's default
        return True
    from_world = camera.matrix_world.inverted_safe()
    return any(
        -(from_world @ thing.matrix_world @ Vector(corner)).z > camera.data.clip_end
        for thing in rendered_in(view_layer.layer_collection)
        if thing.type in {"MESH", "CURVE", "SURFACE", "FONT"}
        for corner in thing.bound_box
    )


def casts_shadows(light):
    """By Cycles' own setting, which Blender 4.2 joined with the light's."""
    cycles = getattr(light, "cycles", None)
    return getattr(cycles, "cast_shadow", True if cycles is None else light.use_shadow)


def missing_of_light(light):
    lines = []
    if not power_of(light)[1]:
        lines.append("its nodes are translated as far as their constant values")
    if light.type == "AREA" and light.spread < math.pi - 1e-3:
        lines.append("its spread is not sent: it emits to its whole front")
    if light.type == "SUN" and light.angle > math.pi / 2.0:
        lines.append("its angle is limited to 90 degrees")
    if not casts_shadows(light):
        lines.append("it casts shadows")
    return lines


def missing_of_camera(camera):
    lines = []
    if camera.type != "PERSP":
        lines.append(f"a camera of type {camera.type} is shown in perspective")
    if camera.shift_x or camera.shift_y:
        lines.append("its shift is not sent")
    if camera.dof.use_dof:
        lines.append("its depth of field is not sent")
    return lines


def missing_of_mesh(mesh, material):
    """What of a material does not come across on this mesh; nothing on other data."""
    surface = surface_of(material.node_tree) if material.use_nodes else None
    if not isinstance(mesh, bpy.types.Mesh) or surface is None:
        return []
    lines = [
        f"Base Color: the colour attribute {name} is not sent, only the mesh's own for rendering"
        for name in sorted(colours_of(material))
        if not render_colour_of(mesh) or name not in {"", render_colour_of(mesh)}
    ]
    above = nodes_above(surface.inputs)
    if not mesh.uv_layers and any(node.type == "TEX_IMAGE" for node in above):
        lines.append("its textures are not sent, since the mesh has no UV map")
    return lines


def missing_of_material(material):
    if not material.use_nodes:
        return []
    surface = surface_of(material.node_tree)
    output = material.node_tree.get_output_node("CYCLES")
    if output is None:
        return []
    lines = [f"its {name.lower()} is not sent" for name in ("Volume", "Displacement")
             if output.inputs[name].is_linked]
    if not output.is_active_output:
        lines.append("its output for Eevee is sent, not that for Cycles")
    if surface is None:
        return lines
    if surface.type not in {"BSDF_PRINCIPLED", "EMISSION"}:
        lines.append(f"{label_of(surface)} is not translated, only a Principled BSDF above it")
        return lines
    for socket in surface.inputs:
        faults = [fault_of(node, socket, material) for node in nodes_above([socket])]
        faults = [fault for fault in faults if fault]
        if faults:
            lines.append(f"{socket.name}: {faults[-1]}")
        elif socket.name in UNSENT_INPUTS and (socket.is_linked or socket.default_value > 0.0):
            lines.append(f"{socket.name} is not sent")
        elif socket.name == "Base Color" and max(constant(socket)[0][:3]) > 1.0:
            lines.append("Base Color is limited to 1")
    return lines


def fault_of(node, socket, material):
    """How a node above a socket is shown otherwise than by Cycles; empty if it is not."""
    if node.type == "TEX_IMAGE" and not node.mute:
        return fault_of_image(node, socket)
    if node.type == "UVMAP" and node.uv_map:
        places = {mesh.uv_layers.find(node.uv_map)
                  for mesh in bpy.data.meshes if material in mesh.materials[:]}
        if len(places) != 1 or -1 in places:
            return f"UV map {node.uv_map} has not the same place in all of the material's meshes"
    return "" if is_translated(node, socket) else f"{label_of(node)} is not translated"


def fault_of_image(node, socket):
    image = node.image
    if image is None or 0 in image.size:
        return "its image is missing"
    if image.source not in {"FILE", "GENERATED"}:
        return f"image {image.name} is a sequence, a film or tiled"
    if node.projection != "FLAT" or node.extension == "CLIP":
        return f"{label_of(node)} is shown flat and repeated"
    wanted = "sRGB" if socket.type == "RGBA" else "Non-Color"
    space = image.colorspace_settings.name
    if socket.name == "Alpha" or space == wanted or (wanted != "sRGB" and space in LINEAR):
        return ""
    return f"image {image.name} is read as {wanted}, not {space}"


def is_translated(node, socket):
    """Whether the exporter writes what this node does above the socket."""
    if node.mute:
        return False
    if node.type == "TEX_COORD":
        return not any(output.is_linked for output in node.outputs if output.name != "UV")
    if node.type == "MAPPING":
        has_links = any(value.is_linked for value in node.inputs if value.name != "Vector")
        turn = node.inputs["Rotation"].default_value
        return node.vector_type != "NORMAL" and not has_links and not any(turn[:2])
    if node.type == "NORMAL_MAP":
        return node.space == "TANGENT" and not node.inputs["Strength"].is_linked
    if node.type == "VERTEX_COLOR":
        return socket.name in {"Base Color", "Alpha"}
    if node.type in SEPARATING_NODES:
        return socket.type == "VALUE"
    if node.type in {"MATH", "MIX"}:
        return link_into(socket).node == node and is_product(node)
    return node.type in TRANSLATED_NODES


def is_product(node):
    """Whether a node multiplies one texture by a constant or a colour attribute."""
    if node.type == "MATH":
        is_multiplying, factors = node.operation == "MULTIPLY", node.inputs[:2]
    else:
        factor, is_all = constant(node.inputs[0])
        is_multiplying = node.data_type == "RGBA" and node.blend_type == "MULTIPLY"
        is_multiplying, factors = is_multiplying and is_all and factor == 1.0, node.inputs[6:8]
    variables = [link_into(value).node.type for value in factors if not constant(value)[1]]
    return is_multiplying and (len(variables) == 1 or "VERTEX_COLOR" in variables)


def instancer_lines(view_layer, depsgraph):
    """The exporter follows instances of collections, vertices and faces, but not of geometry nodes."""
    suspects = {
        thing for thing in view_layer.objects
        if any(modifier.type == "NODES" for modifier in thing.modifiers)
    }
    if not suspects:
        return []
    instancing = {
        instance.parent.original for instance in depsgraph.object_instances if instance.is_instance
    }
    return [f"{thing.name}: instances of its geometry nodes are not sent"
            for thing in suspects & instancing]


# ---- Export ------------------------------------------------------------------------------------

EXPORT_OPTIONS = {
    "export_format": "GLB",
    "use_visible": True,
    "use_active_scene": True,
    "export_cameras": True,
    "export_lights": True,
    "export_apply": True,
    "export_current_frame": True,
    "export_animations": False,
    "export_skins": False,  # then the pose is in the vertices
    "convert_lighting_mode": "COMPAT",  # in Blender 3.4
    "export_import_convert_lighting_mode": "COMPAT",  # the same in later versions
}


def require_exporter():
    if "gltf" not in dir(bpy.ops.export_scene):
        raise ExportError("enable the add-on 'glTF 2.0 format' in Edit > Preferences > Add-ons")
    if importlib.util.find_spec("numpy") is None:
        raise ExportError("Blender's glTF exporter needs NumPy: install Debian's python3-numpy")


def run_exporter(path, tree):
    known = bpy.ops.export_scene.gltf.get_rna_type().properties.keys()
    options = {key: value for key, value in EXPORT_OPTIONS.items() if key in known}
    with contextlib.redirect_stdout(io.StringIO()), hook_into_exporter(tree):
        try:
            bpy.ops.export_scene.gltf(filepath=str(path), **options)
        except RuntimeError as failure:
            lines = [line.strip() for line in str(failure).splitlines() if line.strip()]
            said = [line for line in lines if not line.startswith("Location:")]
            remedy = ""
            if "node_tree" in said[-1]:  # it looks for a UV map's name in all meshes
                remedy = "; remove the empty material slots of all meshes"
            raise ExportError(f"Blender's exporter: {said[-1]}{remedy}") from failure
    if not tree.is_complete:
        raise ExportError("Blender's exporter has another tree of nodes; use that of Blender 3.4")


@contextlib.contextmanager
def hook_into_exporter(hook):
    """The exporter calls this name in every add-on that has it. The user's own exports find none."""
    globals()["glTF2ExportUserExtension"] = lambda: hook
    try:
        yield
    finally:
        del globals()["glTF2ExportUserExtension"]


def descriptor_text(scene, depsgraph, world):
    keys = {"title": scene.name, "file": "scene.glb", **world}
    lines = [f"{key} = {text_of(value)}" for key, value in keys.items()]
    lines += ['light_units = "radiometric"', "", "[camera]"]
    lines += [f"{key} = {text_of(value)}" for key, value in camera_keys(scene, depsgraph).items()]
    return "\n".join(lines) + "\n"


def replace_if_new(path, parts):
    """Whether the file's content changed."""
    if has_content(path, parts):
        return False
    write_by_rename(path, parts)
    return True


def has_content(path, parts):
    if not path.exists() or path.stat().st_size != sum(len(part) for part in parts):
        return False
    with open(path, "rb") as file:
        return all(file.read(len(part)) == part for part in parts)


def export_scene(window, folder):
    """Writes scene.toml, then scene.glb, into the folder, each by a rename and only if it changed.
    Returns whether anything changed, and what does not come across. Raises ExportError; then the
    files are what they were."""
    require_exporter()
    scene, view_layer = window.scene, window.view_layer
    exported = folder / "exported.glb"
    try:
        # Without an active object the exporter does not leave the mode that the user is in.
        with bpy.context.temp_override(
            window=window, scene=scene, view_layer=view_layer, active_object=None
        ):
            depsgraph = bpy.context.evaluated_depsgraph_get()
            world, missing_of_world = world_keys(scene, folder)
            descriptor = descriptor_text(scene, depsgraph, world).encode()
            missing = [f"World: {what}" for what in missing_of_world]
            missing += missing_lines(scene, view_layer, depsgraph)
            tree = RenderedTree(view_layer)
            run_exporter(exported, tree)
            missing += [f"{name}: not sent, since its parent is an instance or in another collection"
                        for name in sorted(set(tree.left_out))]
            glb = Glb(exported.read_bytes())
            complete_lights(glb)
            complete_materials(glb)
            complete_surfaces(glb)
            for name, light, pose in tree.area_lights:
                add_area_light(glb, name, light, pose)
            view_layer.update()  # what the exporter touched is not a change of the user's
        has_new_words = replace_if_new(folder / "scene.toml", [descriptor])
        has_new_scene = replace_if_new(folder / "scene.glb", glb.parts())
    except OSError as failure:
        raise ExportError(str(failure)) from failure
    finally:
        exported.unlink(missing_ok=True)
    return has_new_words or has_new_scene, missing, world.get("environment_file", "")


# ---- The session: from a change in Blender to a new file ---------------------------------------


def fingerprint(scene, view_layer):
    """What can change without any object, material or world telling: not so the selection."""
    render = scene.render
    return (
        scene.name, view_layer.name, scene.camera and scene.camera.name,
        scene.world and scene.world.name, render.resolution_x, render.resolution_y,
        render.pixel_aspect_x, render.pixel_aspect_y,
        tuple((thing.name, thing.visible_get(view_layer=view_layer)) for thing in view_layer.objects),
        tuple((place.name, place.hide_render)
              for place in (*bpy.data.objects, *bpy.data.collections)),
    )


class Session:
    """A preview beside this Blender, and the private folder that it reads from."""

    def __init__(self):
        self.is_live = True
        self.folder = None
        self.process = None
        self.failure = ""
        self.missing = []
        self.export_count = 0  # of files that changed
        self.export_s = 0.0
        self.waits_for = ""
        self._changed_at = None
        self._may_have_changed = False
        self._is_exporting = False
        self._fingerprint = None
        self._environments = []
        self._timer = self.tick  # one object: timers are known by it
        self._handlers = [
            (bpy.app.handlers.depsgraph_update_post, self.note_update),
            (bpy.app.handlers.frame_change_post, self.note_change),
            (bpy.app.handlers.undo_post, self.note_change),
            (bpy.app.handlers.redo_post, self.note_change),
            (bpy.app.handlers.load_post, self.note_change),
        ]

    def open(self):
        for handlers, function in self._handlers:
            handlers.append(function)
        atexit.register(self.close)

    def close(self):
        atexit.unregister(self.close)
        for handlers, function in self._handlers:
            if function in handlers:
                handlers.remove(function)
        if bpy.app.timers.is_registered(self._timer):
            bpy.app.timers.unregister(self._timer)
        self.stop()
        if self.folder is not None:
            shutil.rmtree(self.folder, ignore_errors=True)
            self.folder = None

    @persistent
    def note_update(self, _scene, depsgraph):
        """Only sets a flag: an export from here would call this again."""
        if self._is_exporting:
            return
        for update in depsgraph.updates:
            if update.is_updated_geometry or update.is_updated_transform or update.is_updated_shading:
                self._changed_at = time.monotonic()
                return
            self._may_have_changed = True

    @persistent
    def note_change(self, *_):
        if not self._is_exporting:
            self._changed_at = time.monotonic()

    def start(self, program):
        """Exports, and starts the preview unless one runs. Raises ExportError."""
        self.export(main_window())
        if self.is_running():
            return
        self.failure = ""
        log = open(self.folder / "preview.log", "wb")
        with log:
            try:
                self.process = subprocess.Popen(
                    [program, "preview", "--watch", str(self.folder / "scene.glb")],
                    stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=log,
                )
            except OSError as failure:
                raise ExportError(f"{program}: {failure.strerror}") from failure
        if not bpy.app.timers.is_registered(self._timer):
            bpy.app.timers.register(self._timer, first_interval=TICK_S, persistent=True)

    def is_running(self):
        return self.process is not None and self.process.poll() is None

    def stop(self):
        if self.is_running():
            self.process.terminate()
            try:
                self.process.wait(timeout=3.0)
            except subprocess.TimeoutExpired:
                self.process.kill()
                self.process.wait()
        self.process = None

    def tick(self):
        """The timer: seconds until the next time, or None once the preview has ended."""
        if self.process is None:
            return None
        if not self.is_running():
            self.note_end()
            return None
        window = main_window()
        if self.is_live and window is not None and self.is_due(window):
            with contextlib.suppress(ExportError):  # it is in the panel
                self.export(window)
        return TICK_S

    def note_end(self):
        if self.process.returncode != 0:
            words = (self.folder / "preview.log").read_text(errors="replace").splitlines()
            said = [line for line in words if line.strip()]
            self.failure = said[-1] if said else f"the preview ended with {self.process.returncode}"
        self.process = None
        redraw()

    def is_due(self, window):
        """Whether something changed, has come to rest, and may be exported now."""
        if self._may_have_changed and self._changed_at is None:
            if fingerprint(window.scene, window.view_layer) != self._fingerprint:
                self._changed_at = time.monotonic()
        self._may_have_changed = False
        if self._changed_at is None or time.monotonic() - self._changed_at < DEBOUNCE_S:
            return False
        waits_for = obstacle(window)
        if waits_for != self.waits_for:
            self.waits_for = waits_for
            redraw()
        return not waits_for

    def export(self, window):
        """Raises ExportError, which the panel shows too."""
        if self.folder is None:
            self.folder = pathlib.Path(tempfile.mkdtemp(prefix="foveola-blender-"))
        self._is_exporting = True
        self._changed_at = None
        self._fingerprint = None
        start = time.monotonic()
        try:
            is_new, self.missing, environment = export_scene(window, self.folder)
            self._fingerprint = fingerprint(window.scene, window.view_layer)
            self.failure = ""
            self.export_count += is_new
            self.export_s = time.monotonic() - start
            self.forget_environments(environment)
        except Exception as failure:  # Blender drops a timer that raises anything
            is_known = isinstance(failure, ExportError)
            self.failure = str(failure) if is_known else f"{type(failure).__name__}: {failure}"
            raise ExportError(self.failure) from failure
        finally:
            self._is_exporting = False
            redraw()

    def forget_environments(self, name):
        """The one before may be being read now."""
        if name and name not in self._environments[-1:]:
            self._environments.append(name)
        for old in set(self._environments[:-2]) - set(self._environments[-2:]):
            (self.folder / old).unlink(missing_ok=True)
        self._environments = self._environments[-2:]


def main_window():
    windows = bpy.context.window_manager.windows
    return windows[0] if windows else None


def obstacle(window):
    """Why the scene must not be exported now; empty if it may be."""
    with bpy.context.temp_override(window=window):
        mode = bpy.context.mode
    if mode not in MODES_WITH_DATA:
        return "the end of " + mode.replace("_", " ").title()
    if bpy.app.is_job_running("RENDER") or bpy.app.is_job_running("OBJECT_BAKE"):
        return "the end of rendering"
    if bpy.context.window_manager.is_interface_locked:
        return "the interface to be unlocked"
    if window.screen.is_animation_playing:
        return "the end of the animation"
    operators = getattr(window, "modal_operators", ())  # not in Blender 3.4, in 4.2
    if any(operator.bl_idname.startswith("TRANSFORM_OT") for operator in operators):
        return "the mouse"
    return ""


def redraw():
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "VIEW_3D":
                area.tag_redraw()


session = None  # there is one while the add-on is registered


# ---- What is seen in Blender -------------------------------------------------------------------


def find_program(context):
    addon = context.preferences.addons.get(__name__)
    chosen = addon.preferences.program if addon is not None else ""
    program = shutil.which(bpy.path.abspath(chosen) if chosen else "foveola")
    if program is None:
        raise ExportError(
            f"{chosen or 'foveola'} is not a program here; name it in the add-on's preferences"
        )
    return program


def report_text():
    return "\n".join(session.missing) if session.missing else "Everything comes across."


def shown_lines(lines):
    """At most MOST_LINES of them, the last saying how many more there are."""
    if len(lines) <= MOST_LINES:
        return lines
    return [*lines[:MOST_LINES], f"and {len(lines) - MOST_LINES} more"]


def show(column, context, text, icon="NONE"):
    """A label of as many rows as the sidebar's width makes necessary: Blender cuts what is too long."""
    letter_px = 7.5 * context.preferences.system.ui_scale
    region = context.region
    width = max(20, int(region.width / letter_px) - 6) if region is not None else 1000
    for row, words in enumerate(textwrap.wrap(text, width)):
        column.label(text=words, icon=icon if row == 0 else "BLANK1")


class FOVEOLA_OT_preview(bpy.types.Operator):
    bl_idname = "foveola.preview"
    bl_label = "Preview"
    bl_description = "Show the scene in Foveola's live preview, beside Blender"

    @classmethod
    def poll(cls, context):
        return context.mode in MODES_WITH_DATA

    def execute(self, context):
        try:
            session.start(find_program(context))
        except ExportError as failure:
            session.failure = str(failure)
            self.report({"ERROR"}, str(failure))
            return {"CANCELLED"}
        return {"FINISHED"}


class FOVEOLA_OT_update(bpy.types.Operator):
    bl_idname = "foveola.update"
    bl_label = "Update Now"
    bl_description = "Show the changes since the last update"

    @classmethod
    def poll(cls, context):
        return context.mode in MODES_WITH_DATA and session.is_running()

    def execute(self, context):
        try:
            session.export(main_window())
        except ExportError as failure:
            self.report({"ERROR"}, str(failure))
            return {"CANCELLED"}
        return {"FINISHED"}


class FOVEOLA_OT_copy_report(bpy.types.Operator):
    bl_idname = "foveola.copy_report"
    bl_label = "Copy"
    bl_description = "Copy all lines of this list"

    def execute(self, context):
        context.window_manager.clipboard = report_text()
        return {"FINISHED"}


class FOVEOLA_PT_preview(bpy.types.Panel):
    bl_idname = "FOVEOLA_PT_preview"
    bl_label = "Foveola"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Foveola"

    def draw(self, context):
        column = self.layout.column(align=True)
        column.operator(FOVEOLA_OT_preview.bl_idname, icon="HIDE_OFF")
        column.operator(FOVEOLA_OT_update.bl_idname, icon="FILE_REFRESH")
        column.prop(context.window_manager, "foveola_is_live")
        if session.failure:
            show(column, context, session.failure, "ERROR")
        elif session.is_running():
            waits_for = f", waits for {session.waits_for}" if session.waits_for else ""
            show(column, context, f"Exported in {session.export_s:.2f} s{waits_for}", "CHECKMARK")
        if session.missing:
            column.label(text="Does not come across:")
            for line in shown_lines(session.missing):
                show(column, context, line, "DOT")
            column.operator(FOVEOLA_OT_copy_report.bl_idname, icon="COPYDOWN")


class FoveolaPreferences(bpy.types.AddonPreferences):
    bl_idname = __name__
    program: bpy.props.StringProperty(
        name="Program", subtype="FILE_PATH", description="Foveola; empty: foveola in the PATH"
    )

    def draw(self, _context):
        self.layout.prop(self, "program")


CLASSES = (
    FOVEOLA_OT_preview, FOVEOLA_OT_update, FOVEOLA_OT_copy_report, FOVEOLA_PT_preview,
    FoveolaPreferences,
)


def set_live(_owner, value):
    session.is_live = value


def register():
    global session
    session = Session()
    for kind in CLASSES:
        bpy.utils.register_class(kind)
    bpy.types.WindowManager.foveola_is_live = bpy.props.BoolProperty(
        name="Live Update", description="Show every change as soon as it has come to rest",
        get=lambda _owner: session.is_live, set=set_live,
    )
    session.open()


def unregister():
    global session
    session.close()
    session = None
    del bpy.types.WindowManager.foveola_is_live
    for kind in reversed(CLASSES):
        bpy.utils.unregister_class(kind)
