// Built-in scenes are made by another program, which the laboratory finds, has built and runs.
#include <fstream>
#include <thread>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/files.h"
#include "tests/end_to_end/program.h"

namespace fs = std::filesystem;

namespace foveola::test {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;
using testing::UnorderedElementsAre;

constexpr const char* smallest_scene = "meeting-room";

void write_script(const fs::path& path, const std::string& script) {
  fs::create_directories(path.parent_path());
  std::ofstream(path) << "#!/bin/sh\n" << script << "\n";
  fs::permissions(path, fs::perms::owner_all);
}

/// A copy of the laboratory, away from what it was built with.
class Generators : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directory(folder_ / "bin");
    fs::copy_file(FOVEOLA_PROGRAM, folder_ / "bin" / "foveola");
  }

  ProgramResult make_scene() {
    const std::string path = (folder_ / "tools").string() + ":" + std::getenv("PATH");
    return run_program({(folder_ / "bin" / "foveola").string(), "scene", "make", smallest_scene},
                       {{"XDG_CACHE_HOME", (folder_ / "cache").string()}, {"PATH", path}});
  }

  std::vector<std::string> cached() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_ / "cache" / "foveola" / "scenes")) {
      names.push_back(entry.path().filename());
    }
    return names;
  }

  TemporaryFolder folder_;
};

class InstalledGenerators : public Generators {
 protected:
  void expect_failure(const std::string& says) {
    expect_one_line(make_scene(), 1, says);
    EXPECT_THAT(cached(), IsEmpty());
  }

  fs::path program() const { return folder_ / "libexec" / "foveola" / "foveola-scenes"; }
};

TEST_F(InstalledGenerators, AreRun) {
  fs::create_directories(program().parent_path());
  fs::copy_file(FOVEOLA_SCENES_PROGRAM, program());
  const ProgramResult result = make_scene();
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.output, HasSubstr(" triangles "));
  EXPECT_EQ(result.errors, "");
  EXPECT_THAT(cached(),
              UnorderedElementsAre(AllOf(StartsWith("meeting-room-"), EndsWith(".glb")),
                                   AllOf(StartsWith("meeting-room-"), EndsWith(".glb.sha256"))));
}

TEST_F(InstalledGenerators, ThatAreMissingAreNamed) {
  expect_failure(program().string() +
                 ": makes the built-in scenes, but cannot be started: "
                 "No such file or directory; install Foveola again");
}

TEST_F(InstalledGenerators, OfOtherSourcesAreNotRun) {
  write_script(program(), "exit 2");
  expect_failure("was built from other sources than this program");
}

TEST_F(InstalledGenerators, ThatFailSayWhy) {
  write_script(program(), "printf '12 1000\\nglTF'; echo no room left >&2; exit 1");
  expect_failure("meeting-room: the program that makes it ended with exit status 1: no room left;");
}

TEST_F(InstalledGenerators, ThatAreKilledLeaveNothing) {
  write_script(program(), "printf '12 1000\\nglTF'; kill -KILL $$");
  expect_failure("ended with signal 9 (Killed); check that there is enough memory");
}

TEST_F(InstalledGenerators, OfWhichTheEndIsMissingLeaveNothing) {
  write_script(program(), "printf '12 1000\\nglTF'");
  expect_failure("printed no whole scene");
}

TEST_F(InstalledGenerators, ThatPrintSomethingElseLeaveNothing) {
  write_script(program(), "echo hello");
  expect_failure("printed no whole scene");
}

TEST_F(InstalledGenerators, ThatMayNotBeRunAreNamed) {
  write_script(program(), "");
  fs::permissions(program(), fs::perms::owner_read);
  expect_failure("cannot be started: Permission denied; install");
}

/// In a folder where CMake built it; a stand-in plays CMake and "builds" a stand-in.
class BuiltGenerators : public Generators {
 protected:
  void SetUp() override {
    Generators::SetUp();
    std::ofstream(folder_ / "CMakeCache.txt") << "CMAKE_PROJECT_NAME:STATIC=foveola\n";
  }

  void cmake_does(const std::string& script) {
    write_script(folder_ / "tools" / "cmake",
                 fmt::format("echo \"$@\" >> {}\n{}", (folder_ / "calls").string(), script));
  }

  /// As a script: that the program is built, in one step, and prints `bytes`.
  std::string building(const std::string& bytes) const {
    return fmt::format(
        "mkdir -p {0}\ncat > {1} <<'END'\n#!/bin/sh\nprintf '12 {2}\\n{3}'\nEND\n"
        "chmod 700 {1}\nmv {1} {4}",
        program().parent_path().string(), (folder_ / "linking").string(), bytes.size(), bytes,
        program().string());
  }

  fs::path program() const { return folder_ / "scenes" / "foveola-scenes"; }

  static constexpr const char* says_so =
      "foveola: building the generators of the built-in scenes, once\n";
};

