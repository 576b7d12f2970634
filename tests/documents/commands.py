#!/usr/bin/env -S python3 -B
"""Checks that whatever the documents say to type exists: each `foveola` command with its options
and those of their values that are few, against the program's own manual page; what else `./foveola`
takes; options that stand alone; presets and targets of CMake, tests, variables, steps of .ci/long;
and every path in code that begins with a folder of the repository, unless it is the reader's own: the
page writes that file, or has that folder made (-o analysis), or its name says so (my-tracker.toml).

commands.py REPOSITORY PROGRAM
"""

import fnmatch
import json
import re
import shlex
import sys

import program
import repository

SHELL_LANGUAGES = ("sh", "console", "")  # of blocks in which commands are looked for
FRONT_DOOR = ("test", "lint", "format", "install", "package")  # ./foveola's own commands; the rest are the program's
BEFORE_COMMANDS = ("env", "exec", "if", "while", "until", "!", "then", "do", "else", "sudo", "time",
                   "nohup", "command", "{")


def is_placeholder(word):
    """What stands for something else: PROTOCOL, K/N, <file>, $file, an ellipsis, a pattern."""
    return not word or bool(re.search(r"[…<>$*\[\]{}]|\.\.\.", word)) or (
        word.upper() == word and re.search("[A-Z]", word) is not None)


def simple_commands(line):
    """The words of each command of a line for the shell, without redirections."""
    lexer = shlex.shlex(line, posix=True, punctuation_chars=True)
    lexer.whitespace_split = True
    lexer.commenters = ""  # a '#' within a word is none: see uncommented()
    words, skip = [], False
    for word in lexer:
        if set(word) <= set(";|&()<>"):
            skip = bool(set(word) & set("<>")) and "(" not in word
            if skip and words and words[-1].isdigit():
                words.pop()  # as in 2>&1
            if not skip:
                yield words
                words = []
        elif skip:
            skip = False
        else:
            words.append(word)
    yield words


def uncommented(line):
    return re.sub(r"(^|\s)#.*", "", line)


def logical_lines(block):
    """Lines of a block with those that a backslash continues, and their numbers. A prompt is left
    out, and what follows `<<` up to its mark."""
    number, lines = block.line, block.code.split("\n")
    mark = None
    while lines:
        first, line = number, lines.pop(0)
        number += 1
        if mark:
            mark = None if line.strip() == mark else mark
            continue
        while line.endswith("\\") and lines:
            line = line[:-1] + " " + lines.pop(0)
            number += 1
        found = re.search(r"<<-?\s*['\"]?(\w+)", line)
        mark = found.group(1) if found else None
        yield first, re.sub(r"^\s*[$#] ", "", line)


