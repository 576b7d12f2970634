#include "analysis/dataset/comparisons.h"

#include <algorithm>
#include <cmath>

#include "tests/analysis/golden.h"
#include "tests/analysis/made_up_study.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

using study::StudyRecords;

study::AnalysisPlan fv_planned() {
  study::AnalysisPlan plan;
  plan.primary = {{"outline", "fv", "od"}};
  plan.equivalence_margins = {{"artifacts", 1.0}, {"outline", 1.5}};
  return plan;
}

Comparisons compare(const StudyRecords& records, const study::AnalysisPlan& plan = {}) {
  return compare_methods(select_for_analysis(records), plan);
}

/// A complete study with a third mark, `third`, at twice the outline's time, and a second rating,
/// `comfort` from 0 to 100.
StudyRecords study_with_more_measures(int participants) {
  StudyRecords records = complete_study(participants);
  const StudyRecords published = records;
  records.measures = study::trial_measures(
      {{"outline", "", ""}, {"material", "", ""}, {"third", "", ""}},
      {{.id = "artifacts"},
       {.id = "comfort", .kind = study::QuestionKind::number, .minimum = 0.0, .maximum = 100.0}});
  records.trials.clear();
  records.values.clear();
  for (std::size_t i = 0; i < published.trials.size(); ++i) {
    const double outline = published.value(i, outline_index).number;
    records.add_trial(published.trials[i],
                      {measured(outline), published.value(i, material_index),
                       measured(2.0 * outline), published.value(i, artifacts_index),
                       measured(20.0 * published.trials[i].method + 60.0 / outline)});
  }
  return records;
}

const MethodComparison& find(const Comparisons& comparisons, const std::string& measure,
                             const std::string& method, const std::string& reference) {
  const auto found = std::find_if(
      comparisons.methods.begin(), comparisons.methods.end(), [&](const MethodComparison& row) {
        return row.measure == measure && row.method == method && row.reference == reference;
      });
  if (found == comparisons.methods.end()) {
    throw std::out_of_range(measure + method + reference);
  }
  return *found;
}

TEST(Comparisons, EveryPairOfMethodsInEveryMeasure) {
  const Comparisons comparisons = compare(study_with_more_measures(5));
  EXPECT_EQ(comparisons.methods.size(), 5U * 3U);
  EXPECT_EQ(comparisons.omnibus.size(), 5U);
  EXPECT_EQ(comparisons.order.size(), 5U * 2U);
  for (const char* measure : {"third", "artifacts", "comfort"}) {
    EXPECT_NO_THROW((void)find(comparisons, measure, "fv", "vp"));
  }
}

TEST(Comparisons, RatiosAreThoseOfFigure5) {
  const auto golden = golden_study();
  const Comparisons comparisons = compare(golden_study_records());
  const MethodComparison& fv = find(comparisons, "outline", "fv", "od");
  const RatioTest& complete = fv.complete.ratio.value();
  EXPECT_GOLDEN(100.0 * complete.ratio, golden.at("outline.fv.geometric_mean_percent"));
  EXPECT_GOLDEN(100.0 * complete.interval.low, golden.at("outline.fv.low_percent"));
  EXPECT_LT(100.0 * fv.ratio_bca->low, golden.at("outline.fv.geometric_mean_percent"));
  EXPECT_GT(100.0 * fv.ratio_bca->high, golden.at("outline.fv.geometric_mean_percent"));
  EXPECT_DOUBLE_EQ(fv.ranks->p, 2.0 / 256.0);
  EXPECT_DOUBLE_EQ(fv.ranks->rank_biserial, -1.0);
}

TEST(Comparisons, ThePlanSaysWhatIsPrimary) {
  const Comparisons comparisons = compare(complete_study(8), fv_planned());
  for (const MethodComparison& row : comparisons.methods) {
    EXPECT_EQ(row.planned, row.measure == "outline" && row.method == "fv" && row.reference == "od");
  }
  // Alone in its family: nothing to adjust. Exploratory ones are not adjusted.
  const MethodComparison& planned = find(comparisons, "outline", "fv", "od");
  EXPECT_EQ(planned.p_holm, planned.primary->p);
  EXPECT_FALSE(find(comparisons, "outline", "vp", "od").p_holm);
  EXPECT_TRUE(find(comparisons, "outline", "vp", "od").primary);
  EXPECT_TRUE(planned.equivalent);
  EXPECT_GT(planned.equivalent->p, 0.99);
  EXPECT_FALSE(find(comparisons, "material", "fv", "od").equivalent);
}

