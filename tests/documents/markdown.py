"""What a page of Markdown consists of, as far as checks need it: blocks of code, code in the text,
links, headings and the text itself, each with its line. GitHub's dialect."""

import dataclasses
import functools
import re


@dataclasses.dataclass(frozen=True)
class Block:
    """A fenced block, or one that is indented by four blanks, whose language and file are empty."""

    line: int  # of its first line of code
    language: str
    file: str  # that the page says it is, as in ```toml my-study.toml
    code: str


@dataclasses.dataclass(frozen=True)
class Piece:
    """Code in the text, a link's target, or a heading."""

    line: int
    text: str


_FENCE = re.compile(r"^\s*(`{3,}|~{3,})\s*([^`]*)$")
_CODE_IN_TEXT = re.compile(r"(?<!`)(`+)(?!`)((?:(?!\n\s*\n).)+?)(?<!`)\1(?!`)", re.DOTALL)
_COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
# [text](target "title"), ![picture](target), [name]: target, <https://...>, src="target"
_TARGETS = [
    re.compile(r"\]\(\s*<?([^\s()<>]*(?:\([^\s()]*\)[^\s()<>]*)*)>?(?:\s+[\"'][^)]*[\"'])?\s*\)"),
    re.compile(r"^\s{0,3}\[[^\]]+\]:\s*<?(\S+?)>?\s*$", re.MULTILINE),
    re.compile(r"<(https?://[^>\s]*)>"),
    re.compile(r"\b(?:src|href)\s*=\s*[\"']([^\"']*)[\"']"),
]
_BARE_ADDRESS = re.compile(r"(?<![(<\"'])\bhttps?://[^\s<>)\"'`|]*[^\s<>)\"'`|.,;:!?]")
_HEADING = re.compile(r"^ {0,3}(#{1,6})\s+(.*?)\s*#*\s*$", re.MULTILINE)
_ANCHOR = re.compile(r"<a\s+(?:id|name)\s*=\s*[\"']([^\"']+)[\"']")


def _blank(text):
    """As long and with as many lines, but without a word."""
    return re.sub(r"[^\n]", " ", text)


class Page:
    def __init__(self, text):
        self.text = text
        self.blocks, outside = _split_blocks(text.split("\n"))
        self._with_code = _COMMENT.sub(lambda comment: _blank(comment.group()), outside)
        # Words only: code in the text is blanked.
        self.prose = _CODE_IN_TEXT.sub(lambda code: _blank(code.group()), self._with_code)

    @staticmethod
    def _pieces(pattern, text, group):
        return [Piece(text.count("\n", 0, found.start(group)) + 1, found.group(group))
                for found in pattern.finditer(text)]

    @functools.cached_property
    def code_in_text(self):
        pieces = self._pieces(_CODE_IN_TEXT, self._with_code, 2)
        return [Piece(piece.line, " ".join(piece.text.replace("\\|", "|").split()))
                for piece in pieces]

    @functools.cached_property
    def links(self):
        found = [piece for pattern in _TARGETS for piece in self._pieces(pattern, self.prose, 1)]
        found += self._pieces(_BARE_ADDRESS, self.prose, 0)
        return sorted(set(found), key=lambda piece: (piece.line, piece.text))

    @functools.cached_property
    def headings(self):
        return self._pieces(_HEADING, self._with_code, 2)

    @functools.cached_property
    def anchors(self):
        """Of headings as GitHub makes them, and of <a id="...">."""
        names = set(_ANCHOR.findall(self.prose))
        counts = {}
        for heading in self.headings:
            name = _anchor(heading.text)
            count = counts.get(name, 0)
            counts[name] = count + 1
            names.add(f"{name}-{count}" if count else name)
        return names


def _anchor(heading):
    shown = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading)
    shown = re.sub(r"[`*]", "", shown)
    return re.sub(r"[^\w\- ]", "", shown.lower()).replace(" ", "-")


def _without_indent(lines):
    """The code of a fenced block, of which the first line is the fence, whose indent is not code."""
    indent = len(lines[0]) - len(lines[0].lstrip())
    return "\n".join(line[min(indent, len(line) - len(line.lstrip())):] for line in lines[1:])


def _split_blocks(lines):
    """The blocks of code, and the text with their lines emptied."""
    blocks, outside, fence, first, info = [], [], None, 0, []
    indented = []  # the lines of a block that is indented, which nothing in a list is
    after_blank, in_list = True, False

    def close_indented():
        while indented and not indented[-1].strip():
            indented.pop()
        if indented:
            blocks.append(Block(first, "", "", "\n".join(text[4:] for text in indented)))
        indented.clear()

    for number, line in enumerate(lines, start=1):
        found = _FENCE.match(line)
        if fence:
            if found and found.group(1).startswith(fence) and not found.group(2).strip():
                blocks.append(Block(first, *info, _without_indent(lines[first - 2:number - 1])))
                fence = None
            outside.append("")
            continue
        if found:
            close_indented()
            fence, first = found.group(1), number + 1
            in_list = in_list and line.startswith(" ")
            words = found.group(2).split()
            info = (words + ["", ""])[:2]
            outside.append("")
            continue
        if line.startswith("    ") and line.strip() and not in_list and (after_blank or indented):
            if not indented:
                first = number
            indented.append(line)
            outside.append("")
            continue
        if indented and not line.strip():
            indented.append(line)
            outside.append("")
            continue
        close_indented()
        if re.match(r"^\s*([-*+]|\d+[.)])\s", line):
            in_list = True
        elif line.strip() and not line.startswith(" "):
            in_list = False
        outside.append(line)
        after_blank = not line.strip()
    close_indented()
    if fence:
        blocks.append(Block(first, *info, _without_indent(lines[first - 2:])))
    return blocks, "\n".join(outside)
