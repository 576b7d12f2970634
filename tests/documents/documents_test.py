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


def page_of(lines):
    """A page of these lines, and [(number, words)] of those of which a fault with the words is wanted."""
    return ("\n".join(line for line, _ in lines) + "\n",
            [(number, words) for number, (_, words) in enumerate(lines, start=1) if words])


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

    def assert_faults(self, found, wanted):
        found = [(line, what) for _, line, what in found]
        self.assertEqual([line for line, _ in found], [line for line, _ in wanted], found)
        for (_, what), (_, words) in zip(found, wanted):
            self.assertIn(words, what)


class Links(OnARepository):
    def test_those_that_lead_somewhere_are_none(self):
        files = self.repository(page=(
            "# The page: `code`, *more* & all\n## Twice\n## Twice\n"
            "[a](../README.md) [b](../README.md#read-me) [c](#the-page-code-more--all)\n"
            "[d](#twice-1) [e](../tests) [f](../tests/a_test.cpp#L1)\n"
            "[g](https://example.org/a_(b).html)\n"
            "<https://example.org> https://example.org/x. `[no](link)` <a id='own'></a>[h](#own)\n"
            "```\n[no](link either)\n```\n"))
        self.assertEqual(list(links.faults(files)), [])

    def test_each_fault_is_found(self):
        page, wanted = page_of([
            ("[a](nothing.md)", "no 'docs/nothing.md'"),
            ('<img src="x.png">', "no 'docs/x.png'"),
            ("[![x](y.png)](../README.md)", "no 'docs/y.png'"),
            ("[a]: unnamed.md", "no 'docs/unnamed.md'"),
            ("[a](new.md)", "git does not know"),
            ("[a](#nowhere)", "no heading with the anchor '#nowhere'"),
            ("[a](../README.md#nowhere)", "README.md has no heading"),
            ("[a](../tests/a_test.cpp#L9)", "has no line 9"),
            ("[a](/home/somebody/x.md)", "a path on one machine"),
            ("[a](file:///home/somebody/x.md)", "no https address"),
            ("see http://example.org.", "'http://example.org'"),
            ("[a](https://)", "names no host")])
        files = self.repository(page=page)
        (files.root / "docs" / "new.md").write_text("# New\n", encoding="utf-8")
        self.assert_faults(links.faults(files), wanted)


class Commands(OnARepository):
    def faults(self, page):
        return list(commands.faults(self.repository(page=page), program.read(MANUAL)))

    def test_what_exists_is_no_fault(self):
        self.assertEqual(self.faults(
            "`foveola render SCENE -o x.png --tone TONE`, `foveola scene make …`, `foveola --help`,\n"
            "`foveola`, `tests/*.cpp`, `tests/{a_test.cpp,CMakeLists.txt}`, `out/report.html`,\n"
            "`./foveola test --only view_test`, `.ci/long kills`, `tests/NAME.cpp`,\n"
            "`--panorama`, `--tone plain -o x`, `--install`, `-90`,\n"
            "`ViewSampler.FollowsItsDensity`, `Psych-DS`, `tests/my_test.cpp`, `tests/new.cpp`\n"
            "```sh\n"
            "foveola render arcade \\\n  --tone=plain -o a.png 2>&1 | tail -n 1  # foveola nothing\n"
            "A=1 timeout 9 foveola scene make arcade && $FOVEOLA_SOURCE/build/release/foveola --help\n"
            "cat >x <<'END'\nfoveola nothing\nEND\n"
            "./foveola test --case FollowsIts\ncmake --preset asan\n"
            "cmake -G Ninja -B x\ncmake --build --preset asan --target view_test\n"
            "```\n"
            "```cpp tests/new.cpp\n```\n```text\nfoveola nothing\n```\n"), [])

    def test_each_fault_in_the_text_is_found(self):
        page, wanted = page_of([
            ("`foveola rendr x`", "no command 'rendr'"),
            ("`foveola render x --tune 3`", "no option --tune"),
            ("`--panoramic`", "no command and no script has an option"),
            ("`foveola render x --tone pastel`", "one of plain, filmic"),
            ("`foveola scene make barn`", "one of arcade, studio-car"),
            ("`foveola render x --panorama=yes`", "takes no value"),
            ("`foveola render x y`", "at most 1"),
            ("`./foveola test -R FollowsIts`", "no test's name matches"),
            ("`./foveola test --only no_test`", "no target or test program 'no_test'"),
            ("`ViewSampler.DoesNot`", "no test 'ViewSampler.DoesNot'"),
            ("`FOVEOLA_SCENES_FOLDER`", "nothing reads FOVEOLA_SCENES_FOLDER"),
            ("`cmake --preset clang`", "no 'clang' among its configurePresets"),
            ("`ctest --preset asan`", "no 'asan' among its testPresets"),
            ("`.ci/long kills nothing`", "no step 'nothing'"),
            ("`tests/{a_test,none}.cpp:12`", "no 'tests/none.cpp'")])
        self.assert_faults(self.faults(page), wanted)

    def test_each_fault_in_a_block_is_found(self):
        lines = [
            ("foveola scene mke", "'foveola scene' has no command"),
            ("$ ./foveola lin", "no command 'lin'"),
            ("true && foveola scene make --panorama",
             "'foveola scene make' has no option --panorama"),
            ("foveola render 'x", "no line for the shell"),
            ("cmake -B x", "give -G Ninja"),
            ("cmake -G Ninja -B x -DFOVEOLA_NOTHING=ON", "nothing reads FOVEOLA_NOTHING"),
            ("cmake --build --preset asan -t nothing", "'nothing'"),
            ("cp $FOVEOLA_SOURCE/tests/none.cpp .", "no 'tests/none.cpp'")]
        page, wanted = page_of([("```sh", None), *lines, ("```", None)])
        self.assert_faults(self.faults(page), wanted)

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
