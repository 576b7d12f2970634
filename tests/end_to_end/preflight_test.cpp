// What is measured before a session: said, recorded, and refused where the protocol asks for more.

#include "tests/end_to_end/coverable_tracker.h"
#include "tests/end_to_end/study_run.h"
#include "tests/end_to_end/tracker_profile.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

const char* const goggles = R"(
title = "Goggles"
kind = "headset"
width_px = 2560
height_px = 1440
refresh_rate_hz = 60
horizontal_fov_deg = 100
vertical_fov_deg = 100
scan_out = { duration_ms = 16.7, provenance = "assumed" }
)";

class PreflightRun : public StudyRun {
 protected:
  /// A run that is refused before there is a session.
  ProgramResult refused_with(const std::string& gate, const std::vector<std::string>& options) {
    participant_.write_protocol(one_trial_keys, "[preflight]\n" + gate + short_look);
    const ProgramResult result =
        participant_.run_besides("P1", joined({"--window", "320x240"}, options));
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.output, HasSubstr("REFUSED"));
    EXPECT_THAT(result.errors, AllOf(HasSubstr("preflight: misses what the protocol asks for"),
                                     HasSubstr("nothing was begun")));
    EXPECT_THAT(participant_.ask("SELECT id FROM session"), IsEmpty());
    return result;
  }
};

TEST_F(PreflightRun, AMachineThatIsTooSlowBeginsNothing) {
  EXPECT_THAT(refused_with("min_samples_per_second = 1e12\n", {}).errors,
              HasSubstr("asks for: samples a second;"));
}

TEST_F(PreflightRun, ATrackerThatSendsNothingBeginsNothing) {
  CoverableTracker tracker;
  tracker.cover();
  const std::string profile =
      participant_.folder().write("camera.toml", open_gaze_profile(tracker.port()));
  EXPECT_THAT(
      refused_with("min_gaze_rate_hz = 10\nmax_gaze_age_s = 0.5\n", {"--tracker", profile}).errors,
      HasSubstr("asks for: gaze rate, gaze age;"));
}

TEST_F(PreflightRun, ARehearsalOfAHeadsetsProtocolIsToldAndOfferedAMonitor) {
  participant_.write_protocol(one_trial_keys,
                              std::string("[preflight]\ntracked_eye = true\n") + short_look);
  const std::string display = participant_.folder().write("goggles.toml", goggles);
  const std::string tracker =
      participant_.folder().write("nobody.toml", tracker_profile("simulated", 120));
  participant_.begin({"--pilot", "--display", display, "--tracker", tracker});
  EXPECT_THAT(participant_.program().said(), AllOf(HasSubstr("THE EYE IS SIMULATED"),
                                                   HasSubstr("STANDS IN FOR THE HEADSET GOGGLES"),
                                                   HasSubstr("--display desktop --tracker pointer"),
                                                   ContainsRegex("eye +REFUSED +simulated")));
  participant_.quit();
  EXPECT_THAT(participant_.ask("SELECT devices ->> '$.preflight.eye' FROM session"),
              ElementsAre("simulated"));
  EXPECT_THAT(participant_.ask("SELECT text FROM note"),
              ElementsAre(HasSubstr("THE EYE IS SIMULATED")));
}

TEST_F(PreflightRun, ItsFiguresAreInTheRecord) {
  participant_.write_protocol(one_trial_keys, short_look);
  participant_.begin();
  EXPECT_THAT(participant_.program().said(),
              AllOf(Not(HasSubstr("HEADSET")), HasSubstr("128 x 64 pixels of 2.8 degrees")));
  participant_.quit();
  EXPECT_THAT(participant_.ask("SELECT devices ->> '$.preflight.speeds[0].scene',"
                               " devices ->> '$.preflight.speeds[0].frames' > 0,"
                               " devices ->> '$.preflight.speeds[0].samples_per_second' > 1,"
                               " devices ->> '$.preflight.free_bytes' > 1,"
                               " devices ->> '$.preflight.film_px',"
                               " json_array_length(devices, '$.preflight.checks') FROM session"),
              ElementsAre("hall|1|1|1|[128,64]|12"));
}

}  // namespace
}  // namespace foveola::test
