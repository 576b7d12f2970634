"""What pages tell one to change in Foveola's own sources: a block that is opened by a language and a
path in a folder of the repository, as ```cpp renderer/view/ring_sampler.h, becomes that file; one that
is opened by ```diff and a path changes it. Its lines begin with a blank, with + or with -, as those of
a patch do; those without + are in the file, once, one after the other."""

import pathlib


class Fault(Exception):
    """A change that cannot be made, and the page's line that says it."""

    def __init__(self, line, message):
        super().__init__(message)
        self.line = line


def _places(lines, wanted):
    """Where these lines stand one after the other."""
    return [i for i in range(len(lines) - len(wanted) + 1) if lines[i:i + len(wanted)] == wanted]


def _before_and_after(block):
    """The lines that the block changes, and what they become. Raises Fault."""
    lines = block.code.split("\n")
    if any(line and line[0] not in " +-" for line in lines):
        raise Fault(block.line, "a line of a change begins with a blank, with + or with -")
    before = [line[1:] for line in lines if not line.startswith("+")]
    after = [line[1:] for line in lines if not line.startswith("-")]
    if not before or before == after:
        raise Fault(block.line, "this changes nothing, or does not say where")
    return before, after


def changed_text(block, text):
    """The file's text after the change that the block says. Raises Fault."""
    before, after = _before_and_after(block)
    lines = text.split("\n")
    found = _places(lines, before)
    if len(found) != 1:
        raise Fault(block.line, f"the file has these lines {len(found)} times, and not once")
    return "\n".join(lines[:found[0]] + after + lines[found[0] + len(before):])


def _changes(page, top_folders):
    """The page's blocks that change or add a file of the repository."""
    for block in page.blocks:
        path = pathlib.PurePosixPath(block.file)
        if len(path.parts) > 1 and path.parts[0] in top_folders:
            yield block


def are_made(page, text_of, top_folders):
    """Whether somebody has made all of the page's changes. Raises Fault."""
    def is_made(block):
        text = text_of(block.file)
        if block.language != "diff":
            return text == block.code + "\n"
        return text is not None and bool(_places(text.split("\n"), _before_and_after(block)[1]))
    return all(is_made(block) for block in _changes(page, top_folders))


def changed_files(page, text_of, top_folders):
    """{path: text} of all that the page changes or adds. text_of(path) is a file's text now, or None.
    Raises Fault."""
    files = {}
    for block in _changes(page, top_folders):
        before = files.get(block.file, text_of(block.file))
        if block.language != "diff":
            if before is not None:
                raise Fault(block.line, f"{block.file} is there already")
            files[block.file] = block.code + "\n"
        elif before is None:
            raise Fault(block.line, f"there is no {block.file}")
        else:
            files[block.file] = changed_text(block, before)
    return files
