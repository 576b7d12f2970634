#include "study/preflight/preflight_checks.h"

#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "tests/matchers.h"
#include "tests/study/preflight/found_preflight.h"

namespace foveola::study {
namespace {

using test::good_preflight;

/// The names of the checks that came out so.
std::vector<std::string> named(const std::vector<PreflightCheck>& checks,
                               PreflightVerdict verdict) {
  std::vector<std::string> names;
  for (const PreflightCheck& check : checks) {
    if (check.verdict == verdict) {
      names.push_back(check.name);
    }
  }
  return names;
}

/// A preflight in which everything is bad.
Preflight bad_preflight() {
  Preflight bad = good_preflight();
  bad.speeds[1].late = 12;
  bad.speeds[1].samples = 900;
  bad.tracker.source = TrackerSource::simulated;
  bad.gaze = {.samples = 20, .valid = 5, .duration_s = 2.0, .median_age_s = 0.2};
  bad.found_display.refresh_rate_hz = 30.0;
  bad.film_px = {320, 160};
  bad.free_bytes = 1000;
  bad.is_clock_set = false;
  return bad;
}

constexpr PreflightGate full_gate{.max_late_percent = 2.0,
                                  .min_samples_per_second = 1e5,
                                  .min_gaze_rate_hz = 100.0,
                                  .max_gaze_loss = 0.2,
                                  .max_gaze_age_s = 0.03,
                                  .min_free_gb = 1.0,
                                  .tracked_eye = true,
                                  .stated_display = true,
                                  .set_clock = true};

TEST(PreflightChecks, AGoodMachinePassesAnyGate) {
  for (const PreflightGate& gate : {PreflightGate{}, full_gate}) {
    const auto checks = check_preflight(good_preflight(), gate);
    EXPECT_EQ(checks.size(), 12U);
    EXPECT_EQ(named(checks, PreflightVerdict::good).size(), 12U);
  }
}

TEST(PreflightChecks, AnglesAndTheWholeScreenAreAskedFor) {
  Preflight found = good_preflight();
  found.view_deg = {48.4, 27.6};
  const auto refused = [&](const PreflightGate& gate) {
    return named(check_preflight(found, gate), PreflightVerdict::refused);
  };
  EXPECT_THAT(refused({.fov_deg = Vec2(48.0F, 28.0F)}), IsEmpty()) << "half a degree is allowed";
  EXPECT_THAT(refused({.fov_deg = Vec2(48.0F, 28.0F), .fov_tolerance_deg = 0.3}),
              ElementsAre("angles"));
  EXPECT_THAT(refused({.fov_deg = Vec2(48.0F, 29.0F)}), ElementsAre("angles"));
  found.found_display.is_full_screen = false;
  EXPECT_THAT(refused({.full_screen = true}), ElementsAre("window"));
  found.found_display.is_full_screen = true;
  EXPECT_THAT(refused({.full_screen = true}), IsEmpty());
}

TEST(PreflightChecks, AWindowInWhichNothingIsSeenIsAlwaysRefused) {
  Preflight found = good_preflight();
  found.found_display.window_px = {1, 1};
  EXPECT_THROW(require_gate(check_preflight(found, {})), Error);
}

TEST(PreflightChecks, AMethodIsAsFastAsInItsSlowestScene) {
  Preflight found = good_preflight();
  for (const auto& [scene, samples] :
       {std::pair("garden", 90'000U), std::pair("attic", 2'000'000U)}) {
    found.speeds.push_back(found.speeds.front());
    found.speeds.back().scene = scene;
    found.speeds.back().samples = samples;
  }
  EXPECT_EQ(check_preflight(found, {})[1].found, "od 9e+04 in garden, fv 8e+05 in hall");
}

TEST(PreflightChecks, WithoutAGateABadOneIsWarnedOf) {
  const auto checks = check_preflight(bad_preflight(), {});
  EXPECT_THAT(named(checks, PreflightVerdict::warned),
              ElementsAre("frames in time", "eye", "gaze rate", "gaze lost", "gaze age", "display",
                          "film", "disk", "clock"));
  EXPECT_THAT(named(checks, PreflightVerdict::refused), IsEmpty());
}

TEST(PreflightChecks, EachLimitOfTheProtocolRefusesByItself) {
  EXPECT_EQ(named(check_preflight(bad_preflight(), full_gate), PreflightVerdict::refused).size(),
            9U);
  const auto refused = [](const PreflightGate& gate) {
    return named(check_preflight(bad_preflight(), gate), PreflightVerdict::refused);
  };
  EXPECT_THAT(refused({.max_late_percent = 19.0}), ElementsAre("frames in time"));
  EXPECT_THAT(refused({.max_late_percent = 20.0}), IsEmpty());
  EXPECT_THAT(refused({.min_samples_per_second = 901}), ElementsAre("samples a second"));
  EXPECT_THAT(refused({.min_samples_per_second = 900}), IsEmpty());
  EXPECT_THAT(refused({.min_gaze_rate_hz = 11}), ElementsAre("gaze rate"));
  EXPECT_THAT(refused({.max_gaze_loss = 0.7}), ElementsAre("gaze lost"));
  EXPECT_THAT(refused({.max_gaze_age_s = 0.1}), ElementsAre("gaze age"));
  EXPECT_THAT(refused({.min_free_gb = 0.01}), ElementsAre("disk"));
  EXPECT_THAT(refused({.tracked_eye = true}), ElementsAre("eye"));
  EXPECT_THAT(refused({.stated_display = true}), ElementsAre("display"));
  EXPECT_THAT(refused({.set_clock = true}), ElementsAre("clock"));
}

TEST(PreflightChecks, AGateNamesAllThatMissesIt) {
  EXPECT_NO_THROW(require_gate(check_preflight(bad_preflight(), {})));
  try {
    require_gate(check_preflight(bad_preflight(), {.max_gaze_loss = 0.1, .set_clock = true}));
    ADD_FAILURE() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("begun: gaze lost, clock; correct"));
  }
}

TEST(PreflightChecks, WhatNobodySaysIsNotGood) {
  Preflight preflight = good_preflight();
  preflight.is_clock_set.reset();
  preflight.gaze = {.status = "no tracker answers"};
  const auto checks = check_preflight(preflight, {});
  EXPECT_THAT(named(checks, PreflightVerdict::warned),
              ElementsAre("gaze rate", "gaze lost", "gaze age", "clock"));
  EXPECT_THAT(preflight_table(checks), HasSubstr("no tracker answers"));
}

TEST(PreflightChecks, TheTableSaysWhereItIsSlowest) {
  const std::string table = preflight_table(check_preflight(bad_preflight(), full_gate));
  EXPECT_THAT(table, HasSubstr("REFUSED  20.0 % late at most (hall with fv)"));
  EXPECT_THAT(table, HasSubstr("od 1e+06 in hall, fv 900 in hall"));
  EXPECT_THAT(table, HasSubstr("at most 2 % late, the protocol's"));
}

TEST(PreflightChecks, AFilmWhosePixelsShowAsBlocksIsWarnedOf) {
  Preflight preflight = good_preflight();
  preflight.film_px = {720, 360};
  EXPECT_THAT(named(check_preflight(preflight, full_gate), PreflightVerdict::warned), IsEmpty());
  preflight.film_px = {719, 360};
  const auto checks = check_preflight(preflight, full_gate);
  EXPECT_THAT(named(checks, PreflightVerdict::warned), ElementsAre("film"));
  EXPECT_THAT(preflight_table(check_preflight(bad_preflight(), {})),
              HasSubstr("WARNING  320 x 160 pixels of 1.1 degrees"));
}

TEST(PreflightChecks, TheRecordHasFiguresAndVerdicts) {
  const Preflight bad = bad_preflight();
  const auto json = preflight_json(bad, check_preflight(bad, full_gate));
  EXPECT_EQ(json["eye"], "simulated");
  EXPECT_EQ(json["speeds"][1]["late"], 12);
  EXPECT_DOUBLE_EQ(json["gaze"]["loss"].get<double>(), 0.75);
  EXPECT_EQ(json["checks"][0]["verdict"], "refused");
  EXPECT_EQ(json["clock_is_set"], false);
}

TEST(PreflightBanner, SaysWhoseEyeItIsInLargeLetters) {
  EXPECT_EQ(preflight_banner(good_preflight(), true), "");
  Preflight preflight = good_preflight();
  preflight.tracker.source = TrackerSource::simulated;
  EXPECT_THAT(preflight_banner(preflight, false), HasSubstr("THE EYE IS SIMULATED"));
}

TEST(PreflightBanner, ATrackerThatDoesNotAnswerIsNamed) {
  Preflight preflight = good_preflight();
  preflight.tracker.name = "camera";
  preflight.gaze = {.duration_s = 8.0, .status = "nothing speaks the Open Gaze API at here:1"};
  EXPECT_THAT(preflight_banner(preflight, false),
              AllOf(HasSubstr("THE EYE TRACKER CAMERA DOES NOT ANSWER"),
                    HasSubstr("nothing speaks the Open Gaze API at here:1")));
}

TEST(PreflightBanner, OffersAMonitorForAHeadsetThatIsNotThere) {
  Preflight preflight = good_preflight();
  preflight.display.kind = DisplayKind::headset;
  const std::string offer = "--display desktop --tracker pointer";
  EXPECT_THAT(preflight_banner(preflight, true),
              AllOf(HasSubstr("REPLACES THE HEADSET DESK"), HasSubstr(offer)));
  EXPECT_THAT(preflight_banner(preflight, false), Not(HasSubstr(offer)));
}

}  // namespace
}  // namespace foveola::study
