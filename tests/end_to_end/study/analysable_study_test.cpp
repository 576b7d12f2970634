// Whatever a protocol measures is analysed, and everything that was recorded comes out.
#include <algorithm>

#include <fmt/format.h>

#include "renderer/base/files/files.h"
#include "tests/end_to_end/hall.h"
#include "tests/end_to_end/study/named_columns.h"
#include "tests/end_to_end/study_rows.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

class AnalysableStudy : public testing::Test, protected Hall {
 protected:
  AnalysableStudy() { std::filesystem::create_directory(own_folder()); }

  std::filesystem::path own_folder() const { return folder / "own"; }
  std::string path_of(const char* name) const { return (own_folder() / name).string(); }

  /// The hall's, with two methods to compare.
  void write_protocol(const std::string& tables) const {
    const std::string one = "methods = [\"od\"]";
    std::string text = hall_protocol() + tables;
    text.replace(text.find(one), one.size(), "methods = [\"od\", \"fv\"]");
    write_file(path_of("p.toml"), text);
  }

  ProgramResult check() const { return run({"study", "check", path_of("p.toml")}); }
  ProgramResult simulate(const std::vector<std::string>& options = {}) const {
    return run(joined({"study", "simulate", path_of("p.toml"), "--db", path_of("study.sqlite"),
                       "--participants", "2", "--predicted"},
                      options));
  }
  std::vector<NamedFields> rows_in(const std::string& name) const {
    return rows_of_csv(own_folder() / "out" / name);
  }
  Rows recorded(const std::string& sql) const {
    return all_rows_of(path_of("study.sqlite"), sql + " ORDER BY 1");
  }
};

Rows sorted(Rows rows) {
  std::sort(rows.begin(), rows.end());
  return rows;
}

/// SQL for a number or a text: the same as printed() of what a CSV file has.
std::string sql_printed(const std::string& column) {
  return "CASE typeof(" + column + ") WHEN 'text' THEN " + column + " ELSE printf('%.9f', " +
         column + ") END";
}

std::string printed(const std::string& number) { return fmt::format("{:.9f}", std::stod(number)); }

/// Three marks, ratings of 0 to 100, 1 to 7 and a choice with 0.5, a questionnaire with a published
/// key and one in words, practice, catch trials, and planned comparisons on all kinds of measures.
constexpr const char* every_measure = R"(
[[mark]]
id = "outline"
instruction = "When is it there?"

[[mark]]
id = "sharp"
instruction = "When is it sharp?"

[[mark]]
id = "third"
instruction = "Now."

[[rating]]
id = "comfort"
text = "How comfortable?"
minimum = 0
maximum = 100
labels = ["not at all", "very"]

[[rating]]
id = "effort"
text = "How hard?"
maximum = 7

[[rating]]
id = "noise"
text = "How noisy?"
kind = "choice"
options = [{ label = "none", value = 0 }, { label = "a little", value = 0.5 },
           { label = "much", value = 2 }]

[[questionnaire]]
id = "load"
file = "nasa-tlx"

[[questionnaire]]
id = "remarks"
title = "Anything else?"
[[questionnaire.question]]
id = "free"
text = "What else?"
kind = "text"

[[practice]]
scene = "hall"
method = "od"

[catch_trials]
count = 2
timeout_s = 1

[analysis]
scenes = "fixed"
participants = 3
equivalence_margins = { comfort = 10, third = 1.2 }
[[analysis.primary]]
measure = "noise"
method = "fv"
[[analysis.primary]]
measure = "third"
method = "od"
baseline = "fv"
[[analysis.primary]]
measure = "comfort"
method = "fv"
[[analysis.primary]]
measure = "effort"
method = "fv"
)";

class EveryMeasure : public AnalysableStudy {
 protected:
  EveryMeasure() {
    folder.write("share/protocols/questionnaires/nasa-tlx.toml",
                 read_file(std::filesystem::path(TEST_DATA_DIR) /
                           "../../protocols/questionnaires/nasa-tlx.toml"));
    write_protocol(every_measure);
    succeeded(simulate({"--inject", "order:1"}));
    succeeded(run_foveola({"analyze", path_of("study.sqlite"), "-o", path_of("out")}));
  }

  /// Of every timing, whether it counts or not.
  std::vector<NamedFields> timings() const {
    std::vector<NamedFields> rows = rows_in("trials_long.csv");
    for (auto& row : rows_in("trials_timed_again.csv")) {
      rows.push_back(std::move(row));
    }
    return rows;
  }
};

TEST_F(EveryMeasure, PassesTheCheckWithoutAWarning) { EXPECT_THAT(check().errors, IsEmpty()); }

