#include "analysis/dataset/gaze_by_trial.h"

#include <algorithm>

#include "analysis/publication/analyze_study.h"
#include "renderer/base/angles.h"
#include "renderer/base/files/files.h"
#include "renderer/base/text/csv.h"
#include "tests/matchers.h"
#include "tests/study/record/study_file.h"

namespace foveola::analysis {
namespace {

using study::FrameRow;
using study::ms;

constexpr const char* vase_ahead =
    R"({"camera":{"position":[0,1,0],"azimuth_rad":0,"elevation_rad":0},)"
    R"("objects":[{"name":"vase","position":[0,1,-2],"radius_deg":5}]})";
constexpr const char* display_and_pointer =
    R"({"display":{"horizontal_fov_deg":90,"vertical_fov_deg":60},)"
    R"("tracker":{"profile":"pointer"}})";

/// A hundred frames a hundredth of a second apart from `first` on; head and gaze are at the vase.
std::vector<FrameRow> frames_from(Nanoseconds first) {
  std::vector<FrameRow> frames;
  for (int i = 0; i < 100; ++i) {
    frames.push_back({.time = first + ms(10 * i - 5),
                      .presented = first + ms(10 * i),
                      .gaze = {0.0F, 0.0F, -1.0F},
                      .gaze_valid = true,
                      .gaze_age = ms(3)});
  }
  return frames;
}

/// From 0.9 s on the head is turned away from the vase, and so is the gaze.
std::vector<FrameRow> turned_away(std::vector<FrameRow> frames) {
  for (std::size_t i = 90; i < frames.size(); ++i) {
    frames[i].head_azimuth_rad = static_cast<float>(radians(180.0));
    frames[i].gaze = {0.0F, 0.0F, 1.0F};
  }
  return frames;
}

/// For 0.6 s the gaze is 40 degrees beside the vase; then it is not valid for 0.1 s.
std::vector<FrameRow> looking_elsewhere(std::vector<FrameRow> frames) {
  for (std::size_t i = 0; i < 60; ++i) {
    frames[i].gaze = direction_from({.azimuth_rad = radians(40.0)});
  }
  for (std::size_t i = 60; i < 70; ++i) {
    frames[i].gaze_valid = false;
  }
  return frames;
}

class GazeByTrial : public study::StudyFile {
 protected:
  /// A person's session: a trial as it should be; one with the vase behind the head at the second
  /// mark; one with the gaze elsewhere; and one without frames.
  GazeByTrial() {
    study::StudyStore store(path_, study::small_protocol());
    study::SessionFacts facts = study::facts_of("P01");
    facts.kind = study::SessionKind::human;
    facts.devices = display_and_pointer;
    for (study::ShownScene& scene : facts.scenes) {
      scene.shown_as = vase_ahead;
    }
    study::PlayedSession session(store, facts, study::small_plan());
    session.begin();
    const auto run_trial = [&](std::size_t trial, const std::vector<FrameRow>& frames) {
      session.run_trial(
          frames.front().presented, ms(500), ms(1000), 3,
          {study::FrameChunk{
              .attempt = {.trial = trial, .attempt = 1}, .first = 0, .frames = frames}});
    };
    run_trial(0, frames_from(ms(10'000)));
    run_trial(1, turned_away(frames_from(ms(20'000))));
    run_trial(2, looking_elsewhere(frames_from(ms(30'000))));
    session.run_trial(ms(40'000), ms(500), ms(1000), 3);
  }

  AnalysisOutput analyse() const { return analyze_study(path_, folder_ / "out"); }
  std::vector<CsvRow> rows_in(const std::string& name) const {
    return parse_csv(read_file(folder_ / "out" / name), name);
  }
  /// The field of a data row, from 0, in the column of this name.
  std::string value_in(const std::vector<CsvRow>& rows, std::size_t row,
                       const std::string& column) const {
    const auto found = std::find(rows.at(0).begin(), rows.at(0).end(), column);
    return rows.at(row + 1).at(static_cast<std::size_t>(found - rows.at(0).begin()));
  }
  double number_in(const std::vector<CsvRow>& rows, std::size_t row,
                   const std::string& column) const {
    return std::stod(value_in(rows, row, column));
  }
};

const DataQualityCheck& check_of(const AnalysisOutput& output, const std::string& name) {
  const std::vector<DataQualityCheck>& checks = output.checks.checks;
  return *std::find_if(checks.begin(), checks.end(),
                       [&](const DataQualityCheck& check) { return check.name == name; });
}

TEST_F(GazeByTrial, AnObjectBehindTheHeadAndAGazeElsewhereAreFlagged) {
  const AnalysisOutput output = analyse();
  const DataQualityCheck& view = check_of(output, "Marks with the object out of view");
  EXPECT_EQ(view.verdict, Verdict::flagged);
  EXPECT_EQ(view.value_text, "1 of 6 marks: P01, hall, od, material");
  const DataQualityCheck& elsewhere = check_of(output, "Trials with the gaze elsewhere");
  EXPECT_EQ(elsewhere.verdict, Verdict::flagged);
  EXPECT_EQ(elsewhere.value_text, "1 of 3 trials: P01, box, od: 60 %");
}

TEST_F(GazeByTrial, EveryAnalysedTrialHasARow) {
  (void)analyse();
  const std::vector<CsvRow> rows = rows_in("gaze_by_trial.csv");
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_THAT(
      rows[0],
      ElementsAre("participant", "scene", "method", "trial", "attempt", "object", "tracker",
                  "gaze_time_seconds", "gaze_on_object_seconds", "gaze_on_object_percent",
                  "gaze_elsewhere_percent", "gaze_lost_percent", "fixations",
                  "mean_fixation_seconds", "fixations_on_object", "outline_gaze_from_object_deg",
                  "outline_object_from_middle_deg", "outline_object_in_view",
                  "material_gaze_from_object_deg", "material_object_from_middle_deg",
                  "material_object_in_view", "participant_kind", "record"));
  EXPECT_THAT(rows[4], ElementsAre("P01", "box", "fv", "3", "1", "vase", "", "", "", "", "", "", "",
                                   "", "", "", "", "", "", "", "", "human", "verified"));
  EXPECT_NEAR(number_in(rows, 0, "gaze_time_seconds"), 1.0, 1e-9);
  EXPECT_NEAR(number_in(rows, 0, "gaze_on_object_percent"), 100.0, 1e-9);
  EXPECT_NEAR(number_in(rows, 1, "gaze_on_object_seconds"), 0.9, 1e-9);
  EXPECT_NEAR(number_in(rows, 1, "material_object_from_middle_deg"), 180.0, 1e-3);
  EXPECT_EQ(value_in(rows, 1, "outline_object_in_view"), "TRUE");
  EXPECT_EQ(value_in(rows, 1, "material_object_in_view"), "FALSE");
  EXPECT_NEAR(number_in(rows, 2, "gaze_elsewhere_percent"), 60.0, 1e-9);
  EXPECT_NEAR(number_in(rows, 2, "gaze_lost_percent"), 10.0, 1e-9);
  EXPECT_NEAR(number_in(rows, 2, "outline_gaze_from_object_deg"), 40.0, 1e-3);
  EXPECT_NEAR(number_in(rows, 2, "material_gaze_from_object_deg"), 0.0, 1e-3);
  EXPECT_EQ(value_in(rows, 2, "tracker"), "pointer");
}

TEST_F(GazeByTrial, TheTableOfTrialsHasTheSameValues) {
  const AnalysisOutput output = analyse();
  const std::vector<CsvRow> rows = rows_in("gaze_by_trial.csv");
  const std::vector<CsvRow> trials = rows_in("trials_long.csv");
  ASSERT_EQ(trials.size(), rows.size());
  for (const Column& column : columns_in(gaze_columns(output.tables.set.measures))) {
    for (std::size_t row = 0; row + 1 < rows.size(); ++row) {
      EXPECT_EQ(value_in(trials, row, column.name), value_in(rows, row, column.name))
          << column.name;
    }
  }
}

// Of od: trials 1 and 2, with 90 % and 30 % of the time on the vase; of fv: trial 0, and one
// without frames.
TEST_F(GazeByTrial, TheReportHasTheMeansOfEachMethod) {
  const std::vector<MethodGaze> methods = analyse().checks.gaze;
  ASSERT_EQ(methods.size(), 3U);
  EXPECT_EQ(methods[0].method, "od");
  EXPECT_EQ(methods[0].trials, 2U);
  EXPECT_NEAR(methods[0].on_object_percent.value(), 60.0, 1e-9);
  EXPECT_NEAR(methods[0].elsewhere_percent.value(), 35.0, 1e-9);
  EXPECT_NEAR(methods[0].without_gaze_percent.value(), 5.0, 1e-9);
  // 0 and 180 degrees in one trial, 40 and 0 in the other.
  EXPECT_NEAR(methods[0].gaze_from_object_deg.value(), 55.0, 1e-3);
  EXPECT_FALSE(methods[0].fixations);
  EXPECT_EQ(methods[1].trials, 1U);
  EXPECT_EQ(methods[2].trials, 0U);
  EXPECT_FALSE(methods[2].on_object_percent);
}

}  // namespace
}  // namespace foveola::analysis
