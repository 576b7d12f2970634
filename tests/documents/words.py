"""The words of a page or of a manual page that a dictionary should know, with their lines: no code,
no links' targets, no names of files, no abbreviations in capitals, nothing with a digit."""

import re

_TARGET = re.compile(r"(?<=\])\([^()\s]*(?:\([^()]*\)[^()\s]*)*(?:\s+\"[^\"]*\")?\)")
_NAME = re.compile(r"^\s{0,3}\[[^\]]+\]:.*$", re.MULTILINE)
_TAG = re.compile(r"</?[a-zA-Z][^>]*>|https?://\S+|&\w+;")


def _blank(found):
    return " " * len(found.group())


def _words_of_line(line):
    for chunk in line.split():
        marks = "*_,;:!?()[]|\"“”„‘…–—'’~#>=+·<"
        chunk = chunk.lstrip(marks).rstrip(marks + ".")
        if re.search(r"[\d_./@=:\\^(){}\[\]<>$%]", chunk) or chunk.startswith("-"):
            continue
        for word in re.split(r"[-–—…+*×&|]", chunk):
            word = word.strip("'’").replace("’", "'")
            if len(word) > 1 and word.upper() != word and word.replace("'", "").isalpha():
                yield re.sub(r"'s$", "", word)


def _words_of(text):
    return [(number, word) for number, line in enumerate(text.split("\n"), start=1)
            for word in _words_of_line(line)]


def of_page(page):
    text = page.prose
    for pattern in (_NAME, _TARGET, _TAG):
        text = pattern.sub(_blank, text)
    return _words_of(text)


def of_manual(manual):
    """Of a manual page's source: not of examples, nor of what is set in bold or italics."""
    text = re.sub(r"^\.EX$.*?^\.EE$", lambda example: "\n" * example.group().count("\n"), manual,
                  flags=re.MULTILINE | re.DOTALL)
    text = re.sub(r"\\f[BI].*?\\fR|^\.\w+", " ", text, flags=re.MULTILINE)
    for escape, plain in (("\\-", "-"), ("\\(aq", "'"), ("\\&", ""), ("\\(ti", "~")):
        text = text.replace(escape, plain)
    # What is quoted is to be typed, or somebody's name.
    text = re.sub(r"'[^'\n]*'(?!\w)", " ", text)
    return _words_of(text)
