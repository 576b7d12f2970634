// Studies with missing data: everything that can be computed is, and wherever a value cannot be,
// the reason is given.
#include <regex>
#include <string>

#include "analysis/publication/analyze_study.h"
#include "renderer/base/files/files.h"
#include "tests/analysis/made_up_study.h"
#include "tests/matchers.h"
#include "tests/temporary_folder.h"

namespace foveola::analysis {
namespace {

class BadInputRecords : public testing::Test {
 protected:
  AnalysisOutput analyze(const study::StudyRecords& records) {
    AnalysisOutput output = analyze_records(records, {}, results_, {.writes_bids = true});
    expect_no_stray_numbers(output);
    return output;
  }

  std::string written(const std::string& name) const { return read_file(results_ / name); }

 private:
  /// What is not a number is a dash, an empty field or null.
  static void expect_no_stray_numbers(const AnalysisOutput& output) {
    const std::regex stray("[^a-zA-Z](nan|inf)[^a-zA-Z]");
    EXPECT_FALSE(std::regex_search(output.summary, stray)) << output.summary;
    for (const std::filesystem::path& file : output.files) {
      if (file.extension() != ".png" && file.extension() != ".pdf" && file.extension() != ".gz") {
        EXPECT_FALSE(std::regex_search(read_file(file), stray)) << file;
      }
    }
  }

  const test::TemporaryFolder folder_;
  const std::filesystem::path results_ = folder_ / "results";
};

TEST_F(BadInputRecords, OneParticipantHasMeansWithoutDeviations) {
  const AnalysisOutput output = analyze(complete_study(1));
  EXPECT_TRUE(output.tables.scene_times.at(0).seconds.mean);
  EXPECT_FALSE(output.tables.scene_times.at(0).seconds.standard_deviation);
  EXPECT_FALSE(output.comparisons.methods.at(0).ratio);
  EXPECT_THAT(written("report.html"), HasSubstr("<td>–</td>"));
}

TEST_F(BadInputRecords, OneMethodHasTimesAndNoComparison) {
  const AnalysisOutput output = analyze(with_od_alone(complete_study(4)));
  EXPECT_TRUE(output.tables.method_times.at(0).seconds);
  EXPECT_TRUE(output.comparisons.methods.empty());
  EXPECT_THAT(written("report.html"), Not(HasSubstr("Comparisons of methods")));
}

TEST_F(BadInputRecords, OneSceneIsEnough) {
  study::StudyRecords records = complete_study(4);
  records.scenes = {"aula"};
  keep_trials(records, [](const study::TrialRow& row) { return row.scene == 0; });
  EXPECT_TRUE(analyze(records).comparisons.methods.at(0).ratio);
}

TEST_F(BadInputRecords, TimesThatAreAllRightCensoredAreCountedAndNotAveraged) {
  study::StudyRecords records = complete_study(4);
  for (const char* mark : {"outline", "material"}) {
    change_values(records, mark, [](study::Value& value) { value = right_censored(value.number); });
  }
  const AnalysisOutput output = analyze(records);
  EXPECT_EQ(output.tables.scene_times.at(0).censored, 4);
  EXPECT_FALSE(output.tables.scene_times.at(0).seconds.mean);
  EXPECT_FALSE(output.tables.method_times.at(0).seconds);
  EXPECT_THAT(written("report.html"), HasSubstr("48 × right-censored"));
}

TEST_F(BadInputRecords, NothingMeasuredIsStillAReport) {
  study::StudyRecords records = complete_study(3);
  records.values.assign(records.values.size(), {});
  records.answers.clear();
  const AnalysisOutput output = analyze(records);
  // Of the trials' three measures, and of each participant's background.
  EXPECT_EQ(output.tables.set.exclusions.size(), records.trials.size() * 3 + 3);
}

}  // namespace
}  // namespace foveola::analysis
