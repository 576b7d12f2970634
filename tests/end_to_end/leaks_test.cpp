// That no command leaves memory behind. Part of a build with the address sanitizer only, whose leak
// detector is switched on here alone: Clang 14's failed in some processes that end while one of
// their threads does, and a command that it failed in is run again.
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/end_to_end/hall.h"

namespace fs = std::filesystem;

namespace foveola::test {
namespace {

bool has_detector_failed(const ProgramResult& result) {
  return result.errors.find("LeakSanitizer has encountered a fatal error") != std::string::npos ||
         result.errors.find("Tracer caught signal") != std::string::npos;
}

class Leaks : public testing::Test, protected Hall {
 protected:
  /// Runs a command that may make `made`, which is removed before it is run again.
  void expect_none(const std::vector<std::string>& arguments, const fs::path& made = {}) {
    expect_none(arguments, made, environment());
  }
  static void expect_none(const std::vector<std::string>& arguments, const fs::path& made,
                          Environment watched) {
    watched.emplace_back("ASAN_OPTIONS", "detect_leaks=1");
    constexpr int most_tries = 5;
    ProgramResult result;
    for (int tries = 0; tries < most_tries && (tries == 0 || has_detector_failed(result));
         ++tries) {
      if (!made.empty()) {
        fs::remove_all(made);
      }
      result = run_foveola(arguments, watched);
    }
    EXPECT_EQ(result.exit_code, 0) << testing::PrintToString(arguments) << result.errors;
  }

  std::string in_folder(const std::string& name) const { return (folder / name).string(); }
};

TEST_F(Leaks, OfNoCommandOnAScene) {
  const std::string scene = in_folder("real/hall.glb");
  expect_none({"scene", "info", scene});
  expect_none({"scene", "pick", scene, "--gaze", "0,0"});
  expect_none({"render", scene, "-o", in_folder("a.exr"), "--size", "64x32", "--samples", "20000"});
  expect_none({"compare", in_folder("a.exr"), in_folder("a.exr")});
  expect_none(
      {"bench", "tracing", scene, "--paths", "2000", "--repetitions", "1", "--size", "64x32"});
}

TEST_F(Leaks, OfNoCommandOnAStudy) {
  const std::string study = in_folder("study.sqlite");
  expect_none({"study", "check", "hall"});
  expect_none({"study", "plan", "hall", "--participants", "3"});
  expect_none({"study", "simulate", "hall", "--db", study, "--participants", "2", "--seed", "1"},
              study);
  expect_none({"study", "status", study});
  expect_none({"study", "verify", study});
  expect_none({"study", "replay", study, "--participant", "P001"});
  expect_none({"study", "backup", study});
  expect_none({"study", "merge", study, "-o", in_folder("merged.sqlite")},
              folder / "merged.sqlite");
  // With Foveola's own resources, which the published study's figures are among.
  expect_none({"analyze", study, "-o", in_folder("analysis")}, folder / "analysis", {});
}

}  // namespace
}  // namespace foveola::test
