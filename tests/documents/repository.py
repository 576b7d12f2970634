"""What of the repository's files the checks of its documents need."""

import functools
import pathlib
import re
import subprocess

import markdown


class Repository:
    """A clone, of which only files that git knows count: what merely lies on a disk is in none."""

    def __init__(self, root):
        self.root = pathlib.Path(root).resolve()
        listed = subprocess.run(["git", "-C", str(self.root), "ls-files", "-z"], check=False,
                                stdout=subprocess.PIPE)
        if listed.returncode != 0:
            raise SystemExit(f"{self.root}: git cannot list its files; run this in a clone")
        self.files = frozenset(name for name in listed.stdout.decode().split("\0")
                               if name and (self.root / name).is_file())
        self.folders = frozenset(str(folder) for name in self.files
                                 for folder in pathlib.PurePosixPath(name).parents)

    def has(self, path):
        return path in self.files or path in self.folders

    @functools.lru_cache(maxsize=None)
    def text(self, path):
        return (self.root / path).read_text(encoding="utf-8")

    @functools.lru_cache(maxsize=None)
    def page(self, path):
        return markdown.Page(self.text(path))

    def documents(self):
        return sorted(name for name in self.files if name.endswith(".md"))

    def mentions(self, name):
        """Whether anything but documents has the word."""
        return subprocess.run(["git", "-C", str(self.root), "grep", "-q", "-w", "-F", name, "--",
                               ":!*.md"], check=False).returncode == 0

    @functools.cached_property
    def scripts(self):
        """Files that say by what they are run."""
        def begins_as_one(name):
            with open(self.root / name, "rb") as file:
                return file.read(2) == b"#!"
        return sorted(name for name in self.files if begins_as_one(name))

    @functools.cached_property
    def cmake_text(self):
        return "\n".join(self.text(name) for name in sorted(self.files)
                         if name.endswith("CMakeLists.txt"))

    @functools.cached_property
    def targets(self):
        """What can be built by name, or chosen among the tests by its program's name."""
        made = re.findall(r"\b(?:foveola_\w+|pybind11_add_module|add_executable|add_library"
                          r"|add_custom_target)\(\s*([\w-]+)", self.cmake_text)
        return frozenset(made) | {"all", "clean", "install"}

    @functools.cached_property
    def tests(self):
        """The tests' names, as far as sources say: Suite.Case, or what CTest calls a script."""
        return self.scripted_tests | self.cases

    @functools.cached_property
    def scripted_tests(self):
        names = set(re.findall(r"add_test\(\s*NAME\s+([\w.-]+)|foveola_documents_test\((\w+\.\w+)",
                               self.cmake_text))
        return frozenset(name for either in names for name in either if name)

    @functools.cached_property
    def cases(self):
        names = set()
        for name in self.files:
            if name.startswith("tests/") and name.endswith(".cpp"):
                names.update(f"{suite}.{case}" for suite, case in re.findall(
                    r"^TEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\)", self.text(name), re.MULTILINE))
        return frozenset(names)


def report(faults):
    """Prints FILE:LINE: what for each, and gives the exit code."""
    for where, line, what in sorted(faults):
        print(f"{where}:{line}: {what}")
    return 1 if faults else 0
