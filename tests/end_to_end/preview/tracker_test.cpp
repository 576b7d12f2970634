// Eye trackers, as their users list and watch them.
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.h"
#include "tests/end_to_end/tracker_profile.h"
#include "tests/matchers.h"
#include "tests/renderer/gaze/tracker_server.h"

namespace foveola::test {
namespace {

TEST(Tracker, WatchTellsRateAndValidity) {
  const ProgramResult result =
      succeeded(run_foveola({"tracker", "watch", "fove0", "--seconds", "2", "--json"}));
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
      succeeded(run_foveola({"tracker", "watch", profile.string(), "--seconds", "3"}));
  EXPECT_THAT(result.output, HasSubstr("nothing speaks the Open Gaze API at 127.0.0.1:" +
                                       std::to_string(nobody.port())));
}

}  // namespace
}  // namespace foveola::test
