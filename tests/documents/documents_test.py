#!/usr/bin/env -S python3 -B
"""Tests that the checks of documents find what they are there for, on small pages with faults."""

import pathlib
import subprocess
import tempfile
import unittest

import changes
import commands
import links
import markdown
import papers
import program
import repository
import words

HERE = pathlib.Path(__file__).resolve().parent
MANUAL = r"""
.SH OPTIONS
.TP
\fB\-h\fR, \fB\-\-help\fR
Print this help message and exit.
.SH COMMANDS
.SS \fBfoveola render\fR [\fIOPTIONS\fR] \fISCENE\fR
Render a picture.
.TP
\fISCENE\fR
A scene\(aqs name.
.br
(required)
.TP
\fB\-o\fR, \fB\-\-output\fR \fITEXT\fR
The image to write.
.TP
\fB\-\-tone\fR \fITEXT\fR
How bright light is shown.
.br
(one of plain, filmic; default: plain)
.TP
\fB\-\-panorama\fR
Make a 360\-degree image.
.SS \fBfoveola scene\fR [\fIOPTIONS\fR] \fICOMMAND\fR
Scenes.
.SS \fBfoveola scene make\fR [\fIOPTIONS\fR] [\fINAME\fR...]
Write built\-in scenes.
.TP
\fINAME\fR
Which.
.br
(one of arcade, studio\-car)
.SH FILES
.TP
\fB\(ti/.cache/foveola\fR
What can be made again.
"""

FILES = {
    "CMakeLists.txt": "project(foveola VERSION 0.1.0 LANGUAGES CXX)\n",
    "CMakePresets.json":
        '{"configurePresets": [{"name": "clang", "hidden": true}, {"name": "asan"}],'
        ' "buildPresets": [{"name": "asan"}], "testPresets": []}',
    ".ci/long": "kills() {\n  true\n}\n",
    "tests/CMakeLists.txt": "foveola_test(\n  view_test\n  SOURCES a_test.cpp)\n",
    "tests/a_test.cpp": "TEST(ViewSampler, FollowsItsDensity) {}\n",
    "tests/check": "#!/bin/sh\n[ $1 = --install ] && cd \"$FOVEOLA_SOURCE\"\n",
    "README.md": "# Read me\n",
    "CHANGELOG.md": "# Changes\n\n## 0.1.0 - 2026-11-28\n",
    "CITATION.cff": "cff-version: 1.2.0\nmessage: Cite it.\ntitle: Foveola\ntype: software\n"
                    "authors:\n  - name: us\nversion: 0.1.0\nlicense: Apache-2.0\n"
                    'date-released: "2026-11-28"\n',
}


