#!/usr/bin/env -S python3 -B
"""Checks that every link in the documents leads somewhere: to a file that git knows, and there to a
heading that is there; addresses in the web must be well-formed and https, and are not visited.

links.py REPOSITORY
"""

import posixpath
import re
import sys
import urllib.parse

import repository


def fault_of_address(target):
    address = urllib.parse.urlsplit(target)
    if address.scheme != "https":
        return f"'{target}' is no https address, nor a file of the repository by its relative path"
    if not re.fullmatch(r"[\w-]+(\.[\w-]+)+(:\d+)?", address.netloc):
        return f"'{target}' names no host"
    return None


def fault_of_anchor(files, path, anchor):
    if path.endswith(".md"):
        if anchor not in files.page(path).anchors:
            return f"{path} has no heading with the anchor '#{anchor}'"
        return None
    line = re.fullmatch(r"L(\d+)", anchor)
    if not line or path not in files.files:
        return f"'#{anchor}' is no place in {path}: only pages have headings"
    if int(line.group(1)) > files.text(path).count("\n"):
        return f"{path} has no line {line.group(1)}"
    return None


def fault_of(files, document, target):
    if re.match(r"[a-zA-Z][\w+.-]*:", target) or target.startswith("//"):
        return fault_of_address(target)
    name, _, anchor = target.partition("#")
    name = urllib.parse.unquote(name)
    if name.startswith("/"):
        return f"'{target}' is a path on one machine: link relative to the page"
    if not name and not anchor:
        return "a link without a target"
    path = document
    if name:
        path = posixpath.normpath(posixpath.join(posixpath.dirname(document), name))
    if not files.has(path):
        beside = " (it is there, but git does not know it)" if (files.root / path).exists() else ""
        return f"the repository has no '{path}'{beside}"
    return fault_of_anchor(files, path, anchor) if anchor else None


def faults(files):
    for document in files.documents():
        for link in files.page(document).links:
            fault = fault_of(files, document, link.text)
            if fault:
                yield document, link.line, fault


if __name__ == "__main__":
    sys.exit(repository.report(list(faults(repository.Repository(sys.argv[1])))))