TEST(Comparisons, APlanMayNameThePairTheOtherWayRound) {
  study::AnalysisPlan plan;
  plan.primary = {{"material", "od", "vp"}};
  const StudyRecords records = complete_study(4);
  const Comparisons comparisons = compare(records, plan);
  const MethodComparison& planned = find(comparisons, "material", "od", "vp");
  EXPECT_TRUE(planned.planned);
  EXPECT_GT(planned.ratio->ratio, 1.0);
  EXPECT_NEAR(planned.ratio->ratio,
              1.0 / find(compare(records), "material", "vp", "od").ratio->ratio, 1e-12);
  EXPECT_THROW((void)find(comparisons, "material", "vp", "od"), std::out_of_range);
  EXPECT_EQ(comparisons.methods.size(), 9U);
}

TEST(Comparisons, PlannedOnesComeFirstInThePlansOrderAndDirection) {
  study::AnalysisPlan plan;
  plan.primary = {{"comfort", "fv", "vp"}, {"third", "vp", "fv"}, {"outline", "fv", "od"}};
  const Comparisons comparisons = compare(study_with_more_measures(6), plan);
  ASSERT_EQ(comparisons.methods.size(), 5U * 3U);
  std::vector<std::string> order;
  for (std::size_t i = 0; i < 4; ++i) {
    const MethodComparison& row = comparisons.methods[i];
    order.push_back(row.measure + " " + row.method + " " + row.reference);
    EXPECT_EQ(row.planned, i < 3);
  }
  EXPECT_THAT(order, ElementsAre("comfort fv vp", "third vp fv", "outline fv od", "outline vp od"));
  const MethodComparison& comfort = comparisons.methods[0];
  EXPECT_FALSE(comfort.is_time);
  EXPECT_GT(comfort.points->mean, 20.0);
  EXPECT_FALSE(comfort.ratio);
  const MethodComparison& third = comparisons.methods[1];
  EXPECT_TRUE(third.is_time);
  EXPECT_GT(third.ratio->ratio, 1.0);
  EXPECT_FALSE(third.points);
}

// Holm's family is what was planned, even if a part of it has no P-value: never silently fewer.
TEST(Comparisons, HolmIsForAllThatWerePlannedIfOneCannotBeComputed) {
  StudyRecords records = study_with_more_measures(8);
  change_values(records, "material", [](Value& value) { value = {}; });
  study::AnalysisPlan plan;
  plan.primary = {{"outline", "fv", "od"},
                  {"material", "fv", "od"},
                  {"third", "fv", "vp"},
                  {"comfort", "fv", "od"}};
  const Comparisons comparisons = compare(records, plan);
  const MethodComparison& material = comparisons.methods.at(1);
  EXPECT_EQ(material.measure, "material");
  EXPECT_TRUE(material.planned);
  EXPECT_FALSE(material.p_holm);
  EXPECT_THAT(material.missing, HasSubstr("no participant with both values"));
  std::vector<double> p_values = {comparisons.methods[0].primary->p,
                                  comparisons.methods[2].primary->p,
                                  comparisons.methods[3].primary->p};
  const double smallest = *std::min_element(p_values.begin(), p_values.end());
  double smallest_adjusted = 1.0;
  for (const std::size_t i : {0U, 2U, 3U}) {
    EXPECT_THAT(comparisons.methods[i].missing, IsEmpty());
    smallest_adjusted = std::min(smallest_adjusted, *comparisons.methods[i].p_holm);
  }
  EXPECT_DOUBLE_EQ(smallest_adjusted, 4.0 * smallest);
}

TEST(Comparisons, APlanOfWhatTheStudyDoesNotHaveIsARowThatSaysSo) {
  study::AnalysisPlan plan;
  plan.primary = {{"comfort", "fv", "od"}, {"outline", "fv", "od"}};
  const Comparisons comparisons = compare(complete_study(5), plan);
  EXPECT_EQ(comparisons.methods.front().measure, "comfort");
  EXPECT_THAT(comparisons.methods.front().missing, HasSubstr("no such measure or method"));
  const MethodComparison& outline = comparisons.methods.at(1);
  EXPECT_DOUBLE_EQ(*outline.p_holm, std::min(1.0, 2.0 * outline.primary->p));
}