class OnARepository(unittest.TestCase):
    def repository(self, **pages):
        """With what FILES has and `page` as docs/page.md; other names are files at the root."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        root = pathlib.Path(folder.name)
        files = dict(FILES)
        files.update(("docs/page.md" if name == "page" else name, text)
                     for name, text in pages.items())
        for name, text in files.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text, encoding="utf-8")
        subprocess.run(["git", "init", "-q"], cwd=root, check=True)
        subprocess.run(["git", "add", "-A"], cwd=root, check=True)
        return repository.Repository(root)


class Links(OnARepository):
    def faults(self, page):
        return [(line, what) for _, line, what in links.faults(self.repository(page=page))]

    def assert_fault(self, page, line, words):
        faults = self.faults(page)
        self.assertEqual([number for number, _ in faults], [line], faults)
        self.assertIn(words, faults[0][1])

    def test_those_that_lead_somewhere_are_none(self):
        self.assertEqual(self.faults(
            "# The page: `code`, *more* & all\n## Twice\n## Twice\n"
            "[a](../README.md) [b](../README.md#read-me) [c](#the-page-code-more--all)\n"
            "[d](#twice-1) [e](../tests) [f](../tests/a_test.cpp#L1)\n"
            "[g](https://example.org/a_(b).html)\n"
            "<https://example.org> https://example.org/x. `[no](link)` <a id='own'></a>[h](#own)\n"
            "```\n[no](link either)\n```\n"), [])

    def test_a_missing_file(self):
        self.assert_fault("\n[a](nothing.md)\n", 2, "no 'docs/nothing.md'")

    def test_a_missing_picture(self):
        self.assert_fault('<img src="x.png">\n', 1, "no 'docs/x.png'")
        self.assert_fault("[![x](x.png)](../README.md)\n", 1, "no 'docs/x.png'")

    def test_a_file_behind_a_name(self):
        self.assert_fault("[a][b]\n\n[b]: nothing.md\n", 3, "no 'docs/nothing.md'")

    def test_a_file_that_git_does_not_know(self):
        files = self.repository(page="[a](new.md)\n")
        (files.root / "docs" / "new.md").write_text("# New\n", encoding="utf-8")
        self.assertIn("git does not know", list(links.faults(files))[0][2])

    def test_a_missing_heading(self):
        self.assert_fault("[a](#nowhere)\n", 1, "no heading with the anchor '#nowhere'")
        self.assert_fault("# Twice\n\n[a](#twice-1)\n", 3, "'#twice-1'")
        self.assert_fault("[a](../README.md#nowhere)\n", 1, "README.md has no heading")

    def test_a_missing_line(self):
        self.assert_fault("[a](../tests/a_test.cpp#L9)\n", 1, "has no line 9")

    def test_a_path_of_one_machine(self):
        self.assert_fault("[a](/home/somebody/x.md)\n", 1, "a path on one machine")
        self.assert_fault("[a](file:///home/somebody/x.md)\n", 1, "no https address")

    def test_a_malformed_address(self):
        self.assert_fault("[a](http://example.org)\n", 1, "no https address")
        self.assert_fault("see http://example.org.\n", 1, "'http://example.org'")
        self.assert_fault("[a](https://)\n", 1, "names no host")


class Commands(OnARepository):
    def faults(self, page):
        files = self.repository(page=page)
        return [(line, what)
                for _, line, what in commands.faults(files, program.read(MANUAL))]

    def assert_fault(self, page, line, words):
        faults = self.faults(page)
        self.assertEqual([number for number, _ in faults], [line], faults)
        self.assertIn(words, faults[0][1])

    def test_what_exists_is_no_fault(self):
        self.assertEqual(self.faults(
            "`foveola render SCENE -o x.png --tone TONE`, `foveola scene make …`, `foveola --help`,\n"
            "`foveola`, `tests/*.cpp`, `tests/{a_test.cpp,CMakeLists.txt}`, `out/report.html`,\n"
            "`./foveola test --only view_test`, `.ci/long kills`, `tests/NAME.cpp`\n"
            "```sh\n"
            "foveola render arcade \\\n  --tone=plain -o a.png 2>&1 | tail -n 1  # foveola nothing\n"
            "A=1 timeout 9 foveola scene make arcade && $FOVEOLA_SOURCE/build/release/foveola --help\n"
            "cat >x <<'END'\nfoveola nothing\nEND\n"
            "./foveola test --case FollowsIts\ncmake --preset asan\n"
            "cmake --build --preset asan --target view_test\n"
            "```\n"
            "```text\nfoveola nothing\n```\n"), [])

    def test_an_unknown_command(self):
        self.assert_fault("Type `foveola rendr x`.\n", 1, "no command 'rendr'")
        self.assert_fault("```sh\ntrue\nfoveola scene mke\n```\n", 3,
                          "'foveola scene' has no command")
        self.assert_fault("```console\n$ ./foveola lin\n```\n", 2, "no command 'lin'")
        self.assert_fault("```\nfoveola lint\n```\n", 2, "no command 'lint'")
        self.assert_fault("Indented:\n\n    foveola rendr\n", 3, "no command 'rendr'")

    def test_an_unknown_option(self):
        self.assert_fault("`foveola render x --tune 3`\n", 1, "no option --tune")
        self.assert_fault("```sh\nfoveola render x \\\n  --tune 3\n```\n", 2, "no option --tune")
        self.assert_fault("```sh\ntrue && foveola scene make --panorama\n```\n", 2,
                          "'foveola scene make' has no option --panorama")

    def test_an_unknown_option_that_stands_alone(self):
        self.assertEqual(self.faults("`--panorama`, `--tone plain -o x`, `--install`, `-90`\n"), [])
        self.assert_fault("With `--panoramic`.\n", 1, "no command and no script has an option")

    def test_a_value_that_there_is_not(self):
        self.assert_fault("`foveola render x --tone pastel`\n", 1, "one of plain, filmic")
        self.assert_fault("`foveola scene make barn`\n", 1, "one of arcade, studio-car")
        self.assert_fault("`foveola render x --panorama=yes`\n", 1, "takes no value")

    def test_too_many_arguments(self):
        self.assert_fault("`foveola render x y`\n", 1, "at most 1")

    def test_what_is_no_line_for_the_shell(self):
        self.assert_fault("```sh\nfoveola render 'x\n```\n", 2, "no line for the shell")

    def test_an_unknown_test(self):
        self.assert_fault("`./foveola test -R NoSuchTest`\n", 1, "no test's name matches")
        self.assert_fault("`./foveola test -R FollowsIts`\n", 1, "no test's name matches")
        self.assert_fault("`./foveola test --only no_test`\n", 1,
                          "no target or test program 'no_test'")

    def test_an_unknown_name_of_a_test_or_a_variable(self):
        self.assertEqual(self.faults("`ViewSampler.FollowsItsDensity`, `Psych-DS`\n"), [])
        self.assert_fault("`ViewSampler.DoesNot`\n", 1, "no test 'ViewSampler.DoesNot'")
        self.assert_fault("`FOVEOLA_SCENES_FOLDER`\n", 1, "nothing reads FOVEOLA_SCENES_FOLDER")
        self.assert_fault("```sh\ncmake -G Ninja -B x -DFOVEOLA_NOTHING=ON\n```\n", 2,
                          "nothing reads FOVEOLA_NOTHING")

    def test_a_build_by_make(self):
        self.assertEqual(self.faults("```sh\ncmake -G Ninja -B x\n```\n"), [])
        self.assert_fault("```sh\ncmake -B x\n```\n", 2, "give -G Ninja")

    def test_an_unknown_preset(self):
        self.assert_fault("`cmake --preset nope`\n", 1, "no 'nope' among its configurePresets")
        self.assert_fault("`cmake --preset clang`\n", 1, "no 'clang' among its configurePresets")
        self.assert_fault("`ctest --preset asan`\n", 1, "no 'asan' among its testPresets")
        self.assert_fault("```sh\ncmake --build --preset asan -t nothing\n```\n", 2, "'nothing'")

    def test_an_unknown_step(self):
        self.assert_fault("`.ci/long kills nothing`\n", 1, "no step 'nothing'")

    def test_a_missing_path(self):
        self.assert_fault("See `tests/none.cpp`.\n", 1, "no 'tests/none.cpp'")
        self.assert_fault("See `tests/{a_test,none}.cpp:12`.\n", 1, "no 'tests/none.cpp'")
        self.assert_fault("```sh\ncp $FOVEOLA_SOURCE/tests/none.cpp .\nfoveola --help\n```\n", 2,
                          "no 'tests/none.cpp'")

    def test_a_path_of_the_readers_own_is_not_missing(self):
        self.assertEqual(self.faults("`tests/my_test.cpp`, `tests/new.cpp`\n"
                                     "```cpp tests/new.cpp\n```\n"), [])
        self.assertEqual(self.faults("```sh\nfoveola render x -o tests\ncat tests/x.csv\n```\n"), [])

    def test_a_manual_page_without_commands_is_refused(self):
        with self.assertRaises(ValueError):
            program.read(".SH OPTIONS\n")


class Papers(OnARepository):
    def faults(self, program_version="0.1.0", **pages):
        return [(where, what)
                for where, _, what in papers.faults(self.repository(**pages), program_version)]

    def assert_fault_in(self, name, **given):
        self.assertEqual([where for where, _ in self.faults(**given)], [name])

    def test_those_that_agree_have_no_faults(self):
        self.assertEqual(self.faults(), [])

    def test_an_unreleased_version_has_no_date(self):
        log = FILES["CHANGELOG.md"].replace("2026-11-28", "unreleased")
        cff = FILES["CITATION.cff"].replace('date-released: "2026-11-28"\n', "")
        self.assertEqual(self.faults(**{"CHANGELOG.md": log, "CITATION.cff": cff}), [])
        self.assert_fault_in("CITATION.cff", **{"CHANGELOG.md": log})
        self.assert_fault_in("CITATION.cff", **{"CITATION.cff": cff})

    def test_another_version_is_found(self):
        for name in ("CHANGELOG.md", "CITATION.cff"):
            other = FILES[name].replace("0.1.0", "0.2.0")
            self.assert_fault_in(name, **{name: other})
        self.assert_fault_in("CMakeLists.txt", program_version="0.0.9")

    def test_a_missing_key_is_found(self):
        cff = FILES["CITATION.cff"].replace("message: Cite it.\n", "")
        self.assertEqual(self.faults(**{"CITATION.cff": cff}),
                         [("CITATION.cff", "it has no key 'message'")])

    def test_a_long_read_me_is_found(self):
        self.assertEqual(self.faults(**{"README.md": "x\n" * 200}), [])
        self.assert_fault_in("README.md", **{"README.md": "x\n" * 201})


class Replay(unittest.TestCase):
    """Of pages with a program that prints what it is given."""

    def replay(self, text, *options):
        """Exit code, and what is printed."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        fake = self.folder / "bin" / "foveola"
        fake.parent.mkdir()
        fake.write_text('#!/bin/sh\necho "foveola $*"\n')
        fake.chmod(0o755)
        page = self.folder / "page.md"
        page.write_text(text, encoding="utf-8")
        done = subprocess.run([str(HERE / "replay"), str(fake.parent), str(page), *options],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=60)
        return done.returncode, done.stdout.decode()

    def test_blocks_run_in_order_in_one_shell(self):
        code, said = self.replay(
            "```toml sub/my.toml\na = '$x'\n```\n"
            "```sh\nx=3\nsleep 60 &\n```\n"
            "```console\nfalse\n```\n"
            "```sh\ntest $x = 3 && test \"$(cat sub/my.toml)\" = \"a = '\\$x'\"\n"
            "test \"$(foveola demo)\" = 'foveola demo' && test -e \"$FOVEOLA_SOURCE/README.md\"\n"
            "test ! -e ~/.bashrc\n```\n")
        self.assertEqual(code, 0, said)
        self.assertIn("2 blocks", said)

    def assert_fails(self, text, line, words, *options):
        code, said = self.replay(text, *options)
        self.assertEqual(code, 1, said)
        self.assertIn(words, said)
        self.assertIn(f"at line {line}:", said)

    def test_a_failing_command_is_shown_with_its_line(self):
        self.assert_fails("Text\n\n```sh\ntrue\nfalse\n```\n", 5, "> false")
        self.assert_fails("```sh\nf() {\n  grep x y\n}\nf\n```\n", 3, "> " + "  grep x y")
        self.assert_fails("```sh\nfalse | true\n```\n", 2, "> false | true")

    def test_a_variable_that_nothing_sets_fails(self):
        self.assert_fails("```sh\necho $NOTHING\n```\n", 2, "NOTHING: unbound variable")

    def test_a_file_is_written_when_the_page_comes_to_it(self):
        self.assert_fails("```sh\ncat a.toml\n```\n```toml a.toml\n```\n", 2, "> cat a.toml")

    def test_a_page_that_takes_long_is_ended(self):
        code, said = self.replay("```sh\nsleep 60\n```\n", "--minutes", "0.01")
        self.assertEqual(code, 1)
        self.assertIn("not within 1 s", said)


