// The front-door script on machines that lack something, played by small stand-ins on its PATH.
#include <algorithm>
#include <fstream>

#include "renderer/base/files/files.h"
#include "tests/end_to_end/program.h"
#include "tests/matchers.h"

namespace fs = std::filesystem;

namespace foveola::test {
namespace {

class FrontDoor : public testing::Test {
 protected:
  void SetUp() override {
    fs::copy_file(FRONT_DOOR, folder_ / "foveola");
    fs::create_directory(folder_ / "bin");
  }

  void stand_in(const std::string& program, const std::string& script) {
    const fs::path path = folder_ / "bin" / program;
    std::ofstream(path) << "#!/bin/sh\n" << script << "\n";
    fs::permissions(path, fs::perms::owner_all);
  }

  ProgramResult open(Environment environment = {}, const std::string& command = "demo") {
    const char* path = std::getenv("PATH");
    environment.emplace_back("PATH", (folder_ / "bin").string() + ":" + path);
    return run_program({(folder_ / "foveola").string(), command}, environment);
  }

  TemporaryFolder folder_;
};

TEST_F(FrontDoor, NamesOnlyWhatIsMissing) {
  stand_in("dpkg-query",
           "for p; do case $p in -*|*{*|libembree-dev) ;; *) echo \"ii  $p\";; esac; done");
  stand_in("id", "echo 1000");
  stand_in("sudo", "exit 1");
  const ProgramResult result = open();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.errors, MatchesRegex("foveola: error: .*apt-get install libembree-dev\n"));
  EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
}

TEST_F(FrontDoor, SaysPlainlyThatTheNetworkFailed) {
  stand_in("dpkg-query", "exit 1");
  stand_in("id", "echo 0");
  stand_in("apt-get", "echo 'E: Failed to fetch: Could not resolve host' >&2; exit 100");
  const ProgramResult result = open();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.errors, HasSubstr("Could not resolve host"));
  EXPECT_THAT(result.errors, HasSubstr("http_proxy"));
}

// On a machine with ninja, but without make, CMake would configure for make without being told.
TEST_F(FrontDoor, WhatIsConfiguredChangesOnlyInWhatIsAskedFor) {
  stand_in("dpkg-query", "for p; do echo \"ii  $p\"; done");
  stand_in("ninja", "");
  stand_in("cmake", R"([ "$1" != --build ] || exit 1
cd build/release
[ ! -f CMakeCache.txt ] || echo "in what was configured:" >>calls
echo "$@" >>calls
echo BUILD_TESTING:BOOL=OFF >CMakeCache.txt
echo CMAKE_COMPILE_WARNING_AS_ERROR:UNINITIALIZED=OFF >>CMakeCache.txt
touch build.ninja)");
  const auto call = [&](const char* command, const char* warnings_are_errors) {
    EXPECT_THAT(open({{"FOVEOLA_WARNINGS_ARE_ERRORS", warnings_are_errors}}, command).errors,
                HasSubstr("building failed"));
  };
  call("demo", "");
  call("demo", "");
  call("demo", "OFF");
  call("demo", "ON");
  call("test", "");
  EXPECT_EQ(read_file(folder_ / "build" / "release" / "calls"),
            "--preset release -DBUILD_TESTING=OFF -DCMAKE_COMPILE_WARNING_AS_ERROR=OFF -G Ninja\n"
            "in what was configured:\n"
            "--preset release -DCMAKE_COMPILE_WARNING_AS_ERROR=ON\n"
            "in what was configured:\n"
            "--preset release -DBUILD_TESTING=ON\n");
}

}  // namespace
}  // namespace foveola::test