// An estimate from bounds of right-censored times was biased, and its intervals far too short.
TEST(Comparisons, WithoutATobitModelPairsWithARightCensoredTimeAreLeftOutAndCounted) {
  StudyRecords records = complete_study(6);
  Value& bound = value_of(records, "P3", "aula", "od", "outline");
  bound = right_censored(bound.number);
  const MethodComparison fv = find(compare(records), "outline", "fv", "od");
  EXPECT_EQ(fv.n, 6U);
  EXPECT_EQ(fv.pairs, 11U);
  EXPECT_EQ(fv.censored, 1U);
  EXPECT_THAT(fv.primary->instead, HasSubstr("one pair with a right-censored time left out"));
  EXPECT_EQ(fv.primary->kind, AnalysisKind::crossed_model);
  value_of(records, "P3", "aula", "od", "outline") = {};
  EXPECT_EQ(fv.ratio->ratio, find(compare(records), "outline", "fv", "od").ratio->ratio);
}

TEST(Comparisons, SayOnWhomTheyHang) {
  StudyRecords records = study_with_more_measures(8);
  EXPECT_FALSE(find(compare(complete_study(2)), "outline", "fv", "od").influence);
  for (const std::string& scene : records.scenes) {
    value_of(records, "P5", scene, "fv", "outline").number *= 3.0;
  }
  for (const study::SceneEffects scenes :
       {study::SceneEffects::random, study::SceneEffects::fixed}) {
    study::AnalysisPlan plan;
    plan.scenes = scenes;
    const MethodComparison fv = find(compare(records, plan), "outline", "fv", "od");
    EXPECT_EQ(fv.influence->without_low, "P5");
    EXPECT_LT(fv.influence->estimates.low, fv.primary->estimate);
    EXPECT_GT(fv.influence->estimates.high, fv.primary->estimate);
  }
}

// A scale of many points has no thresholds to estimate: it is compared as times are, in points.
TEST(Comparisons, ARatingWithManyPointsHasTheCrossedModelInPoints) {
  study::AnalysisPlan plan;
  const StudyRecords records = study_with_more_measures(6);
  const MethodComparison random = find(compare(records, plan), "comfort", "fv", "od");
  EXPECT_EQ(random.primary->kind, AnalysisKind::crossed_model);
  EXPECT_EQ(random.primary->scale, EffectScale::points);
  EXPECT_NEAR(random.primary->estimate, random.points->mean, 1e-9);
  plan.scenes = study::SceneEffects::fixed;
  EXPECT_EQ(find(compare(records, plan), "comfort", "fv", "od").primary->p, random.points->p);
  plan.ratings = study::RatingAnalysis::signed_ranks;
  EXPECT_EQ(find(compare(records, plan), "comfort", "fv", "od").primary->p, random.ranks->p);
}

TEST(Comparisons, WhatRCouldNotFitIsSaid) {
  const FittedModels models{.models = {{.model = "ordinal",
                                        .measure = "artifacts",
                                        .method = "fv",
                                        .reference = "od",
                                        .note = "all answers are the same"}}};
  const Comparisons comparisons =
      compare_methods(select_for_analysis(complete_study(6)), {}, models);
  EXPECT_EQ(find(comparisons, "artifacts", "fv", "od").primary->instead,
            "R could not fit the cumulative link mixed model: all answers are the same");
  EXPECT_EQ(find(comparisons, "artifacts", "vp", "od").primary->instead,
            "the cumulative link mixed model needs R (analyze --r)");
}

// Where OD never came to an end, FV and VP can still be compared.
TEST(Comparisons, UseEveryPairThatExists) {
  StudyRecords records = complete_study(6);
  const MethodComparison whole = find(compare(records), "outline", "fv", "vp");
  change_values(records, "outline", [&, i = 0](Value& value) mutable {
    if (records.trials[static_cast<std::size_t>(i++)].method == 0) {
      value = right_censored(180.0);
    }
  });
  const Comparisons comparisons = compare(records);
  const MethodComparison& fv = find(comparisons, "outline", "fv", "vp");
  EXPECT_EQ(fv.pairs, 12U);
  EXPECT_EQ(fv.ratio->ratio, whole.ratio->ratio);
  EXPECT_EQ(fv.primary->p, whole.primary->p);
  EXPECT_EQ(fv.complete.n, 0U);
  const MethodComparison& od = find(comparisons, "outline", "fv", "od");
  EXPECT_EQ(od.pairs, 0U);
  EXPECT_EQ(od.censored, 12U);
  EXPECT_FALSE(od.primary);
}