class Words(unittest.TestCase):
    def test_those_of_a_page_are_its_prose(self):
        page = markdown.Page(
            "# Colours\n\nA `colr`, [its *hue*](hew.md \"x\"), well-known; README.md's\n"
            "participant's 3rd EXR file_name: https://exmple.org <a href='hrf'>or</a>\n"
            "```sh\ncolr\n```\n")
        self.assertEqual(words.of_page(page),
                         [(1, "Colours"), (3, "its"), (3, "hue"), (3, "well"), (3, "known"),
                          (4, "participant"), (4, "or")])

    def test_those_of_a_manual_page_are_what_it_says(self):
        self.assertEqual([word for _, word in words.of_manual(MANUAL.split(".SH COMMANDS")[1])],
                         ["Render", "picture", "scene", "name", "required", "The", "image", "to",
                          "write", "How", "bright", "light", "is", "shown", "one", "of", "plain",
                          "filmic", "default", "plain", "Make", "image", "Scenes", "Write", "built",
                          "in", "scenes", "Which", "one", "of", "arcade", "studio", "car", "What",
                          "can", "be", "made", "again"])


class Pages(unittest.TestCase):
    def test_blocks_have_languages_files_and_lines(self):
        page = markdown.Page(
            "a\n\n```toml my-study.toml\nname = 1\n```\n\n- x\n\n  ```sh\n  y\n    z\n  ```\n")
        self.assertEqual([(block.line, block.language, block.file) for block in page.blocks],
                         [(4, "toml", "my-study.toml"), (10, "sh", "")])
        self.assertEqual([block.code for block in page.blocks], ["name = 1", "y\n  z"])

    def test_a_list_has_no_indented_block(self):
        self.assertEqual(markdown.Page("1. x\n\n    goes on\n").blocks, [])

    def test_code_in_text_may_go_over_a_line_and_contain_a_backtick(self):
        page = markdown.Page("a `b\nc` d ``e`f``\n")
        self.assertEqual([(piece.line, piece.text) for piece in page.code_in_text],
                         [(1, "b c"), (2, "e`f")])