// Value by value, both ways: the sorted lists are equal.
TEST_F(EveryMeasure, EveryTrialAndTimingIsExportedAndNothingElse) {
  Rows planned;
  Rows attempts;
  for (auto& row : timings()) {
    const std::string trial = row["participant"] + "/" + row["trial"];
    planned.push_back(trial + "/" + row["trial_kind"] + "/" + row["scene"] + "/" + row["method"]);
    if (row["attempt"] != "0") {
      attempts.push_back(trial + "/" + row["attempt"] + "/" + row["object"] + "/" + row["outcome"]);
    }
  }
  planned = sorted(planned);
  planned.erase(std::unique(planned.begin(), planned.end()), planned.end());
  EXPECT_EQ(planned, sorted(recorded("SELECT participant || '/' || trial || '/' ||"
                                     " planned_trial.kind || '/' || scene || '/' || method"
                                     " FROM planned_trial JOIN session ON session.id = session")));
  EXPECT_EQ(planned.size(), 2U * (2 + 1 + 2));
  EXPECT_EQ(sorted(attempts),
            sorted(recorded("SELECT participant || '/' || trial || '/' || attempt || '/' ||"
                            " coalesce(object, '') || '/' || coalesce(outcome, '')"
                            " FROM attempt JOIN session ON session.id = session")));
}

TEST_F(EveryMeasure, EveryMarkIsExportedAndNothingElse) {
  Rows marks;
  for (auto& row : timings()) {
    for (const std::string mark : {"outline", "sharp", "third"}) {
      if (!row[mark + "_s"].empty()) {
        marks.push_back(row["participant"] + "/" + row["trial"] + "/" + row["attempt"] + "/" +
                        mark + "/" + printed(row[mark + "_s"]) + "/" +
                        (row[mark + "_censored"] == "TRUE" ? "1" : "0"));
      }
    }
  }
  EXPECT_EQ(sorted(marks),
            sorted(recorded("SELECT participant || '/' || trial || '/' || attempt || '/' ||"
                            " mark.kind || '/' || printf('%.9f', time_ns / 1e9) || '/' || censored"
                            " FROM mark JOIN session ON session.id = session")));
  EXPECT_GE(marks.size(), 2U * 2U * 3U);
}

TEST_F(EveryMeasure, EveryRatingIsExportedAndNothingElse) {
  Rows ratings;
  for (auto& row : timings()) {
    for (const std::string rating : {"comfort", "effort", "noise"}) {
      if (!row[rating + "_rating"].empty()) {
        ratings.push_back(row["participant"] + "/" + row["trial"] + "/" + row["attempt"] + "/" +
                          rating + "/" + printed(row[rating + "_rating"]));
      }
    }
  }
  EXPECT_EQ(
      sorted(ratings),
      sorted(recorded("SELECT participant || '/' || trial || '/' || attempt || '/' ||"
                      " question || '/' || " +
                      sql_printed("value") + " FROM rating JOIN session ON session.id = session")));
  EXPECT_GE(ratings.size(), 2U * 2U * 3U);
}

TEST_F(EveryMeasure, EveryAnswerIsExportedAndNothingElse) {
  Rows answers;
  for (auto& row : rows_in("answers_long.csv")) {
    answers.push_back(row["participant"] + "/" + row["step"] + "/" + row["questionnaire"] + "/" +
                      row["question"] + "/" +
                      (row["number"].empty() ? row["text"] : printed(row["number"])));
  }
  EXPECT_EQ(sorted(answers),
            sorted(recorded("SELECT participant || '/' || step || '/' || questionnaire || '/' ||"
                            " question || '/' || coalesce(text, printf('%.9f', number))"
                            " FROM questionnaire_answer JOIN session ON session.id = session")));
  EXPECT_GE(answers.size(), 2U * 6U);
  EXPECT_EQ(rows_in("questionnaire_scores.csv").size(), 2U);
}

TEST_F(EveryMeasure, PlannedComparisonsComeFirstInTheirOrder) {
  Rows planned;
  for (auto& row : rows_in("comparisons.csv")) {
    if (row["status"] == "planned") {
      planned.push_back(row["measure"] + " " + row["method"] + " " + row["reference"]);
      EXPECT_NE(row["p_holm"].empty(), row["missing"].empty()) << planned.back();
    }
  }
  EXPECT_THAT(planned, ElementsAre("noise fv od", "third od fv", "comfort fv od", "effort fv od"));
}

TEST_F(AnalysableStudy, AForgottenParticipantIsInNoFileOfTheNextAnalysis) {
  write_protocol("");
  const std::string study = path_of("study.sqlite");
  ASSERT_EQ(
      run({"study", "simulate", path_of("p.toml"), "--db", study, "--participants", "2"}).exit_code,
      0);
  const auto files_of_p001 = [&] {
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path_of("out"))) {
      if (entry.path().filename().string().find("P001") != std::string::npos ||
          (entry.is_regular_file() && read_file(entry.path()).find("P001") != std::string::npos)) {
        files.push_back(entry.path());
      }
    }
    return files;
  };
  const std::vector<std::string> analyse = {"analyze", study, "--bids", "-o", path_of("out")};
  succeeded(run_foveola(analyse));
  EXPECT_THAT(files_of_p001(), Contains(HasSubstr("recording-eye1_physio.tsv.gz")));
  const ProgramResult forgotten = run({"study", "forget", study, "P001", "--yes"});
  EXPECT_EQ(forgotten.exit_code, 1) << "the analysis still holds the participant";
  EXPECT_THAT(forgotten.output, HasSubstr("recording-eye1_physio.tsv.gz: is named after P001\n"));
  succeeded(run_foveola(analyse));
  EXPECT_THAT(files_of_p001(), IsEmpty());
  EXPECT_TRUE(std::filesystem::exists(path_of("out/bids/participants.tsv")));
}

}  // namespace
}  // namespace foveola::test
