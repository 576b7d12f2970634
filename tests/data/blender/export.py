"""Exports one scene in each lighting mode of Blender's glTF exporter.

Run by Blender 3.4, headless:  blender -b --python export.py -- FOLDER
"""

import math
import pathlib
import sys

import bpy


def add(name, data, location=(0.0, 0.0, 0.0)):
    thing = bpy.data.objects.new(name, data)
    thing.location = location
    bpy.context.collection.objects.link(thing)


def add_light(kind, energy, location):
    light = bpy.data.lights.new(kind.lower(), kind)
    light.energy = energy  # W/m^2 of a sun, W of the others
    add(light.name, light, location)


def add_emissive_panel():
    material = bpy.data.materials.new("emission")
    material.use_nodes = True
    surface = material.node_tree.nodes["Principled BSDF"].inputs
    surface["Base Color"].default_value = (0.0, 0.0, 0.0, 1.0)
    surface["Emission"].default_value = (1.0, 0.5, 0.25, 1.0)
    surface["Emission Strength"].default_value = 3.0
    panel = bpy.data.meshes.new("panel")
    panel.from_pydata([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)], [], [(0, 1, 2, 3)])
    panel.materials.append(material)
    add("panel", panel)


folder = pathlib.Path(sys.argv[-1])
bpy.ops.wm.read_factory_settings(use_empty=True)
add_light("SUN", 2.0, (0.0, 0.0, 5.0))
add_light("POINT", 4.0 * math.pi, (1.0, 0.0, 2.0))
add_light("SPOT", 4.0 * math.pi, (-1.0, 0.0, 2.0))
add_emissive_panel()
for name, mode in {"standard": "SPEC", "unitless": "COMPAT", "raw": "RAW"}.items():
    bpy.ops.export_scene.gltf(
        filepath=str(folder / f"{name}.gltf"),
        export_format="GLTF_EMBEDDED",
        export_lights=True,
        export_normals=False,
        export_texcoords=False,
        convert_lighting_mode=mode,
    )
