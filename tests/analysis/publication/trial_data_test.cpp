#include "analysis/publication/trial_data.h"

#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "renderer/base/csv.h"
#include "tests/analysis/made_up_study.h"

namespace foveola::analysis {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

TEST(TrialData, TheLongTableHasARowForEveryPlannedTrial) {
  const StudyTables tables = tabulate_study(golden_study_records());
  const std::vector<CsvRow> rows = parse_csv(trials_long_csv(tables.set), "long");
  ASSERT_EQ(rows.size(), 1U + 8U * 3U * 3U);
  EXPECT_THAT(rows, Each(SizeIs(trial_variables({}).size())));
  EXPECT_THAT(rows[0],
              ElementsAre("participant", "participant_kind", "scene", "method", "trial_position",
                          "method_position", "attempts", "outline_s", "outline_censored",
                          "material_s", "material_censored", "artifacts_rating"));
  EXPECT_THAT(rows[1], ElementsAre("P01", "human", "aula", "od", "0", "0", "1", "8.0041", "false",
                                   "12.0567", "false", "2"));
}

TEST(TrialData, RightCensoredTimesAreBoundsAndMissingOnesAreEmpty) {
  const StudyTables tables = tabulate_study(golden_study_records());
  const std::vector<CsvRow> rows = parse_csv(trials_long_csv(tables.set), "long");
  const CsvRow& ran_out = rows.at(1 + 2 * 9);
  EXPECT_EQ(ran_out.at(0), "P03");
  EXPECT_EQ(ran_out.at(7), "60");
  EXPECT_EQ(ran_out.at(8), "true");
  const CsvRow& missing = rows.at(1 + 9 + 1);
  EXPECT_THAT(missing,
              ElementsAre("P02", "human", "aula", "vp", "0", "0", "0", "", "", "", "", ""));
}

TEST(TrialData, TheWideTableHasARowForEveryParticipant) {
  const study::StudyRecords records = golden_study_records();
  const StudyTables tables = tabulate_study(records);
  const std::vector<CsvRow> rows =
      parse_csv(participants_wide_csv(tables.set, records.background), "wide");
  ASSERT_EQ(rows.size(), 9U);
  EXPECT_THAT(rows, Each(SizeIs(2 + 3 * 3 * 5 + 3)));
  EXPECT_EQ(rows[0][2], "outline_s.aula.od");
  EXPECT_EQ(rows[0].back(), "background.virtual_reality");
  EXPECT_EQ(rows[1].back(), "3");
}

TEST(TrialData, TheCodebookNamesEveryColumn) {
  const std::vector<CsvRow> rows = parse_csv(codebook_csv({}), "codebook");
  ASSERT_EQ(rows.size(), 1U + trial_variables({}).size());
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].at(0), trial_variables({})[i - 1].name);
    EXPECT_FALSE(rows[i].at(3).empty());
  }
}

TEST(TrialData, PsychDsDescribesItsVariables) {
  study::StudyRecords records = complete_study(2);
  records.protocol_name = "my study/2";
  for (study::SessionRow& session : records.sessions) {
    session.kind = "simulated";
  }
  const PsychDs shared = psych_ds(tabulate_study(records), records.background);
  const nlohmann::json json = nlohmann::json::parse(shared.description.content);
  EXPECT_EQ(json["@type"], "Dataset");
  std::set<std::string> described;
  for (const nlohmann::json& variable : json["variableMeasured"]) {
    EXPECT_TRUE(described.insert(variable["name"]).second) << variable["name"];
    EXPECT_FALSE(variable["description"].get<std::string>().empty());
  }
  std::set<std::string> columns;
  const AnalysisSet set = select_for_analysis(records);
  for (const std::string& file :
       {trials_long_csv(set), participants_wide_csv(set, records.background)}) {
    const CsvRow heading = parse_csv(file, "data").at(0);
    columns.insert(heading.begin(), heading.end());
  }
  EXPECT_EQ(described, columns);
  EXPECT_TRUE(columns.contains("material_s.barn.fv"));
  EXPECT_TRUE(columns.contains("background.graphics_3d"));
  EXPECT_THAT(json["description"].get<std::string>(), HasSubstr("Simulated data"));
  EXPECT_EQ(shared.trials_name, "psych-ds/data/study-mystudy2_type-trials_data.csv");
}

TEST(TrialData, ScriptsReadTheLongTable) {
  for (const TextFile& script : r_scripts()) {
    EXPECT_THAT(script.content, HasSubstr("read.csv(\"trials_long.csv\""));
  }
}

// Trials of one participant with one method, and of one scene with one method, are alike: a model
// without these random effects takes each trial for one more participant.
std::string r_script(const std::string& name) {
  for (const TextFile& file : r_scripts()) {
    if (file.name == name) {
      return file.content;
    }
  }
  ADD_FAILURE() << "no " << name;
  return {};
}

TEST(TrialData, NoModelTakesTrialsForParticipants) {
  for (const char* name : {"models_times.R", "models_ratings.R"}) {
    for (const char* effect :
         {"(1 | participant)", "(1 | participant:method)", "(1 | scene)", "(1 | scene:method)"}) {
      EXPECT_THAT(r_script(name), HasSubstr(effect)) << name;
    }
  }
  EXPECT_THAT(r_script("models_times.R"), Not(HasSubstr("method * scene")));
  EXPECT_THAT(r_script("models_times.R"), HasSubstr("emmeans(model, ~ method"));
}

}  // namespace
}  // namespace foveola::analysis