class Changes(unittest.TestCase):
    FILES = {"src/a.cpp": "one\n  two\n\nthree\ntwice\ntwice\n"}

    def changed(self, text):
        return changes.changed_files(markdown.Page(text), self.FILES.get, {"src"})

    def fault(self, text):
        with self.assertRaises(changes.Fault) as raised:
            self.changed(text)
        return raised.exception.line, str(raised.exception)

    def test_lines_are_added_and_taken_away_where_the_others_are(self):
        self.assertEqual(
            self.changed("```diff src/a.cpp\n one\n-  two\n+  2\n+  2.5\n\n three\n```\n"),
            {"src/a.cpp": "one\n  2\n  2.5\n\nthree\ntwice\ntwice\n"})

    def test_one_change_follows_another(self):
        self.assertEqual(
            self.changed("```diff src/a.cpp\n-one\n+1\n```\n\n```diff src/a.cpp\n-1\n+0\n```\n"),
            {"src/a.cpp": "0\n  two\n\nthree\ntwice\ntwice\n"})

    def test_a_block_in_a_folder_of_the_repository_is_a_new_file(self):
        self.assertEqual(
            self.changed("```cpp src/b.cpp\nb\n```\n\n```toml my.toml\na = 1\n```\n"),
            {"src/b.cpp": "b\n"})

    def test_whoever_has_followed_a_page_has_made_its_changes(self):
        page = markdown.Page("```diff src/a.cpp\n one\n+1.5\n   two\n```\n\n```cpp src/b.cpp\nb\n```\n")
        after = self.changed(page.text)
        self.assertTrue(changes.are_made(page, {**self.FILES, **after}.get, {"src"}))
        self.assertFalse(changes.are_made(page, self.FILES.get, {"src"}))
        for name, text in after.items():
            self.assertFalse(changes.are_made(page, {**self.FILES, name: text}.get, {"src"}))

    def test_what_cannot_be_changed_is_said_with_its_line(self):
        self.assertEqual(self.fault("a\n\n```diff src/a.cpp\n four\n+5\n```\n"),
                         (4, "the file has these lines 0 times, and not once"))
        self.assertEqual(self.fault("```diff src/a.cpp\n twice\n+5\n```\n"),
                         (2, "the file has these lines 2 times, and not once"))
        self.assertEqual(self.fault("```diff src/b.cpp\n one\n+5\n```\n"),
                         (2, "there is no src/b.cpp"))
        self.assertEqual(self.fault("```cpp src/a.cpp\n one\n```\n"),
                         (2, "src/a.cpp is there already"))
        self.assertEqual(self.fault("```diff src/a.cpp\none\n+5\n```\n"),
                         (2, "a line of a change begins with a blank, with + or with -"))
        for code in (" one", "+5"):
            self.assertEqual(self.fault(f"```diff src/a.cpp\n{code}\n```\n"),
                             (2, "this changes nothing, or does not say where"))


if __name__ == "__main__":
    unittest.main()