TEST_F(BuiltGenerators, AreBuiltWhenTheyAreFirstNeeded) {
  cmake_does(building("glTF"));
  const ProgramResult first = make_scene();
  EXPECT_EQ(first.exit_code, 0);
  EXPECT_EQ(first.errors, says_so);
  EXPECT_THAT(first.output, HasSubstr("12 triangles"));
  EXPECT_EQ(make_scene().errors, "");
  EXPECT_THAT(read_file(folder_ / "calls"),
              AllOf(StartsWith("--build " + folder_.path().string() + " --parallel "),
                    EndsWith(" --target foveola-scenes\n")));
}

/// Another laboratory has it built: a linker makes the file executable when it is whole.
TEST_F(BuiltGenerators, ThatAreBeingLinkedAreWaitedFor) {
  write_script(program(), "");
  fs::permissions(program(), fs::perms::owner_read | fs::perms::owner_write);
  cmake_does(building("glTF"));
  EXPECT_EQ(make_scene().exit_code, 0);
}

TEST_F(BuiltGenerators, OfOtherSourcesAreBuiltAnew) {
  write_script(program(), "exit 2");
  cmake_does(building("glTF"));
  const ProgramResult result = make_scene();
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.errors, says_so);
}

/// The sources were changed after the laboratory was built.
TEST_F(BuiltGenerators, OfNewerSourcesThanTheLaboratorysDoNotFillItsCache) {
  write_script(program(), "exit 2");
  cmake_does("exit 0");
  const ProgramResult result = make_scene();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.errors,
            fmt::format("{}foveola: error: {}: was built from other sources than this program: its "
                        "scenes are others; build both: cmake --build {} --target foveola "
                        "foveola-scenes\n",
                        says_so, program().string(), folder_.path().string()));
  EXPECT_THAT(cached(), IsEmpty());
}

TEST_F(BuiltGenerators, ThatCannotBeBuiltShowTheEndOfWhatCMakeSaid) {
  cmake_does("seq 10000; echo 'arcade.cpp:1: no semicolon'; exit 1");
  const ProgramResult result = make_scene();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.errors,
              AllOf(StartsWith(says_so), Not(HasSubstr("\n1000\n")),
                    HasSubstr("\n10000\narcade.cpp:1: no semicolon\nfoveola: error: "),
                    HasSubstr("building foveola-scenes ended with exit status 1")));
  EXPECT_THAT(cached(), IsEmpty());
}

/// The stand-in fails if it is started while another runs.
TEST_F(BuiltGenerators, AreBuiltByOneLaboratoryAtATime) {
  const std::string other = (folder_ / "other").string();
  cmake_does(
      fmt::format("mkdir {0} || exit 1\nsleep 0.2\n{1}\nrmdir {0}", other, building("glTF")));
  ProgramResult beside;
  {
    const std::jthread laboratory([&] { beside = make_scene(); });
    EXPECT_EQ(make_scene().exit_code, 0);
  }
  EXPECT_EQ(beside.exit_code, 0) << beside.errors;
}

TEST_F(BuiltGenerators, InAFolderOfAnotherProjectAreNotBuilt) {
  std::ofstream(folder_ / "CMakeCache.txt") << "CMAKE_PROJECT_NAME:STATIC=another\n";
  cmake_does("exit 1");
  expect_one_line(make_scene(), 1, "cannot be started: No such file or directory");
  EXPECT_FALSE(fs::exists(folder_ / "calls"));
}

TEST(GeneratorsProgram, RefusesToMakeScenesOfOtherGenerators) {
  const ProgramResult result = run_program({FOVEOLA_SCENES_PROGRAM, "0123456789ab", "arcade", "0"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.output, "");
  EXPECT_THAT(result.errors, HasSubstr("not 0123456789ab"));
}

TEST(GeneratorsProgram, RefusesWhatItDoesNotUnderstand) {
  const std::vector<std::vector<std::string>> misuses = {{},
                                                         {"--help"},
                                                         {"0123456789ab", "arcade"},
                                                         {"0123456789ab", "arcade", "-1"},
                                                         {"0123456789ab", "arcade", "7x"},
                                                         {"0123456789ab", "arcade", "4294967296"}};
  for (std::vector<std::string> words : misuses) {
    words.insert(words.begin(), FOVEOLA_SCENES_PROGRAM);
    const ProgramResult result = run_program(words);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.errors, StartsWith("usage: foveola-scenes DIGEST NAME SEED"));
  }
}

/// What a user gets who installs without having needed a built-in scene before.
TEST(Installation, MakesScenes) {
  const TemporaryFolder folder;
  const std::string prefix = (folder / "prefix").string();
  const ProgramResult installed = run_program(
      {"cmake", "--install", fs::path(FOVEOLA_PROGRAM).parent_path().string(), "--prefix", prefix});
  ASSERT_EQ(installed.exit_code, 0) << installed.errors;
  const ProgramResult made = run_program(
      {prefix + "/bin/foveola", "scene", "make", smallest_scene, "-o", (folder / "made").string()});
  EXPECT_EQ(made.errors, "");
  EXPECT_THAT(made.output, HasSubstr(" triangles "));
}

}  // namespace
}  // namespace foveola::test
