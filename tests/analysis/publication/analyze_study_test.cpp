#include "analysis/publication/analyze_study.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "renderer/base/text/csv.h"
#include "tests/analysis/made_up_study.h"
#include "tests/matchers.h"
#include "tests/scenes/environment.h"
#include "tests/temporary_folder.h"

namespace fs = std::filesystem;

namespace foveola::analysis {
namespace {

class AnalyzeStudy : public testing::Test {
 protected:
  const test::TemporaryFolder temporary;
  const fs::path root = temporary.path();
  const fs::path folder = root / "results";
};

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    names.insert(entry.path().filename());
  }
  return names;
}

TEST_F(AnalyzeStudy, WritesEverythingIntoANewFolder) {
  const AnalysisOutput output = analyze_records(golden_study_records(), {}, folder);
  EXPECT_THAT(
      names_in(folder),
      ElementsAre(
          "OUTPUTS.md", "amended_sessions.csv", "answers_by_question.csv", "answers_long.csv",
          "background-answers.tex", "background_correlation.csv", "catch_trials.csv",
          "codebook.csv", "comparisons.csv", "data_quality.csv", "exclusions.csv",
          "exploratory-comparisons.tex", "gaze_by_trial.csv", "geometric-means.tex", "latency.csv",
          "manifest.sha256", "model_versions.csv", "models.R", "models.csv", "models_plan.csv",
          "omnibus-ranks.tex", "omnibus-times.tex", "omnibus.csv", "order-effects.tex",
          "order_effects.csv", "outlying_times.csv", "participants_wide.csv", "psych-ds",
          "questionnaire_scores.csv", "ranks.tex", "rating-differences.tex", "rating_counts.csv",
          "ratings-artifacts.tex", "ratings_artifacts.pdf", "ratings_artifacts.png",
          "ratings_artifacts.svg", "ratings_by_method.csv", "ratios-over-participants.tex",
          "reaction_times.csv", "relative_times.pdf", "relative_times.png", "relative_times.svg",
          "relative_times_by_scene.pdf", "relative_times_by_scene.png",
          "relative_times_by_scene.svg", "report.html", "time-to-mark.tex", "time_to_mark.csv",
          "time_to_material.pdf", "time_to_material.png", "time_to_material.svg",
          "time_to_outline.pdf", "time_to_outline.png", "time_to_outline.svg", "times-material.tex",
          "times-outline.tex", "times_by_method.csv", "times_by_scene.csv", "times_in_seconds.pdf",
          "times_in_seconds.png", "times_in_seconds.svg", "trials_long.csv",
          "trials_timed_again.csv"));
  EXPECT_THAT(names_in(folder / "psych-ds" / "data"),
              ElementsAre("study-koskela2018golden_type-participants_data.csv",
                          "study-koskela2018golden_type-trials_data.csv"));
  EXPECT_EQ(output.report, folder / "report.html");
  EXPECT_EQ(output.files.size(), 65U);
  EXPECT_THAT(output.summary, HasSubstr("geometric"));
  EXPECT_THAT(output.warnings, Contains(HasSubstr("6 sessions or values are left out")));
}

TEST_F(AnalyzeStudy, WritesBidsWhereAsked) {
  (void)analyze_records(complete_study(2), {}, folder, {.writes_bids = true});
  EXPECT_THAT(names_in(folder / "bids"),
              ElementsAre("README", "dataset_description.json", "participants.json",
                          "participants.tsv", "sub-P1", "sub-P2", "task-preview_beh.json"));
  EXPECT_TRUE(fs::exists(folder / "bids/sub-P1/beh/sub-P1_task-preview_beh.tsv"));
}

