// The front-door script on machines that lack something, played by small stand-ins on its PATH.
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/end_to_end/program.h"

namespace fs = std::filesystem;

namespace foveola::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

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

  ProgramResult open() {
    const char* path = std::getenv("PATH");
    return run_program({(folder_ / "foveola").string(), "demo"},
                       {{"PATH", (folder_ / "bin").string() + ":" + path}});
  }

  TemporaryFolder folder_;
};

TEST_F(FrontDoor, WithoutRootItNamesTheCommandToRun) {
  stand_in("dpkg-query", "exit 1");
  stand_in("id", "echo 1000");
  stand_in("sudo", "exit 1");
  const ProgramResult result = open();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.errors, StartsWith("foveola: error: "));
  EXPECT_THAT(result.errors, HasSubstr("apt-get install"));
  EXPECT_THAT(result.errors, HasSubstr("libembree-dev"));
  EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
}

TEST_F(FrontDoor, NamesOnlyWhatIsMissing) {
  stand_in("dpkg-query",
           "for p; do case $p in -*|*{*|libembree-dev) ;; *) echo \"ii  $p\";; esac; done");
  stand_in("id", "echo 1000");
  stand_in("sudo", "exit 1");
  const ProgramResult result = open();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.errors, HasSubstr("apt-get install libembree-dev\n"));
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

}  // namespace
}  // namespace foveola::test
