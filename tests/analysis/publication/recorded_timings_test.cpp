// Every timing of a study's file comes out, those that were made again among them.
#include <map>
#include <string>

#include "analysis/publication/analyze_study.h"
#include "renderer/base/files/files.h"
#include "renderer/base/text/csv.h"
#include "tests/matchers.h"
#include "tests/study/record/study_file.h"

namespace foveola::analysis {
namespace {

using study::ms;

class RecordedTimings : public study::StudyFile {
 protected:
  /// P01 is timed again in the first trial, where the time ran out before the second mark.
  void write_retimed_study() {
    study::StudyStore store(path_, study::small_protocol());
    study::PlayedSession session = study::begun_session(store);
    session.choose_and_start(ms(20));
    session.happen(ms(1000), study::FirstFramePresented{ms(1000)});
    session.happen(ms(2000), study::Marked{ms(2000)});
    session.happen(ms(121'000), study::TimedOut{ms(121'000)});
    session.happen(ms(121'100), study::RetimeRequested{});
    for (int trial = 0; trial < 4; ++trial) {
      session.run_trial(ms(200'000 + 20'000 * trial), ms(500), ms(1500), 3);
    }
  }

  std::vector<CsvRow> rows_in(const std::string& name) const {
    return parse_csv(read_file(folder_ / "out" / name), name);
  }
};

TEST_F(RecordedTimings, OnesThatWereMadeAgainAreInAFileOfTheirOwn) {
  write_retimed_study();
  const AnalysisOutput output = analyze_study(path_, folder_ / "out");
  const std::vector<CsvRow> again = rows_in("trials_timed_again.csv");
  ASSERT_EQ(again.size(), 2U);
  EXPECT_THAT(again[1],
              ElementsAre("P01", "simulated", "completed", "timed again", "", "hall", "fv", "0",
                          "test", "0", "0", "1", "vase", "retimed", "1", "FALSE", "120", "TRUE", "",
                          "", "", "", "", "", "", "", "", "", "", "", "", "", "", "verified"));
  const std::vector<CsvRow> counted = rows_in("trials_long.csv");
  ASSERT_EQ(counted.size(), 5U);
  EXPECT_THAT(counted[1],
              ElementsAre("P01", "simulated", "completed", "analysed", "", "hall", "fv", "0",
                          "test", "0", "0", "2", "vase", "rated", "0.5", "FALSE", "1.5", "FALSE",
                          "3", "", "", "", "", "", "", "", "", "", "", "", "", "", "", "verified"));
  EXPECT_EQ(output.tables.scene_times.at(0).censored, 0);
}

TEST_F(RecordedTimings, OfWithdrawnSessionsComeOutOnlyIfAskedForAndChangeNoResult) {
  write_retimed_study();
  {
    study::StudyStore store(path_, study::small_protocol());
    study::PlayedSession session = study::begun_session(store, "P02");
    session.run_trial(ms(1000), ms(500), ms(1500), 1);
    session.happen(ms(5000), study::Withdrawn{});
  }
  (void)analyze_study(path_, folder_ / "out");
  EXPECT_THAT(read_file(folder_ / "out" / "trials_long.csv"), Not(HasSubstr("P02")));
  EXPECT_THAT(read_file(folder_ / "out" / "answers_long.csv"), Not(HasSubstr("P02")));
  const std::string report = read_file(folder_ / "out" / "report.html");
  const std::string times = read_file(folder_ / "out" / "times_by_scene.csv");

  const AnalysisOutput output = analyze_study(path_, folder_ / "out", {.withdrawn = true});
  EXPECT_THAT(output.warnings, Contains(HasSubstr("one session that a participant withdrew from")));
  const std::vector<CsvRow> rows = rows_in("trials_long.csv");
  ASSERT_EQ(rows.size(), 1U + 4U + 4U);
  EXPECT_THAT(std::vector<std::string>(rows[5].begin(), rows[5].begin() + 5),
              ElementsAre("P02", "simulated", "withdrawn", "withdrawn", "session withdrawn"));
  EXPECT_EQ(rows[5].at(14), "0.5");
  EXPECT_THAT(read_file(folder_ / "out" / "answers_long.csv"),
              HasSubstr("P02,withdrawn,withdrawn,session withdrawn,background,"));
  EXPECT_EQ(read_file(folder_ / "out" / "report.html"), report);
  EXPECT_EQ(read_file(folder_ / "out" / "times_by_scene.csv"), times);
  for (const std::filesystem::path& file : output.files) {
    if (file.string().find("psych-ds") != std::string::npos) {
      EXPECT_THAT(read_file(file), Not(HasSubstr("P02"))) << file;
    }
  }
}

/// A formula as a participant's code and as a comment: as the codebook says, files for people have
/// it guarded, and those that programs read as it was typed.
TEST_F(RecordedTimings, FormulasAreGuardedWhereTheCodebookSaysSo) {
  {
    study::StudyStore store(path_, study::thorough_protocol());
    study::run_thorough_session(store, "P01");
    study::run_thorough_session(
        store, "=1+1",
        study::QuestionnaireAnswered{.questionnaire = "debrief",
                                     .answers = {{.question = "sickness", .value = 2.0},
                                                 {.question = "comments", .value = "=2+2"}}});
  }
  const AnalysisOutput output = analyze_study(path_, folder_ / "out", {.writes_bids = true});
  std::map<std::string, bool> is_guarded;
  for (const CsvRow& row : rows_in("codebook.csv")) {
    is_guarded[row.at(0)] = row.at(5) == "TRUE";
  }
  std::map<std::string, int> formulas;
  for (const std::filesystem::path& file : output.files) {
    if (file.extension() != ".csv") {
      continue;
    }
    const bool is_psych_ds = file.string().find("psych-ds") != std::string::npos;
    const std::string name = file.stem().string();
    for (const CsvRow& row : parse_csv(read_file(file), name)) {
      for (const std::string& cell : row) {
        const bool is_formula = cell == "=1+1" || cell == "=2+2";
        const bool is_guarded_formula = cell == "'=1+1" || cell == "'=2+2";
        formulas[name] += is_formula || is_guarded_formula ? 1 : 0;
        EXPECT_FALSE(is_guarded_formula && (is_psych_ds || !is_guarded.at(name))) << file;
        EXPECT_FALSE(is_formula && !is_psych_ds && (name == "codebook" || is_guarded.at(name)))
            << file;
      }
    }
  }
  for (const char* name : {"answers_long", "catch_trials", "trials_long", "participants_wide",
                           "study-small_type-trials_data"}) {
    EXPECT_GT(formulas[name], 0) << name;
  }
}

TEST_F(RecordedTimings, OfExcludedSessionsComeOutToo) {
  {
    study::StudyStore store(path_, study::thorough_protocol());
    study::run_thorough_session(store, "P01");
    study::run_thorough_session(
        store, "P02",
        study::QuestionnaireAnswered{.questionnaire = "debrief",
                                     .answers = {{.question = "sickness", .value = 2.0},
                                                 {.question = "comments", .value = "a, \"b\""}}});
  }
  (void)analyze_study(path_, folder_ / "out");
  // Practice, a catch trial and four test trials of each session.
  const std::vector<CsvRow> counted = rows_in("trials_long.csv");
  ASSERT_EQ(counted.size(), 1U + 2U * 6U);
  EXPECT_THAT(std::vector<std::string>(counted[1].begin(), counted[1].begin() + 4),
              ElementsAre("P01", "simulated", "excluded", "practice"));
  EXPECT_THAT(std::vector<std::string>(counted[2].begin(), counted[2].begin() + 4),
              ElementsAre("P01", "simulated", "excluded", "excluded"));
  EXPECT_EQ(rows_in("trials_timed_again.csv").size(), 1U + 2U * 3U);
  const std::string answers = read_file(folder_ / "out" / "answers_long.csv");
  EXPECT_THAT(answers, HasSubstr("P02,completed,analysed,,debrief,"));
  EXPECT_THAT(answers, HasSubstr(",comments,,\"a, \"\"b\"\"\",,,,simulated,verified\r\n"));
  EXPECT_EQ(rows_in("catch_trials.csv").at(1).at(0), "P02");
}

}  // namespace
}  // namespace foveola::analysis
