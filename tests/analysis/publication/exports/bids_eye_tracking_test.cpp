#include "analysis/publication/exports/bids_eye_tracking.h"

#include <cmath>
#include <sstream>

#include <nlohmann/json.hpp>

#include "analysis/tables/text_file.h"
#include "tests/analysis/gunzip.h"
#include "tests/analysis/made_up_study.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

constexpr const char* stem = "bids/sub-P1/beh/sub-P1_task-preview_run-01_recording-eye1_physio";

constexpr Nanoseconds ms(int milliseconds) { return std::chrono::milliseconds(milliseconds); }

/// Straight ahead, to the right, nowhere, then 30 degrees up: at 100 Hz.
study::AttemptGaze made_up_gaze(const std::string& participant) {
  const auto up = static_cast<float>(std::sqrt(0.75));
  study::AttemptGaze attempt;
  attempt.participant = participant;
  attempt.trial = 3;
  attempt.trial_kind = "test";
  attempt.scene = "barn";
  attempt.method = "fv";
  attempt.outcome = "rated";
  attempt.first_frame = ms(1004);
  attempt.marks = {{"outline", ms(1012), false}, {"material", ms(1031), true}};
  attempt.samples = {
      {ms(1000), {0.0F, 0.0F, -1.0F}, true, GazeMark::fixation},
      {ms(1010), {1.0F, 0.0F, 0.0F}, true, GazeMark::saccade},
      {ms(1020), {0.0F, 0.0F, -1.0F}, false, GazeMark::blink},
      {ms(1030), {0.0F, 0.5F, -up}, true, GazeMark::blink},
  };
  return attempt;
}

std::vector<TextFile> files_of(const study::AttemptGaze& attempt,
                               const std::vector<study::GazeRunRow>& validations = {},
                               const std::vector<study::AttemptGazeRow>& gaze = {}) {
  EyeTrackingExport eyes(select_for_analysis(complete_study(2)), validations, gaze);
  return eyes.export_attempt(attempt);
}

std::vector<std::string> names_of(const std::vector<TextFile>& files) {
  std::vector<std::string> names;
  for (const TextFile& file : files) {
    names.push_back(file.name);
  }
  return names;
}

/// [row][field] of a table without a heading.
std::vector<std::vector<std::string>> rows_in(const TextFile& file) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream text(gunzip(file.content));
  for (std::string line; std::getline(text, line);) {
    std::istringstream fields(line);
    rows.emplace_back();
    for (std::string field; std::getline(fields, field, '\t');) {
      rows.back().push_back(field);
    }
  }
  return rows;
}

nlohmann::json parse_json(const TextFile& file) { return nlohmann::json::parse(file.content); }

TEST(BidsEyeTracking, SamplesAreAnglesAndWhatIsNotSeenIsNotAvailable) {
  const std::vector<TextFile> files = files_of(made_up_gaze("P1"));
  EXPECT_THAT(rows_in(files.at(0)), ElementsAre(ElementsAre("1000000000", "0.00000", "0.00000"),
                                                ElementsAre("1010000000", "90.00000", "0.00000"),
                                                ElementsAre("1020000000", "n/a", "n/a"),
                                                ElementsAre("1030000000", "0.00000", "30.00000")));
}

TEST(BidsEyeTracking, EventsAreMovementsMarksAndTheFirstFrame) {
  const std::vector<TextFile> files = files_of(made_up_gaze("P1"));
  EXPECT_THAT(rows_in(files.at(2)),
              ElementsAre(ElementsAre("1000000000", "0.010000", "fixation", "n/a"),
                          ElementsAre("1004000000", "0.000000", "first_frame", "n/a"),
                          ElementsAre("1010000000", "0.010000", "saccade", "n/a"),
                          ElementsAre("1012000000", "0.000000", "mark", "outline"),
                          ElementsAre("1020000000", "0.010000", "blink", "n/a"),
                          ElementsAre("1031000000", "0.000000", "timed_out", "material")));
}

// By the schema of BIDS 1.11.1: rules/sidecars/continuous.yaml (Continuous, PhysioEvents,
// EyeTrack), rules/tabular_data/physio.yaml (PhysioEyeTracking, PhysioEventsColumns),
// rules/checks/eyetrack.yaml, and the enumerations of objects/metadata.yaml.
TEST(BidsEyeTracking, TheSamplesSidecarHasWhatTheSpecificationRequires) {
  const nlohmann::json json = parse_json(files_of(made_up_gaze("P1")).at(1));
  EXPECT_EQ(json["PhysioType"], "eyetrack");
  EXPECT_DOUBLE_EQ(json["SamplingFrequency"].get<double>(), 100.0);
  EXPECT_DOUBLE_EQ(json["StartTime"].get<double>(), -0.004);
  EXPECT_THAT(json["Columns"].get<std::vector<std::string>>(),
              ElementsAre("timestamp", "x_coordinate", "y_coordinate"));
  EXPECT_THAT(json["RecordedEye"].get<std::string>(), AnyOf("left", "right", "cyclopean"));
  // "gaze-on-screen" would need the screen's size and distance too.
  EXPECT_THAT(json["SampleCoordinateSystem"].get<std::string>(),
              AnyOf("eye-in-head", "gaze-in-world"));
  EXPECT_TRUE(json["x_coordinate"]["Units"].is_string());
  EXPECT_TRUE(json["y_coordinate"]["Units"].is_string());
}

