"""The program's commands and options, as its own manual page states them."""

import dataclasses
import re
import subprocess


@dataclasses.dataclass
class Option:
    takes_value: bool
    values: tuple = ()  # those that there are, where they are few


@dataclasses.dataclass
class Command:
    words: tuple = ()  # behind `foveola`
    options: dict = dataclasses.field(default_factory=dict)
    commands: dict = dataclasses.field(default_factory=dict)
    arguments: tuple = ()  # their names
    most_arguments: float = 0
    values: tuple = ()  # of its only argument, where they are few

    @property
    def name(self):
        return " ".join(("foveola",) + self.words)


def _unescape(roff):
    return roff.replace("\\-", "-").replace("\\(aq", "'").replace("\\&", "").replace("\\(ti", "~")


def _values(text):
    found = re.search(r"\((?:[^()]*; )?one of ([^;()]*)", " ".join(text.split()))
    return tuple(found.group(1).split(", ")) if found else ()


def _command(words, synopsis):
    names = [(name, many) for name, many in re.findall(r"\\fI([A-Z0-9-]+)\\fR(\.\.\.)?", synopsis)
             if name not in ("OPTIONS", "COMMAND")]
    return Command(words, arguments=tuple(name for name, _ in names),
                   most_arguments=sum(float("inf") if many else 1 for _, many in names))


def _add_entry(command, entry):
    """Of .TP: the line of names, and the text about them."""
    names, _, text = entry.lstrip("\n").partition("\n")
    options = re.findall(r"\\fB(--?[a-z][\w-]*)\\fR", names)
    option = Option(r"\fI" in names, _values(text))
    command.options.update(dict.fromkeys(options, option))
    if not options and len(command.arguments) == 1:
        command.values = _values(text)


def read(manual):
    """The command `foveola` with all that are below it, from the manual page's text."""
    root = Command()
    sections = re.split(r"^\.S[SH] ", _unescape(manual), flags=re.MULTILINE)
    for section in sections[1:]:
        head, _, body = section.partition("\n")
        if head == "OPTIONS":
            command = root
        elif head.startswith("\\fBfoveola"):
            words = tuple(re.match(r"\\fBfoveola ([^\\]*)\\fR", head).group(1).split())
            above = root
            for word in words[:-1]:
                above = above.commands[word]
            command = above.commands[words[-1]] = _command(words, head)
            command.options["--help"] = command.options["-h"] = Option(False)
        else:
            continue
        for entry in re.split(r"^\.TP$", body, flags=re.MULTILINE)[1:]:
            _add_entry(command, entry)
    if not root.commands:
        raise ValueError("the manual page lists no commands")
    return root


def commands_of(program):
    return read(subprocess.run([program, "manual"], check=True, stdout=subprocess.PIPE)
                .stdout.decode())
