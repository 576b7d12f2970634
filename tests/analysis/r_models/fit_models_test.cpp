#include "analysis/r_models/fit_models.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "analysis/dataset/comparisons.h"
#include "analysis/monte_carlo/expected_study.h"
#include "analysis/monte_carlo/model_coverage.h"
#include "analysis/r_models/models_plan.h"
#include "analysis/r_models/models_script.h"
#include "analysis/tables/table_formats.h"
#include "renderer/base/error.h"
#include "tests/analysis/made_up_study.h"
#include "tests/matchers.h"
#include "tests/temporary_folder.h"

namespace foveola::analysis {
namespace {

using testing::Pair;

constexpr const char* heading =
    "measure,method,reference,model,scale,estimate,standard_error,degrees_of_freedom,low,high,p,"
    "trials,participants,scenes,censored,participant_sd,scene_sd,residual_sd,without_one_low,"
    "low_without,without_one_high,high_without,note\n";
constexpr const char* no_versions = "name,version\n";

TEST(ReadModels, HasWhatTheScriptWrote) {
  const FittedModels models = read_models(
      std::string(heading) +
          "outline,fv,od,tobit,ratio,-0.7,0.1,15,-0.9,-0.5,1e-05,160,16,5,21,,,0.4,"
          "-0.8,P3,-0.6,P1,\n"
          "artifacts,\"fv\",od,ordinal,odds ratio,,,,,,,160,16,5,0,,,,,,,,\"all, answers "
          "are the same\"\n"
          "comfort,fv,od,ordinal,odds ratio,-Inf,,79,-Inf,-2.5,1e-08,160,16,5,0,,,,,,,,"
          "separated\n",
      "name,version\nR,4.2.2\nsurvival,3.5.3\n");
  ASSERT_EQ(models.models.size(), 3U);
  const FittedModel* tobit = models.find("tobit", "outline", "fv", "od");
  ASSERT_NE(tobit, nullptr);
  EXPECT_EQ(tobit->fit->estimate, -0.7);
  EXPECT_EQ(tobit->fit->interval->high, -0.5);
  EXPECT_EQ(tobit->influence->estimates.low, -0.8);
  EXPECT_EQ(tobit->influence->without_high, "P1");
  const FittedModel* separated = models.find("ordinal", "comfort", "fv", "od");
  EXPECT_EQ(in_scale(EffectScale::odds_ratio, separated->fit->estimate), 0.0);
  EXPECT_EQ(in_scale(EffectScale::odds_ratio, *separated->fit->interval).low, 0.0);
  EXPECT_FALSE(separated->fit->standard_error || separated->influence);
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
  EXPECT_THAT(complaint(std::string(heading) + "a,b,c,d,ratio,x,,,,,,,,,,,,,,,,,\n"),
              HasSubstr("\"x\" in the column estimate is not a number"));
  EXPECT_THAT(complaint(std::string(heading) + "a,b,c,d,stars,,,,,,,1,1,1,0,,,,,,,,\n"),
              HasSubstr("\"stars\" is not a scale"));
  EXPECT_THAT(complaint(std::string(heading) + "a,b,c,d,ratio,,,,,,,Inf,1,1,0,,,,,,,,\n"),
              HasSubstr("\"Inf\" in the column trials is not a count"));
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
  EXPECT_THAT(text, StartsWith("measure,kind,method,reference,scenes,detail\r\n"
                               "material,time,od,vp,fixed,full\r\noutline,time,vp,od,fixed"));
  EXPECT_THAT(text, HasSubstr("artifacts,points,fv,vp,fixed,full\r\n"));
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

study::StudyRecords noisy_study() {
  ExpectedStudy expected = example_study();
  study::AnalysisPlan& plan = expected.protocol.analysis;
  for (const char* mark : {"outline", "material", "recognition"}) {
    for (const auto& [method, reference] : {std::pair("vp", "od"), std::pair("fv", "vp")}) {
      plan.primary.push_back({mark, method, reference});
    }
  }
  plan.primary.push_back({"artifacts", "fv", "od"});
  return draw_study(expected, 12, 3);
}

/// With the share of the longest time of the mark above which its times are right-censored.
study::StudyRecords censored_study(double share, study::SceneEffects scenes) {
  study::StudyRecords records = noisy_study();
  records.protocol.analysis.primary = {{"outline", "vp", "od"}, {"outline", "fv", "vp"}};
  records.protocol.analysis.scenes = scenes;
  double longest = 0.0;
  change_values(records, "outline",
                [&](Value& value) { longest = std::max(longest, value.number); });
  change_values(records, "outline", [&](Value& value) {
    value = value.number > share * longest ? right_censored(share * longest) : value;
  });
  return records;
}

study::StudyRecords study_of_one() {
  study::StudyRecords records = complete_study(1);
  records.protocol.analysis.primary = {{"material", "fv", "od"}, {"artifacts", "vp", "od"}};
  return records;
}

TEST(FitModels, AgreeWithTheClosedFormInABalancedStudy) {
  const study::StudyRecords records = noisy_study();
  const std::vector<FittedModels> fitted = fit_studies({records});
  if (const std::string why = missing_for(fitted.front()); !why.empty()) {
    GTEST_SKIP() << why;
  }
  const FittedModels& models = fitted.front();
  const std::vector<MethodComparison> rows =
      planned_primary_analyses(select_for_analysis(records), records.protocol.analysis);
  int compared = 0;
  for (const MethodComparison& row : rows) {
    if (row.is_time) {
      const FittedModel* model = models.find("crossed", row.measure, row.method, row.reference);
      ASSERT_NE(model, nullptr) << row.measure;
      EXPECT_NEAR(model->fit->estimate, row.primary->estimate, 1e-6) << row.measure;
      // Where a component is 0, R's optimizer may stop beside it, with other degrees of freedom.
      if (*model->participant_sd > 0.01 && *model->scene_sd > 0.01) {
        EXPECT_NEAR(model->fit->interval->low, row.primary->interval->low, 1e-3) << row.measure;
      }
      EXPECT_EQ(model->trials, 2 * row.pairs);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 6);
  const FittedModel* ordinal = models.find("ordinal", "artifacts", "fv", "od");
  // Its people and scenes are no more than there are of them.
  EXPECT_LE(*ordinal->fit->degrees_of_freedom, 12.0 * 5.0 - 1.0);
  EXPECT_EQ(models.find("tobit", "outline", "vp", "od"), nullptr);
}

TEST(FitModels, WithRandomScenesATobitModelIsOfOtherScenesToo) {
  study::StudyRecords uncensored = noisy_study();
  uncensored.protocol.analysis.primary = {{"outline", "vp", "od"}};
  const std::vector<FittedModels> fitted =
      fit_studies({uncensored, censored_study(0.999, study::SceneEffects::random)});
  if (const std::string why = missing_for(fitted.front()); !why.empty()) {
    GTEST_SKIP() << why;
  }
  const FittedModel* crossed = fitted[0].find("crossed", "outline", "vp", "od");
  const FittedModel* tobit = fitted[1].find("tobit", "outline", "vp", "od");
  ASSERT_NE(tobit, nullptr);
  EXPECT_EQ(tobit->censored, 1U);
  EXPECT_NEAR(tobit->fit->estimate, crossed->fit->estimate, 0.01);
  EXPECT_NEAR(*tobit->fit->standard_error, *crossed->fit->standard_error, 0.003);
  EXPECT_NEAR(*tobit->fit->degrees_of_freedom, *crossed->fit->degrees_of_freedom, 2.0);
}

TEST(FitModels, TakeRightCensoredTimesForWhatTheyAre) {
  const std::vector<FittedModels> fitted =
      fit_studies({censored_study(0.1, study::SceneEffects::random),
                   censored_study(0.1, study::SceneEffects::fixed)});
  if (const std::string why = missing_for(fitted.front()); !why.empty()) {
    GTEST_SKIP() << why;
  }
  const FittedModel* random = fitted[0].find("tobit", "outline", "fv", "vp");
  const FittedModel* fixed = fitted[1].find("tobit", "outline", "fv", "vp");
  EXPECT_GT(random->censored, 10U);
  EXPECT_NEAR(random->fit->estimate, fixed->fit->estimate, 0.1);
  EXPECT_TRUE(random->scene_sd);
  EXPECT_FALSE(fixed->scene_sd);
  EXPECT_EQ(*fixed->fit->degrees_of_freedom, static_cast<double>(fixed->participants) - 1.0);
  // What is left without the pairs that have a censored time is a smaller difference.
  const FittedModel* crossed = fitted[1].find("crossed", "outline", "fv", "vp");
  EXPECT_LT(random->fit->estimate, crossed->fit->estimate);
}

// Wald's P was 0.95, of an odds ratio of 2.9e10. Wilcoxon's exact P of twelve differences of one
// sign is 2 / 2^12.
TEST(FitModels, SeparatedRatingsHaveALikelihoodRatio) {
  study::StudyRecords records = noisy_study();
  records.protocol.analysis.primary = {{"artifacts", "fv", "od"}};
  records.protocol.analysis.scenes = study::SceneEffects::fixed;
  change_values(records, "artifacts", [&, i = std::size_t{0}](Value& value) mutable {
    const double of_method = records.trials[i].method == 0 ? 1.0 : 2.0;
    value = measured(of_method + static_cast<double>((i * i / 3) % 2));
    ++i;
  });
  const std::vector<FittedModels> fitted = fit_studies({records});
  if (const std::string why = missing_for(fitted.front()); !why.empty()) {
    GTEST_SKIP() << why;
  }
  const FittedModel* model = fitted.front().find("ordinal", "artifacts", "fv", "od");
  ASSERT_TRUE(model->fit) << model->note;
  EXPECT_TRUE(std::isinf(model->fit->estimate));
  EXPECT_LT(model->fit->p, 2.0 / 4096.0);
  EXPECT_GT(model->fit->p, 1e-12);
  EXPECT_FALSE(model->fit->standard_error);
  EXPECT_THAT(model->note, HasSubstr("ratings are separated"));
}

// Each participant has one ratio, to the last digit, in both scenes: lmerTest gives 0.015 degrees
// of freedom, with which t is 4.8 and P 0.94.
TEST(FitModels, AFitThatFailedHasNoP) {
  study::StudyRecords records = complete_study(6);
  records.protocol.analysis.primary = {{"outline", "fv", "od"}};
  records.protocol.analysis.scenes = study::SceneEffects::random;
  change_values(records, "outline", [&, i = std::size_t{0}](Value& value) mutable {
    const study::TrialRow& row = records.trials[i++];
    value = measured(row.method == 0 ? 1.0 : std::ldexp(1.0, static_cast<int>(row.session)));
  });
  const std::vector<FittedModels> fitted = fit_studies({records});
  if (const std::string why = missing_for(fitted.front()); !why.empty()) {
    GTEST_SKIP() << why;
  }
  const FittedModel* model = fitted.front().find("crossed", "outline", "fv", "od");
  EXPECT_FALSE(model->fit);
  EXPECT_THAT(model->note, HasSubstr("the fit failed ("));
}

TEST(FitModels, WhatCannotBeFittedSaysWhy) {
  const std::vector<FittedModels> fitted = fit_studies({study_of_one()});
  if (const std::string why = missing_for(fitted.front()); !why.empty()) {
    GTEST_SKIP() << why;
  }
  const FittedModels& models = fitted.front();
  EXPECT_EQ(models.models.size(), 2U);
  for (const FittedModel& model : models.models) {
    EXPECT_FALSE(model.fit);
    EXPECT_EQ(model.note, "fewer than two participants");
  }
}

/// A wrapper that hides a failure.
TEST(FitModels, AnRThatWritesNothingIsSaidAndFitsNothing) {
  const test::TemporaryFolder folder;
  folder.write("Rscript", "#!/bin/sh\n");
  std::filesystem::permissions(folder / "Rscript", std::filesystem::perms::owner_all);
  const std::string before = std::getenv("PATH");
  ::setenv("PATH", folder.path().c_str(), 1);
  const FittedModels fitted = fit_models(folder.path());
  ::setenv("PATH", before.c_str(), 1);
  EXPECT_TRUE(fitted.models.empty());
  EXPECT_THAT(fitted.missing, HasSubstr("R wrote no models"));
}

}  // namespace
}  // namespace foveola::analysis
