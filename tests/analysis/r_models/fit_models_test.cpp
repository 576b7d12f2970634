#include "analysis/r_models/fit_models.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/monte_carlo/expected_study.h"
#include "analysis/publication/row_file.h"
#include "analysis/publication/trial_data.h"
#include "analysis/r_models/models_plan.h"
#include "analysis/r_models/models_script.h"
#include "analysis/tables/table_formats.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "tests/analysis/made_up_study.h"
#include "tests/temporary_folder.h"

namespace foveola::analysis {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

constexpr const char* heading =
    "measure,method,reference,model,scale,estimate,standard_error,degrees_of_freedom,low,high,p,"
    "trials,participants,scenes,censored,participant_sd,scene_sd,residual_sd,note\n";
constexpr const char* no_versions = "name,version\n";

TEST(ReadModels, HasWhatTheScriptWrote) {
  const FittedModels models =
      read_models(std::string(heading) +
                      "outline,fv,od,tobit,ratio,-0.7,0.1,15,-0.9,-0.5,1e-05,160,16,5,21,,,0.4,\n"
                      "artifacts,\"fv\",od,ordinal,odds ratio,,,,,,,160,16,5,0,,,,\"all, answers "
                      "are the same\"\n",
                  "name,version\nR,4.2.2\nsurvival,3.5.3\n");
  ASSERT_EQ(models.models.size(), 2U);
  const FittedModel* tobit = models.find("tobit", "outline", "fv", "od");
  ASSERT_NE(tobit, nullptr);
  EXPECT_EQ(tobit->fit->estimate, -0.7);
  EXPECT_EQ(tobit->fit->interval.high, -0.5);
  EXPECT_EQ(tobit->fit->p, 1e-5);
  EXPECT_EQ(tobit->censored, 21U);
  EXPECT_FALSE(tobit->scene_sd);
  EXPECT_FALSE(models.find("ordinal", "artifacts", "fv", "od")->fit);
  EXPECT_EQ(models.find("ordinal", "artifacts", "vp", "od"), nullptr);
  EXPECT_EQ(models.models[1].note, "all, answers are the same");
  EXPECT_THAT(models.versions, ElementsAre(Pair("R", "4.2.2"), Pair("survival", "3.5.3")));
}

std::string complaint(const std::string& models_csv) {
  try {
    (void)read_models(models_csv, no_versions);
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(ReadModels, RefusesWhatTheScriptDoesNotWrite) {
  EXPECT_THAT(complaint(""), HasSubstr("r_models.csv: is empty"));
  EXPECT_THAT(complaint("measure\noutline,fv\n"), HasSubstr("a row has 2 fields"));
  EXPECT_THAT(complaint("measure\noutline\n"), HasSubstr("has no column"));
  EXPECT_THAT(complaint(std::string(heading) + "a,b,c,d,ratio,x,,,,,,,,,,,,,\n"),
              HasSubstr("\"x\" in the column estimate is no number"));
  EXPECT_THAT(complaint(std::string(heading) + "a,b,c,d,stars,,,,,,,1,1,1,0,,,,\n"),
              HasSubstr("\"stars\" is no scale"));
  EXPECT_THAT(complaint(std::string(heading) + "a,b,c,d,ratio,,,,,,,Inf,1,1,0,,,,\n"),
              HasSubstr("\"Inf\" in the column trials is no count"));
}

TEST(MissingFor, NamesThePackagesThatRDoesNotHave) {
  EXPECT_EQ(missing_for({.missing = "R is not installed"}), "R is not installed");
  FittedModels models{.versions = {{"R", "4.2.2"}, {"lme4", "1"}, {"lmerTest", "3"}}};
  EXPECT_THAT(missing_for(models), HasSubstr("no package survival and no ordinal (apt-get"));
  models.versions.insert(models.versions.end(), {{"survival", "3"}, {"ordinal", "1"}});
  EXPECT_EQ(missing_for(models), "");
}

TEST(ModelsPlan, HasEveryPairWithItsKind) {
  const Dataset set = select_for_analysis(complete_study(3));
  study::AnalysisPlan plan;
  plan.primary = {{"material", "od", "vp"}};
  const std::string text =
      csv_of(models_plan(set, compared_pairs(set, plan), study::SceneEffects::fixed));
  EXPECT_THAT(text, testing::StartsWith("measure,kind,method,reference,scenes\r\n"
                                        "material,time,od,vp,fixed\r\noutline,time,vp,od,fixed"));
  EXPECT_THAT(text, HasSubstr("artifacts,points,fv,vp,fixed\r\n"));
}

// Trials of one participant with one method, and of one scene with one method, are alike: a model
// without these random effects takes each trial for one more participant.
TEST(ModelsScript, NoModelTakesTrialsForParticipants) {
  for (const char* effect :
       {"difference ~ 1 + (1 | participant) + (1 | scene)", "(1 | participant:method)",
        "(1 | scene:method)", "rowsum(rows$influence, rows$participant)"}) {
    EXPECT_THAT(models_script(), HasSubstr(effect));
  }
}

study::StudyRecords noisy_study() { return draw_study(example_study(), 12, 3); }

/// A folder with the trials of a study, and the script that fits their models.
void write_study(const study::StudyRecords& records, const std::filesystem::path& folder) {
  const Dataset set = select_for_analysis(records);
  const TrialColumns trials(records, set);
  RowFile file(folder / "trials_long.csv", trials.columns());
  for (std::size_t i = 0; i < records.trials.size(); ++i) {
    file.add(trials.row(i));
  }
  file.close();
  write_file(folder / "models.R", models_script());
  write_file(folder / "models_plan.csv",
             csv_of(models_plan(set, compared_pairs(set, {}), study::SceneEffects::random)));
}

FittedModels fit(const study::StudyRecords& records) {
  const test::TemporaryFolder folder;
  write_study(records, folder.path());
  return fit_models(folder.path());
}

TEST(FitModels, AgreeWithTheClosedFormInABalancedStudy) {
  const study::StudyRecords records = noisy_study();
  const FittedModels models = fit(records);
  if (const std::string why = missing_for(models); !why.empty()) {
    GTEST_SKIP() << why;
  }
  const Comparisons comparisons = compare_methods(select_for_analysis(records), {});
  int compared = 0;
  for (const MethodComparison& row : comparisons.methods) {
    if (row.is_time) {
      const FittedModel* model = models.find("crossed", row.measure, row.method, row.reference);
      ASSERT_NE(model, nullptr) << row.measure;
      EXPECT_NEAR(model->fit->estimate, row.primary->estimate, 1e-6) << row.measure;
      // Where a component is 0, R's optimizer may stop beside it, with other degrees of freedom.
      if (*model->participant_sd > 0.01 && *model->scene_sd > 0.01) {
        EXPECT_NEAR(model->fit->interval.low, row.primary->interval->low, 1e-3) << row.measure;
      }
      EXPECT_EQ(model->trials, 2 * row.pairs);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 9);
  EXPECT_NE(models.find("ordinal", "artifacts", "fv", "od"), nullptr);
}

TEST(FitModels, TakeRightCensoredTimesForWhatTheyAre) {
  study::StudyRecords records = noisy_study();
  double longest = 0.0;
  change_values(records, "outline",
                [&](Value& value) { longest = std::max(longest, value.number); });
  change_values(records, "outline", [&](Value& value) {
    value = value.number > 0.6 * longest ? right_censored(0.6 * longest) : value;
  });
  const FittedModels models = fit(records);
  if (const std::string why = missing_for(models); !why.empty()) {
    GTEST_SKIP() << why;
  }
  const FittedModel* tobit = models.find("tobit", "outline", "fv", "od");
  ASSERT_NE(tobit, nullptr);
  EXPECT_GT(tobit->censored, 0U);
  EXPECT_EQ(models.find("tobit", "material", "fv", "od"), nullptr);
}

TEST(FitModels, WhatCannotBeFittedSaysWhy) {
  const FittedModels models = fit(complete_study(1));
  if (const std::string why = missing_for(models); !why.empty()) {
    GTEST_SKIP() << why;
  }
  for (const FittedModel& model : models.models) {
    EXPECT_FALSE(model.fit);
    EXPECT_EQ(model.note, "it needs two participants");
  }
}

}  // namespace
}  // namespace foveola::analysis