/// A study with something in each of its tables.
study::StudyRecords full_study(const std::string& kind, study::DataQualityRecords& quality) {
  study::StudyRecords records = of_kind(golden_study_records(), kind);
  records.protocol.analysis.primary = {{"outline", "fv", "od"}};
  records.amended = {{"P01", {"0a1b", {"texts.rest"}, "title = 'x'"}}};
  study::TrialRow row = records.trials.front();
  row.kind = study::TrialKind::catch_trial;
  records.add_trial(row, {right_censored(8.0), {}, {}});
  quality.reactions = {{"P01", 0.3, false}};
  quality.frames = {{.participant = "P01", .frames = 10'000, .late = 20, .marks = 30}};
  return records;
}

// Simulated data must never be taken for people's, whatever file of them somebody is shown.
TEST_F(AnalyzeStudy, EveryFileSaysWhoseDataItShows) {
  study::DataQualityRecords quality;
  for (const auto& [kind, mark] :
       {std::pair("simulated", "Simulated data"), std::pair("pilot", "Pilot data")}) {
    const AnalysisOutput output =
        analyze_records(full_study(kind, quality), quality, root / kind, {.writes_bids = true});
    std::set<std::string> unmarked;
    for (const fs::path& file : output.files) {
      const std::string text = read_file(file);
      if (file.extension() == ".csv") {
        const std::vector<CsvRow> rows = parse_csv(text, file);
        EXPECT_THAT(rows, Each(SizeIs(rows.front().size()))) << file;
        const auto column = static_cast<std::size_t>(
            std::find(rows[0].begin(), rows[0].end(), "participant_kind") - rows[0].begin());
        for (std::size_t i = 1; column < rows[0].size() && i < rows.size(); ++i) {
          EXPECT_EQ(rows[i][column], kind) << file;
        }
        if (column == rows[0].size()) {
          unmarked.insert(file.filename());
        }
      } else if (file.extension() == ".svg" || file.extension() == ".tex") {
        EXPECT_THAT(text, HasSubstr(mark)) << file;
      }
    }
    EXPECT_THAT(unmarked, ElementsAre("codebook.csv", "models_plan.csv"));
    EXPECT_THAT(read_file(root / kind / "report.html"),
                AllOf(HasSubstr(fmt::format("({}) – ", mark)),
                      HasSubstr(fmt::format("<p class=\"notice\" role=\"note\">{}", mark))));
    EXPECT_THAT(output.summary, HasSubstr(fmt::format(" ({})\n", mark)));
    EXPECT_THAT(read_file(root / kind / "bids/dataset_description.json"), HasSubstr(mark));
    EXPECT_THAT(read_file(root / kind / "bids/participants.tsv"),
                HasSubstr(fmt::format("sub-P01\tP01\t{}\t", kind)));
  }
  (void)analyze_records(full_study("human", quality), quality, folder);
  for (const char* file : {"report.html", "relative_times.svg", "geometric-means.tex"}) {
    EXPECT_THAT(read_file(folder / file), Not(AnyOf(HasSubstr("Simulated"), HasSubstr("Pilot"))));
  }
}

TEST_F(AnalyzeStudy, WithoutGnuplotAllButTheFiguresIsWritten) {
  const scenes::EnvironmentVariable path("PATH", "/nonexistent");
  const AnalysisOutput output = analyze_records(complete_study(2), {}, folder);
  EXPECT_THAT(output.warnings,
              Contains(HasSubstr("No figure was drawn: gnuplot: cannot be started")));
  EXPECT_TRUE(names_in(folder).contains("comparisons.csv"));
  EXPECT_TRUE(names_in(folder).contains("geometric-means.tex"));
  EXPECT_THAT(read_file(folder / "report.html"), HasSubstr("</html>"));
  EXPECT_FALSE(names_in(folder).contains("relative_times.svg"));
}

TEST_F(AnalyzeStudy, WithoutFontsFiguresAreThoseThatHaveLetters) {
  write_file(root / "fonts.conf",
             "<?xml version=\"1.0\"?><!DOCTYPE fontconfig SYSTEM \"fonts.dtd\">"
             "<fontconfig><dir>/nofonts</dir></fontconfig>\n");
  const scenes::EnvironmentVariable fonts("FONTCONFIG_FILE", root / "fonts.conf");
  const AnalysisOutput output = analyze_records(complete_study(2), {}, folder);
  EXPECT_THAT(output.warnings, Contains(HasSubstr("there is no font")));
  EXPECT_THAT(read_file(folder / "relative_times.svg"), HasSubstr("<text>FV</text>"));
  EXPECT_FALSE(names_in(folder).contains("relative_times.pdf"));
  EXPECT_FALSE(names_in(folder).contains("relative_times.png"));
}

TEST_F(AnalyzeStudy, SameRecordsSameBytes) {
  const AnalysisOutput first = analyze_records(golden_study_records(), {}, folder);
  const AnalysisOutput second = analyze_records(golden_study_records(), {}, root / "again");
  for (std::size_t i = 0; i < first.files.size(); ++i) {
    EXPECT_EQ(read_file(first.files[i]), read_file(second.files[i])) << first.files[i];
  }
}

TEST_F(AnalyzeStudy, NothingIsWrittenWhenThereIsNothingToAnalyse) {
  EXPECT_THROW((void)analyze_records(complete_study(0), {}, folder), Error);
  EXPECT_THAT(names_in(root), IsEmpty());
}

TEST_F(AnalyzeStudy, SaysWhatLimitsTheResult) {
  const AnalysisOutput output =
      analyze_records(of_kind(with_od_alone(complete_study(1)), "simulated"), {}, folder);
  for (const char* words : {"Simulated data", "one method", "One participant"}) {
    EXPECT_THAT(output.warnings, Contains(HasSubstr(words)));
  }
}

}  // namespace
}  // namespace foveola::analysis
