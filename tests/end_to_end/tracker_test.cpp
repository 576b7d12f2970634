// Eye trackers, as their users list and watch them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.h"
#include "tests/end_to_end/tracker_profile.h"
#include "tests/renderer/gaze/tracker_server.h"

namespace foveola::test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

TEST(Tracker, ListNamesTheProfiles) {
  const ProgramResult result = run_foveola({"tracker", "list", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  std::vector<std::string> names;
  const auto json = nlohmann::json::parse(result.output);
  for (const auto& profile : json.at("profiles")) {
    names.push_back(profile.at("name"));
  }
  EXPECT_THAT(names, Contains("fove0"));
  EXPECT_THAT(names, Contains("open-gaze"));
}

TEST(Tracker, WatchTellsRateAndValidity) {
  const ProgramResult result =
      run_foveola({"tracker", "watch", "fove0", "--seconds", "2", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_GT(json.at("samples"), 10);
  EXPECT_LE(json.at("samples"), 2 * 120 + 1);
  EXPECT_GT(json.at("valid_samples"), 0);
  EXPECT_LE(json.at("rate_hz"), 120.1);
  EXPECT_EQ(json.at("status"), "");
}

TEST(Tracker, WatchSaysWhyNothingComes) {
  const TemporaryFolder folder;
  const TrackerServer nobody(TrackerServer::Begin::later);
  const auto profile = folder.write("nobody.toml", open_gaze_profile(nobody.port()));
  const ProgramResult result =
      run_foveola({"tracker", "watch", profile.string(), "--seconds", "3"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.output, HasSubstr("nothing speaks the Open Gaze API at 127.0.0.1:" +
                                       std::to_string(nobody.port())));
}

TEST(Tracker, WatchRefusesWhatIsNoProfile) {
  const ProgramResult result = run_foveola({"tracker", "watch", "nobody"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.errors, HasSubstr("nobody"));
  EXPECT_THAT(result.errors, HasSubstr("simulated")) << "says which there are";
}

}  // namespace
}  // namespace foveola::test