class Checker:
    def __init__(self, files, commands):
        self.files = files
        self.root = commands
        self.presets = json.loads(files.text("CMakePresets.json"))
        self.top_folders = {name.split("/")[0] for name in files.files if "/" in name}
        self.options = self._all_options(commands)
        self.long_steps = set(re.findall(r"^(\w+)\(\) *\{", files.text(".ci/long"), re.MULTILINE))

    def _all_options(self, commands):
        """Of all commands, and whatever looks like one in the repository's scripts."""
        options, below = set(), [commands]
        while below:
            command = below.pop()
            options.update(command.options)
            below.extend(command.commands.values())
        for name in self.files.scripts:
            options.update(re.findall(r"--[a-z][\w-]*", self.files.text(name)))
        return options

    # The program's own commands.

    def fault_of_option(self, command, word, rest):
        """Takes its value from the rest of the words."""
        name, equals, value = word.partition("=")
        option = command.options.get(name)
        if option is None:
            return f"'{command.name}' has no option {name}"
        if not option.takes_value:
            return f"{name} of '{command.name}' takes no value" if equals else None
        if not equals and rest:
            value = rest.pop(0)
        if option.values and value and not is_placeholder(value) and value not in option.values:
            return f"{name} of '{command.name}' is one of {', '.join(option.values)}, not {value}"
        return None

    def faults_of_program(self, words):
        command, rest, arguments = self.root, list(words), []
        while rest:
            word = rest.pop(0)
            if re.match(r"--?[a-zA-Z]", word):
                fault = self.fault_of_option(command, word, rest)
                if fault:
                    yield fault
                    return
            elif command.commands:
                if is_placeholder(word) or word == ".":
                    return
                if word not in command.commands:
                    yield f"'{command.name}' has no command '{word}'"
                    return
                command = command.commands[word]
            elif word not in ("…", "..."):
                arguments.append(word)
        if len(arguments) > command.most_arguments:
            yield (f"'{command.name}' takes at most {command.most_arguments} arguments, "
                   f"not {arguments}")
        for value in arguments:
            if command.values and not is_placeholder(value) and value not in command.values:
                yield f"'{command.name}' takes one of {', '.join(command.values)}, not {value}"

    # What else is typed.

    def faults_of_ctest(self, words):
        """CTest knows suites and scripts; ./foveola test --case knows cases."""
        suites = {case.split(".")[0] for case in self.files.cases}
        chosen = {"-R": suites | self.files.scripted_tests,
                  "--tests-regex": suites | self.files.scripted_tests, "--case": self.files.cases}
        for option, value in zip(words, words[1:]):
            if option in chosen and not is_placeholder(value):
                if not any(re.search(value, name) for name in chosen[option]):
                    yield f"no test's name matches '{value}'"

    def faults_of_targets(self, names):
        for name in names:
            if not is_placeholder(name) and name not in self.files.targets:
                yield f"there is no target or test program '{name}'"

    def faults_of_preset(self, kind, name):
        names = [preset["name"] for preset in self.presets[kind] if not preset.get("hidden")]
        if not is_placeholder(name) and name not in names:
            yield f"CMakePresets.json has no '{name}' among its {kind}"

    def faults_of_cmake(self, words):
        kind = "buildPresets" if "--build" in words else "configurePresets"
        if "-B" in words and "-G" not in words:
            yield "give -G Ninja: without it CMake takes make, which may not be installed"
        for index, word in enumerate(words):
            option, equals, value = word.partition("=")
            if option == "--preset":
                yield from self.faults_of_preset(kind, value if equals else words[index + 1])
            elif option in ("--target", "-t"):
                names = words[index + 1:]
                yield from self.faults_of_targets(
                    names[:next((i for i, name in enumerate(names) if name.startswith("-")), None)])

    def faults_of_command(self, words):
        while words and (words[0] in BEFORE_COMMANDS or re.match(r"\w+=", words[0])):
            words = words[1:]
        if words and words[0] == "timeout":
            words = words[2:]
        if not words:
            return
        name, words = words[0], words[1:]
        if name == "./foveola" and words and words[0] in FRONT_DOOR:
            if words[1:2] == ["--only"]:
                yield from self.faults_of_targets(words[2:])
            yield from self.faults_of_ctest(words)
        elif name in ("foveola", "./foveola") or name.endswith("/foveola"):
            yield from self.faults_of_program(words)
        elif name == "ctest":
            for option, value in zip(words, words[1:]):
                if option == "--preset":
                    yield from self.faults_of_preset("testPresets", value)
            yield from self.faults_of_ctest(words)
        elif name == "cmake":
            yield from self.faults_of_cmake(words)
        elif name == ".ci/long":
            for step in words:
                if not is_placeholder(step) and step not in self.long_steps:
                    yield f".ci/long has no step '{step}'"

    def faults_of_line(self, line):
        try:
            commands = list(simple_commands(uncommented(line)))
        except ValueError as error:
            yield f"'{line.strip()}' is no line for the shell: {error}"
            return
        for words in commands:
            yield from self.faults_of_command(words)

    def faults_of_lone_options(self, code):
        for name in re.findall(r"(?:^|\s)(--?[a-zA-Z][\w-]*)", code):
            if name not in self.options:
                yield f"no command and no script has an option {name}"

    def faults_of_names(self, code):
        """Of tests, as Suite.Case, and of what FOVEOLA_… sets."""
        for word in code.split():
            if re.fullmatch(r"[A-Z]\w+\.[A-Z]\w+", word) and word not in self.files.tests:
                yield f"there is no test '{word}'"
            name = re.match(r"-D(\w+)=|\$?(FOVEOLA_\w+)", word)
            name = name and (name.group(1) or name.group(2))
            if name and name.startswith("FOVEOLA_") and not self.files.mentions(name):
                yield f"nothing reads {name}"

    # Paths.

    def has(self, path):
        if self.files.has(path):
            return True
        return "*" in path and any(fnmatch.fnmatchcase(name, path) for name in self.files.files)

    def faults_of_paths(self, code, written=()):
        code = re.sub(r"\{([^{}\s]*)\}", _keep_alternatives, code)
        for word in re.split(r"[\s\"'()=:;,|]+", code):
            path = re.sub(r"^(\$FOVEOLA_SOURCE|\$\{FOVEOLA_SOURCE\}|\.)/", "", word)
            path = path.replace(_comma, ",").rstrip("/.")
            if path.split("/")[0] not in self.top_folders or "/" not in path:
                continue
            for each in _alternatives(path):
                is_own = each in written or each.split("/")[0] in written
                is_own = is_own or re.search(r"[…<>$]|\bNAME\b|(^|/)my[-_]", each)
                if not is_own and not self.has(each):
                    yield f"the repository has no '{each}'"

    def faults_of_page(self, page):
        written = [block.file for block in page.blocks]
        for block in page.blocks:
            written += re.findall(r"\s(?:-o|--output)[ =](\S+)", block.code)
        for block in page.blocks:
            if block.language in SHELL_LANGUAGES and not block.file:
                for number, line in logical_lines(block):
                    for fault in self.faults_of_block_line(block, line, written):
                        yield number, fault
        for piece in page.code_in_text:
            faults = list(self.faults_of_paths(piece.text, written))
            faults += self.faults_of_names(piece.text)
            if re.match(r"(\./)?foveola\s|\.ci/long\s|cmake\s|ctest\s", piece.text):
                faults += self.faults_of_line(piece.text)
            elif piece.text.startswith("-"):
                faults += self.faults_of_lone_options(piece.text)
            yield from ((piece.line, fault) for fault in faults)

    def faults_of_block_line(self, block, line, written):
        mentions = re.search(r"\bfoveola\b|\.ci/long|\bcmake\b|\bctest\b", uncommented(line))
        if block.language or mentions:
            yield from self.faults_of_paths(uncommented(line), written)
            yield from self.faults_of_names(uncommented(line))
        if mentions:
            yield from self.faults_of_line(line)


_comma = "\0"


def _keep_alternatives(braces):
    return braces.group().replace(",", _comma)


def _alternatives(path):
    """a/{b,c} is a/b and a/c."""
    found = re.search(r"\{([^{}]*)\}", path)
    if not found:
        return [path]
    return [each for choice in found.group(1).split(",")
            for each in _alternatives(path[:found.start()] + choice + path[found.end():])]


def faults(files, commands):
    checker = Checker(files, commands)
    for document in files.documents():
        for line, fault in checker.faults_of_page(files.page(document)):
            yield document, line, fault


if __name__ == "__main__":
    sys.exit(repository.report(list(faults(repository.Repository(sys.argv[1]),
                                           program.commands_of(sys.argv[2])))))