TEST(Comparisons, ThePlanChoosesThePrimaryAnalysis) {
  study::AnalysisPlan plan = fv_planned();
  const StudyRecords records = complete_study(6);
  const MethodComparison random = find(compare(records, plan), "outline", "fv", "od");
  EXPECT_EQ(random.primary->kind, AnalysisKind::crossed_model);
  EXPECT_NEAR(random.primary->estimate, random.ratio->logs.mean, 1e-12);
  plan.scenes = study::SceneEffects::fixed;
  plan.ratings = study::RatingAnalysis::signed_ranks;
  const Comparisons comparisons = compare(records, plan);
  const MethodComparison& fixed = find(comparisons, "outline", "fv", "od");
  EXPECT_EQ(fixed.primary->kind, AnalysisKind::participant_t);
  EXPECT_EQ(fixed.primary->p, fixed.ratio->logs.p);
  const MethodComparison& rating = find(comparisons, "artifacts", "fv", "od");
  EXPECT_EQ(rating.primary->kind, AnalysisKind::signed_ranks);
  EXPECT_EQ(rating.primary->p, rating.ranks->p);
  EXPECT_THAT(rating.primary->instead, IsEmpty());
}

TEST(Comparisons, ModelsOfROfTheSamePairArePrimaryWhereTheyArePlanned) {
  StudyRecords records = complete_study(6);
  value_of(records, "P3", "aula", "od", "outline") = right_censored(30.0);
  const auto fitted = [](const char* model, const char* measure, EffectScale scale) {
    return FittedModel{.model = model,
                       .measure = measure,
                       .method = "fv",
                       .reference = "od",
                       .scale = scale,
                       .fit = FittedModel::Fit{-0.5, 0.1, 5.0, Interval{-0.8, -0.2}, 0.004}};
  };
  const FittedModels models{.models = {fitted("tobit", "outline", EffectScale::ratio),
                                       fitted("crossed", "material", EffectScale::ratio),
                                       fitted("ordinal", "artifacts", EffectScale::odds_ratio)}};
  const Comparisons comparisons =
      compare_methods(select_for_analysis(records), fv_planned(), models);
  const MethodComparison& outline = find(comparisons, "outline", "fv", "od");
  EXPECT_EQ(outline.primary->kind, AnalysisKind::tobit_model);
  EXPECT_EQ(outline.primary->estimate, -0.5);
  EXPECT_EQ(outline.p_holm, 0.004);
  // Without gaps the closed form is the same model, and needs no R.
  EXPECT_NE(find(comparisons, "material", "fv", "od").primary->estimate, -0.5);
  EXPECT_EQ(find(comparisons, "artifacts", "fv", "od").primary->kind, AnalysisKind::ordinal_model);
  EXPECT_EQ(find(comparisons, "artifacts", "fv", "vp").primary->kind, AnalysisKind::signed_ranks);
}

TEST(Comparisons, LearningIsFoundInTheOrderOfTrials) {
  StudyRecords records = complete_study(6);
  for (std::size_t i = 0; i < records.trials.size(); ++i) {
    // Every participant in another order; each trial a tenth faster than the one before.
    study::TrialRow& row = records.trials[i];
    row.scene_position = static_cast<std::uint16_t>((row.scene + i / 6) % 2);
    row.method_position = static_cast<std::uint16_t>((row.method + i / 6) % 3);
    records.values[i * records.measures.size()] = measured(
        std::pow(0.9, row.scene_position * 3 + row.method_position) *
        (5.0 + static_cast<double>(i % 7) * 0.01) * (1.0 + row.method) * (1.0 + row.scene));
  }
  const Comparisons comparisons = compare(records);
  const OrderTest& test = comparisons.order.front();
  EXPECT_EQ(test.of, "trial in the session");
  EXPECT_NEAR(test.change_per_step->mean, std::log(0.9), 0.01);
}

