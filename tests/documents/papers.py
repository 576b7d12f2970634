#!/usr/bin/env -S python3 -B
"""Checks that the papers of a release agree: the version that CMakeLists.txt states is that of the
newest release in CHANGELOG.md, of CITATION.cff and of the program; a release has a date in both or
in neither. And that README.md is short enough to be read, and CITATION.cff has what its format
requires.

papers.py REPOSITORY PROGRAM
"""

import re
import subprocess
import sys

import repository

MOST_README_LINES = 200
# The first four are what version 1.2.0 of the format requires; who cites a program needs the others.
CITATION_KEYS = ("cff-version", "message", "title", "authors", "type", "version", "license")


def line_of(text, found):
    return text.count("\n", 0, found.start()) + 1


def stated_version(files):
    return re.search(r"^project\(\w+ VERSION (\S+)", files.text("CMakeLists.txt"),
                     re.MULTILINE).group(1)


def citation(files):
    """Its top-level keys, with their values if they are plain, and their lines."""
    keys = {}
    for number, line in enumerate(files.text("CITATION.cff").split("\n"), start=1):
        found = re.match(r"([a-z-]+):\s*(.*?)\s*$", line)
        if found:
            keys[found.group(1)] = (found.group(2).strip("\"'"), number)
    return keys


def faults_of_citation(files, version, date):
    keys = citation(files)
    for key in CITATION_KEYS:
        if key not in keys:
            yield "CITATION.cff", 1, f"it has no key '{key}'"
    stated, number = keys.get("version", (version, 1))
    if stated != version:
        yield "CITATION.cff", number, f"version {stated}, where CMakeLists.txt has {version}"
    released, number = keys.get("date-released", (None, 1))
    if released != date:
        yield ("CITATION.cff", number,
               f"date-released is {released}, where CHANGELOG.md has {date or 'no date'}")


def faults(files, program_version):
    version = stated_version(files)
    if program_version != version:
        yield ("CMakeLists.txt", 1,
               f"version {version}, where the program says {program_version}: build it again")
    log = files.text("CHANGELOG.md")
    release = re.search(r"^## (\d+\.\d+\.\d+)(?: - (unreleased|\d{4}-\d\d-\d\d))?$", log,
                        re.MULTILINE)
    if not release:
        yield "CHANGELOG.md", 1, "no heading is like '## 0.1.0 - 2026-11-28' or '… - unreleased'"
        return
    if release.group(1) != version:
        yield ("CHANGELOG.md", line_of(log, release),
               f"the newest release is {release.group(1)}, where CMakeLists.txt has {version}")
    if not release.group(2):
        yield "CHANGELOG.md", line_of(log, release), "the release has no date, nor 'unreleased'"
    date = None if release.group(2) == "unreleased" else release.group(2)
    yield from faults_of_citation(files, version, date)
    lines = files.text("README.md").count("\n")
    if lines > MOST_README_LINES:
        yield ("README.md", MOST_README_LINES + 1,
               f"it has {lines} lines, of {MOST_README_LINES} at most")


def version_of(program):
    said = subprocess.run([program, "--version"], check=True, stdout=subprocess.PIPE)
    return re.match(r"foveola (\S+)", said.stdout.decode()).group(1)


if __name__ == "__main__":
    sys.exit(repository.report(list(faults(repository.Repository(sys.argv[1]),
                                           version_of(sys.argv[2])))))