TEST(BidsEyeTracking, TheEventsSidecarHasWhatTheSpecificationRequires) {
  const std::vector<TextFile> files = files_of(made_up_gaze("P1"));
  const nlohmann::json json = parse_json(files.at(3));
  const auto columns = json["Columns"].get<std::vector<std::string>>();
  EXPECT_EQ(columns.at(0), "onset");
  EXPECT_THAT(rows_in(files.at(2)), Each(SizeIs(columns.size())));
  EXPECT_THAT(parse_json(files.at(1))["Columns"], Contains(json["OnsetSource"].get<std::string>()));
  for (const auto& row : rows_in(files.at(2))) {
    EXPECT_TRUE(json["trial_type"]["Levels"].contains(row.at(2))) << row.at(2);
    EXPECT_GE(std::stod(row.at(1)), 0.0);
  }
}

TEST(BidsEyeTracking, EachRecordingSaysWhichTrialItIs) {
  const nlohmann::json trial = parse_json(files_of(made_up_gaze("P1")).at(1))["Trial"];
  EXPECT_EQ(trial["Position"], 3);
  EXPECT_EQ(trial["Scene"], "barn");
  EXPECT_EQ(trial["Method"], "fv");
  EXPECT_EQ(trial["Attempt"], 1);
}

TEST(BidsEyeTracking, RunsAreCountedForEachParticipant) {
  EyeTrackingExport eyes(select_for_analysis(complete_study(2)), {}, {});
  EXPECT_THAT(names_of(eyes.export_attempt(made_up_gaze("P1"))),
              ElementsAre(std::string(stem) + ".tsv.gz", std::string(stem) + ".json",
                          std::string(stem) + "events.tsv.gz", std::string(stem) + "events.json"));
  EXPECT_THAT(eyes.export_attempt(made_up_gaze("P1")).at(0).name, HasSubstr("_run-02_"));
  EXPECT_THAT(eyes.export_attempt(made_up_gaze("P2")).at(0).name, HasSubstr("sub-P2"));
  EXPECT_THAT(eyes.export_attempt(made_up_gaze("P2")).at(0).name, HasSubstr("_run-02_"));
  EXPECT_THAT(eyes.export_attempt(made_up_gaze("P9")), IsEmpty()) << "not analysed";
}

TEST(BidsEyeTracking, OlderValidatorsAreToldToPassOverEventsWhereThereAreAny) {
  EyeTrackingExport eyes(select_for_analysis(complete_study(2)), {}, {});
  study::AttemptGaze without_events = made_up_gaze("P1");
  without_events.first_frame.reset();
  without_events.marks.clear();
  for (GazeSample& sample : without_events.samples) {
    sample.mark = GazeMark::none;
  }
  EXPECT_THAT(eyes.export_attempt(without_events), SizeIs(2));
  EXPECT_FALSE(eyes.bidsignore_file().has_value());
  (void)eyes.export_attempt(made_up_gaze("P1"));
  const std::optional<TextFile> ignored = eyes.bidsignore_file();
  ASSERT_TRUE(ignored.has_value());
  EXPECT_EQ(ignored->name, "bids/.bidsignore");
  EXPECT_THAT(ignored->content, EndsWith("\n*_physioevents.tsv.gz\n*_physioevents.json\n"));
  EXPECT_THAT(ignored->content, HasSubstr("# "));
}

TEST(BidsEyeTracking, RecordingsWithoutAFrequencyAreCounted) {
  EyeTrackingExport eyes(select_for_analysis(complete_study(2)), {}, {});
  study::AttemptGaze attempt = made_up_gaze("P1");
  attempt.samples.resize(1);
  EXPECT_THAT(eyes.export_attempt(attempt), IsEmpty());
  EXPECT_EQ(eyes.too_short(), 1U);
}

TEST(BidsEyeTracking, HasTheAccuracyOfTheLastValidationWithValidSamples) {
  const std::vector<study::GazeRunRow> validations = {
      {.participant = "P1", .run = 1, .accuracy_deg = 2.5},
      {.participant = "P1", .run = 2, .accuracy_deg = 0.5},
      {.participant = "P1", .run = 3},
      {.participant = "P2", .run = 1, .accuracy_deg = 1.5}};
  EXPECT_EQ(parse_json(files_of(made_up_gaze("P1"), validations).at(1))["AverageCalibrationError"],
            0.5);
  EXPECT_FALSE(parse_json(files_of(made_up_gaze("P1")).at(1)).contains("AverageCalibrationError"));
}

// A mouse has no eye: its path is no eye tracking.
TEST(BidsEyeTracking, AMouseInPlaceOfAnEyeIsNamed) {
  const study::AttemptGaze attempt = made_up_gaze("P1");
  const std::vector<TextFile> files =
      files_of(attempt, {{"P1", 1, 0.8, 0.1, 0.0, true}},
               {{.participant = "P1", .trial = 3, .attempt = 1, .tracker = "pointer"}});
  EXPECT_EQ(files.at(1).name,
            "bids/sub-P1/beh/sub-P1_task-preview_run-01_recording-mouse_physio.json");
  const nlohmann::json json = parse_json(files.at(1));
  EXPECT_EQ(json["PhysioType"], "generic");
  EXPECT_EQ(json["GazeSource"], "the mouse pointer in place of an eye");
  for (const char* of_eyes : {"RecordedEye", "SampleCoordinateSystem", "AverageCalibrationError"}) {
    EXPECT_FALSE(json.contains(of_eyes)) << of_eyes;
  }
  EXPECT_THAT(rows_in(files.at(2)), SizeIs(3)) << "the first frame and two marks";
}

}  // namespace
}  // namespace foveola::analysis