// Right after od, fv takes a fifth longer.
TEST(Comparisons, CarryOverIsFoundWhereEveryMethodFollowsEveryOther) {
  StudyRecords records = complete_study(24);
  EXPECT_EQ(compare(records).order.size(), 6U) << "the orders of methods are not recorded";
  constexpr int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  for (std::size_t i = 0; i < records.trials.size(); ++i) {
    study::TrialRow& row = records.trials[i];
    const std::size_t participant = i / 6;
    const int(&order)[3] = orders[(participant + (row.scene == 0 ? 0U : 3U + participant / 6)) % 6];
    row.method_position = static_cast<std::uint16_t>(order[row.method]);
    const bool is_after_od = row.method == 2 && order[2] == order[0] + 1;
    const double noise = 1.0 + 0.002 * static_cast<double>(i * 7 % 11);
    records.values[i * records.measures.size()] =
        measured((is_after_od ? 12.0 : 10.0) * noise * (1.0 + static_cast<double>(participant)) *
                 (1.0 + row.scene) * (1.0 + row.method));
  }
  const Comparisons found = compare(records);
  const auto fv = std::find_if(found.order.begin(), found.order.end(), [](const OrderTest& row) {
    return row.measure == "outline" && row.of == "fv after od";
  });
  ASSERT_NE(fv, found.order.end());
  EXPECT_NEAR(fv->change_per_step->mean, std::log(1.2), 0.02);
  EXPECT_LT(fv->change_per_step->p, 0.001);
  EXPECT_EQ(std::count_if(found.order.begin(), found.order.end(),
                          [](const OrderTest& row) { return row.measure == "outline"; }),
            2 + 3);
}

TEST(Comparisons, EquivalenceOfPlannedOnesIsAFamilyOfItsOwn) {
  study::AnalysisPlan plan;
  plan.primary = {{"outline", "fv", "od"}, {"outline", "fv", "vp"}, {"material", "fv", "vp"}};
  plan.equivalence_margins = {{"outline", 12.0}};  // The material has none: a family of two.
  const Comparisons found = compare(complete_study(6), plan);
  const MethodComparison& a = find(found, "outline", "fv", "od");
  const MethodComparison& b = find(found, "outline", "fv", "vp");
  ASSERT_TRUE(a.equivalent && b.equivalent);
  const double smaller = std::min(a.equivalent->p, b.equivalent->p);
  EXPECT_DOUBLE_EQ(std::min(*a.p_equivalent_holm, *b.p_equivalent_holm), 2.0 * smaller);
  EXPECT_DOUBLE_EQ(std::max(*a.p_equivalent_holm, *b.p_equivalent_holm),
                   std::max(2.0 * smaller, std::max(a.equivalent->p, b.equivalent->p)));
  EXPECT_FALSE(find(found, "material", "fv", "vp").p_equivalent_holm);
  const MethodComparison& exploratory = find(found, "outline", "vp", "od");
  EXPECT_TRUE(exploratory.equivalent);
  EXPECT_FALSE(exploratory.p_equivalent_holm);
}

/// A model of fv and od by R.
FittedModel fitted(const std::string& model, const std::string& measure, EffectScale scale,
                   const FittedModel::Fit& fit) {
  return {.model = model,
          .measure = measure,
          .method = "fv",
          .reference = "od",
          .scale = scale,
          .fit = fit};
}

/// Of which one of od's times is right-censored, and one missing.
StudyRecords study_with_gaps() {
  StudyRecords records = complete_study(6);
  value_of(records, "P3", "aula", "od", "outline") = right_censored(30.0);
  value_of(records, "P3", "aula", "od", "material") = {};
  return records;
}

