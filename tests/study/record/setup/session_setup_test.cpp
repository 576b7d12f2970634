// What sessions ran on, and what differs.
#include "study/record/setup/session_setup.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "study/record/maintain/maintenance.h"
#include "study/record/setup/session_devices.h"
#include "tests/matchers.h"
#include "tests/study/record/study_file.h"

namespace foveola::study {
namespace {

/// The devices of a session in a window of so many pixels, with such a rate and speed.
std::string devices(int width, double rate_hz = 60.0, double speed = 1e6) {
  return fmt::format(R"({{"display":{{"framebuffer":[{},480],"refresh_rate_hz":{}}},)"
                     R"("tracker":{{"profile":"camera"}},"machine":{{"threads":4}},)"
                     R"("preflight":{{"full_screen":true,)"
                     R"("speeds":[{{"samples_per_second":{}}},{{"samples_per_second":{}}}]}}}})",
                     width, rate_hz, speed, speed);
}

std::vector<std::string> lines(const std::string& before, const std::string& now) {
  std::vector<std::string> lines;
  for (const SetupDifference& found : setup_differences(before, now)) {
    lines.push_back(fmt::format("{}: {}, {}", found.name, found.before, found.now));
  }
  return lines;
}

TEST(SessionSetupTest, DiffersInWhatBothSay) {
  EXPECT_THAT(lines(devices(640), devices(640)), IsEmpty());
  EXPECT_THAT(lines(devices(640), devices(1280)), ElementsAre("pixels: 640 x 480, 1280 x 480"));
  EXPECT_THAT(lines("{}", devices(640)), IsEmpty()) << "of an older record";
  EXPECT_THAT(lines("[]", devices(640)), IsEmpty());
  EXPECT_THAT(
      lines(R"({"tracker":{"profile":"pointer"},"preflight":{"full_screen":false}})", devices(640)),
      ElementsAre("full screen: no, yes", "tracker: pointer, camera"));
  EXPECT_THAT(lines(R"({"tracker":{"profile":"camera","filter":{"hold_s":0.1}}})", devices(640)),
              ElementsAre(R"(gaze filter: {"hold_s":0.1}, none)"));
}

TEST(SessionSetupTest, MeasuredNumbersVary) {
  EXPECT_THAT(lines(devices(640, 60.0), devices(640, 58.0)), IsEmpty());
  EXPECT_THAT(lines(devices(640, 60.0), devices(640, 50.0)),
              ElementsAre("frame rate in Hz: 60, 50"));
  EXPECT_THAT(lines(devices(640, 60.0, 1e6), devices(640, 60.0, 6e5)), IsEmpty());
  EXPECT_THAT(lines(devices(640, 60.0, 1e6), devices(640, 60.0, 4e5)),
              ElementsAre("samples a second: 1e+06, 400000"));
}

// All that has to be the same at a resume, in a record's words.
TEST(SessionSetupTest, EveryFactIsCompared) {
  struct Fact {
    const char* place;
    nlohmann::json before;
    nlohmann::json now;
    const char* words;
  };
  const std::vector<Fact> facts = {
      {"/display/profile", "a", "b", "display profile: a, b"},
      {"/display/horizontal_fov_deg", 40, 40.1, "horizontal degrees: 40, 40.1"},
      {"/display/vertical_fov_deg", 30, 30.1, "vertical degrees: 30, 30.1"},
      {"/display/size_mm", {600, 340}, {600, 330}, "display size in mm: 600 x 340, 600 x 330"},
      {"/display/distance_mm", 600, 700, "viewing distance in mm: 600, 700"},
      {"/display/refresh_is_measured", true, false, "frame rate measured: yes, no"},
      {"/display/graphics", "a", "b", "graphics: a, b"},
      {"/machine/processor", "a", "b", "processor: a, b"},
      {"/machine/threads", 4, 5, "threads: 4, 5"},
      {"/machine/program", "a", "b", "program: a, b"},
      {"/machine/commit", "a", "b", "commit: a, b"},
      {"/renderer/instruction_set", "AVX2", "AVX-512", "instruction set: AVX2, AVX-512"},
      {"/renderer/ray_instructions", "AVX2", "AVX-512", "ray instructions: AVX2, AVX-512"},
      {"/preflight/film_px", {2, 1}, {4, 2}, "film: 2 x 1, 4 x 2"},
      {"/keys/time_source", "server_stamp", "arrival",
       "source of key times: server_stamp, arrival"}};
  for (const Fact& fact : facts) {
    nlohmann::json before = nlohmann::json::object();
    nlohmann::json now = before;
    before[nlohmann::json::json_pointer(fact.place)] = fact.before;
    now[nlohmann::json::json_pointer(fact.place)] = fact.now;
    EXPECT_THAT(lines(before.dump(), now.dump()), ElementsAre(fact.words));
  }
}

class StudyOnDisplays : public StudyFile {
 protected:
  void record(const std::string& participant, SessionKind kind, int width,
              std::optional<int> resumed_with = std::nullopt) {
    SessionFacts facts = facts_of(participant);
    facts.kind = kind;
    facts.devices = devices(width);
    PlayedSession session(store_, facts, small_plan());
    session.begin();
    if (resumed_with) {
      session.happen(ms(20), Interrupted{});
      session.happen(ms(21), NoteWritten{note_of_devices(devices(*resumed_with))});
      session.happen(ms(22), Resumed{});
    }
  }

  StudyStore store_{path_, small_protocol()};
};

TEST_F(StudyOnDisplays, NamesWhatPeopleHadOtherwise) {
  record("P1", SessionKind::human, 640);
  record("P2", SessionKind::human, 640, 1280);
  record("R1", SessionKind::pilot, 320);
  const std::vector<SessionSetup> setups = read_session_setups(path_);
  ASSERT_EQ(setups.size(), 3U);
  EXPECT_EQ(setups[1].devices.size(), 2U);
  EXPECT_THAT(setups[0].devices[0], HasSubstr("\"threads\":4"));
  std::vector<std::string> warnings;
  for (const RecordFault& warning : verify_study(path_).warnings) {
    warnings.push_back(warning.what);
  }
  EXPECT_THAT(
      warnings,
      ElementsAre("people had other equipment, pixels: 640 x 480 in P1, P2; 1280 x 480 in P2"));
}

TEST_F(StudyOnDisplays, ASessionThatIsDatedYearsFromItsNeighboursIsNamed) {
  record("P1", SessionKind::human, 640);
  record("P2", SessionKind::human, 640);
  EXPECT_THAT(verify_study(path_).warnings, IsEmpty());
  tamper(path_, "UPDATE session SET started_utc = '2019-02-03T04:05:06.000Z' WHERE id = 1");
  const std::vector<RecordFault> warnings = verify_study(path_).warnings;
  ASSERT_FALSE(warnings.empty());
  EXPECT_EQ(warnings[0].participant, "P2");
  EXPECT_THAT(warnings[0].what,
              HasSubstr("the one before it, of P1, 2019-02-03: more than a year"));
}

}  // namespace
}  // namespace foveola::study
