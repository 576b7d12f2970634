"""Brings the add-on into a Blender that was started for a test, as the preferences would."""

import pathlib
import sys

import addon_utils
import bpy

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "scenes" / "blender"
NAME = "foveola_preview"


def enable():
    """The add-on's module, registered. Nothing that a user has installed is looked at."""
    if str(FOLDER) not in sys.path:
        sys.path.insert(0, str(FOLDER))
    module = addon_utils.enable(NAME, default_set=True)
    if module is None:
        raise RuntimeError("the add-on does not register")
    return module


def disable():
    addon_utils.disable(NAME, default_set=True)


def export(module, folder):
    """Writes scene.glb and scene.toml into the folder; returns what does not come across."""
    return module.export_scene(bpy.context.window_manager.windows[0], folder)[1]


STAND_IN = """#!/bin/sh
# In place of Foveola: writes down what it was called with, and stays until it is told to end.
printf '%s\\n' "$@" > "{arguments}.part"
mv "{arguments}.part" "{arguments}"
exec sleep 1000
"""


def write_stand_in(folder):
    """The path of a program for the add-on's preference, and that of the arguments that it got."""
    program, arguments = folder / "stand-in", folder / "arguments"
    program.write_text(STAND_IN.format(arguments=arguments))
    program.chmod(0o700)
    bpy.context.preferences.addons[NAME].preferences.program = str(program)
    return arguments


def handlers_of(module_name):
    """Those of Blender's handlers that are the add-on's."""
    groups = [getattr(bpy.app.handlers, name) for name in dir(bpy.app.handlers)]
    groups = [group for group in groups if isinstance(group, list)]
    return [function for group in groups for function in group
            if getattr(function, "__module__", "") == module_name]


class Words:
    """In place of a panel's layout: keeps the words that are shown."""

    def __init__(self):
        self.labels = []

    def column(self, align=False):
        return self

    def row(self):
        return self

    def label(self, text, icon="NONE"):
        self.labels.append(text)

    def operator(self, name, icon="NONE"):
        pass

    def prop(self, owner, name):
        getattr(owner, name)


def panel_words(module):
    """The labels of the add-on's panel as it would be drawn now."""

    class Panel:
        layout = Words()

    module.FOVEOLA_PT_preview.draw(Panel, bpy.context)
    return Panel.layout.labels