// A t test of the uncensored pairs declared methods equivalent whose Tobit ratio was 1.505, with a
// 90 % interval of [1.452, 1.561]. P by R: pt((0.40913 - log(1.25)) / 0.020645, 15).
TEST(Comparisons, EquivalenceIsThatOfThePrimaryModel) {
  const double low = std::log(1.452);
  const double high = std::log(1.561);
  constexpr double t_90 = 1.753050355692572;  // qt(0.95, 15)
  FittedModels models{
      .models = {
          fitted("tobit", "outline", EffectScale::ratio,
                 {.estimate = 0.5 * (low + high),
                  .standard_error = 0.5 * (high - low) / t_90,
                  .degrees_of_freedom = 15.0,
                  .p = 1e-7}),
          fitted("crossed", "material", EffectScale::ratio,
                 {.estimate = 0.05, .standard_error = 0.06, .degrees_of_freedom = 7.5, .p = 0.4}),
          fitted("ordinal", "artifacts", EffectScale::odds_ratio, {.p = 0.5})}};
  models.models[0].influence = Influence{{0.3, 0.5}, "P2", "P4"};
  models.models[2].note = "separated";
  study::AnalysisPlan plan = fv_planned();
  plan.equivalence_margins = {{"outline", 1.25}, {"material", 1.25}, {"artifacts", 1.0}};
  const Comparisons found = compare_methods(select_for_analysis(study_with_gaps()), plan, models);
  const MethodComparison& tobit = find(found, "outline", "fv", "od");
  EXPECT_NEAR(std::exp(tobit.equivalent->interval->low), 1.452, 1e-9);
  EXPECT_NEAR(std::exp(tobit.equivalent->interval->high), 1.561, 1e-9);
  EXPECT_NEAR(tobit.equivalent->p, 0.9999999, 1e-7);
  // With gaps it was of the participants who have all scenes.
  EXPECT_GOLDEN(find(found, "material", "fv", "od").equivalent->p, 0.01088623171881453);
  const MethodComparison& ordinal = find(found, "artifacts", "fv", "od");
  EXPECT_FALSE(ordinal.equivalent);
  EXPECT_THAT(ordinal.no_equivalence, HasSubstr("margin in points"));
  // So is what becomes of the estimate without each participant.
  EXPECT_EQ(tobit.influence->without_low, "P2");
  EXPECT_THAT(tobit.no_influence, IsEmpty());
  EXPECT_FALSE(ordinal.influence);
  EXPECT_THAT(ordinal.no_influence, HasSubstr("was not fitted without each"));
  // Warnings stand beside the result.
  EXPECT_EQ(ordinal.primary->warning, "separated");
}

TEST(Comparisons, WithoutATobitModelNothingIsSaidOfEquivalence) {
  study::AnalysisPlan plan = fv_planned();
  plan.primary.push_back({"outline", "fv", "vp"});
  plan.equivalence_margins = {{"outline", 1e6}};
  const Comparisons found = compare(study_with_gaps(), plan);
  const MethodComparison& censored = find(found, "outline", "fv", "od");
  EXPECT_FALSE(censored.equivalent);
  EXPECT_FALSE(censored.p_equivalent_holm);
  EXPECT_THAT(censored.no_equivalence, HasSubstr("needs the Tobit model"));
  // It stays in the family of two.
  const MethodComparison& other = find(found, "outline", "fv", "vp");
  EXPECT_DOUBLE_EQ(*other.p_equivalent_holm, std::min(1.0, 2.0 * other.equivalent->p));
}

TEST(Comparisons, OfSignedRanksEquivalenceAndInfluenceAreByRanks) {
  study::AnalysisPlan plan = fv_planned();
  plan.ratings = study::RatingAnalysis::signed_ranks;
  plan.equivalence_margins = {{"artifacts", 5.0}};
  const MethodComparison row = find(compare(complete_study(6), plan), "artifacts", "fv", "od");
  EXPECT_EQ(row.equivalent->p, std::ldexp(1.0, -6));  // the smallest P of six differences
  EXPECT_LE(row.influence->estimates.low, row.primary->estimate);
  EXPECT_GE(row.influence->estimates.high, row.primary->estimate);
}

TEST(Comparisons, EveryTestThatLeavesOutRightCensoredTimesCountsThem) {
  const Comparisons found = compare(study_with_gaps());
  EXPECT_EQ(found.omnibus.at(0).censored, 1U);
  EXPECT_EQ(found.omnibus.at(1).censored, 0U);
  EXPECT_EQ(found.order.at(1).censored, 1U);
  EXPECT_EQ(found.censored_times,
            "Right-censored times are left out (1 of 12 outline times of OD), which favours the "
            "method with the censored times.");
  EXPECT_EQ(compare(complete_study(4)).censored_times, "");
}

TEST(Comparisons, FewParticipantsHaveWhatCanBeComputed) {
  const Comparisons one = compare(complete_study(1));
  const MethodComparison& fv = find(one, "outline", "fv", "od");
  EXPECT_EQ(fv.n, 1U);
  EXPECT_FALSE(fv.ratio || fv.ratio_bca);
  EXPECT_FALSE(fv.ranks || fv.pseudo_median);
  EXPECT_TRUE(fv.mean);
  EXPECT_FALSE(fv.p_holm);
  EXPECT_THAT(fv.missing, HasSubstr("one participant"));
  EXPECT_TRUE(compare(with_od_alone(complete_study(3))).methods.empty());
}

}  // namespace
}  // namespace foveola::analysis
