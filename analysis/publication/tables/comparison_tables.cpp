#include <cmath>
#include <string>
#include <utility>

#include "analysis/publication/tables/result_tables.h"

namespace foveola::analysis {
namespace {

using C = MethodComparison;

void append(const ColumnsOf<C>& added, ColumnsOf<C>& columns) {
  columns.insert(columns.end(), added.begin(), added.end());
}

/// Path to a value of a test, in the comparison's unit, which is empty if the test is.
template <typename... Steps>
auto in_unit(Steps... steps) {
  return [=](const C& row) {
    return follow(row, steps..., [&](double tested) { return row.in_unit(tested); });
  };
}

/// The same for times only, in per cent.
template <typename... Steps>
auto of_times(Steps... steps) {
  return [=](const C& row) {
    return row.is_time ? follow(row, in_unit(steps...), in_percent) : std::nullopt;
  };
}

/// The same for ratings only.
template <typename... Steps>
auto of_ratings(Steps... steps) {
  return [=](const C& row) { return row.is_time ? std::nullopt : follow(row, steps...); };
}

void add_primary(ColumnsOf<C>& columns) {
  using R = PrimaryResult;
  append({{"analysis", "", "Name of the primary analysis", path(&C::primary, &R::kind)},
          {"analysis_note", "",
           "Reason why it replaces the planned one; empty if it is the planned one",
           path(&C::primary, &R::instead)},
          {"analysis_warning", "", "Warnings of R about the primary analysis",
           path(&C::primary, &R::warning)},
          {"scale", "", "Scale of estimate: ratio, odds ratio or points",
           path(&C::primary, &R::scale)},
          {"scenes", "", "Number of scenes in estimate", path(&C::primary, &R::scenes)},
          {"estimate", "", "Estimate of the primary analysis",
           path(&C::primary, &R::scaled, &Estimate::value)},
          {"estimate_low", "",
           "Lower 95 % confidence limit of estimate, in the unit of scale, by the method that "
           "analysis names",
           path(&C::primary, &R::scaled, &Estimate::interval, &Interval::low)},
          {"estimate_high", "",
           "Upper 95 % confidence limit of estimate, in the unit of scale, by the method that "
           "analysis names",
           path(&C::primary, &R::scaled, &Estimate::interval, &Interval::high)},
          {"estimate_df", "", "Degrees of freedom of estimate; empty if it has none",
           path(&C::primary, &R::degrees_of_freedom)},
          {"p", "", "Two-sided P of the primary analysis", path(&C::primary, &R::p)},
          {"p_holm", "",
           "p adjusted by Holm's method over all planned comparisons together; empty for "
           "exploratory ones, which are not adjusted",
           &C::p_holm},
          {"missing", "", "Reason why p is empty; empty if there is a p", &C::missing}},
         columns);
}

void add_tests_over_participants(ColumnsOf<C>& columns) {
  using Ranks = SignedRankTest;
  append(
      {{"ratio_percent", "%",
        "Geometric mean of the participants' ratios of times to the reference's",
        of_times(&C::mean)},
       {"ci95_low_percent", "%",
        "Lower 95 % confidence limit of ratio_percent, from Student's t of the log ratios",
        path(&C::ratio, &RatioTest::interval, &Interval::low, in_percent)},
       {"ci95_high_percent", "%",
        "Upper 95 % confidence limit of ratio_percent, from Student's t of the log ratios",
        path(&C::ratio, &RatioTest::interval, &Interval::high, in_percent)},
       {"bca95_low_percent", "%",
        "Lower 95 % confidence limit of ratio_percent, by bootstrap (BCa)",
        path(&C::ratio_bca, &Interval::low, in_percent)},
       {"bca95_high_percent", "%",
        "Upper 95 % confidence limit of ratio_percent, by bootstrap (BCa)",
        path(&C::ratio_bca, &Interval::high, in_percent)},
       {"difference_points", "points", "Mean difference of ratings, method less reference",
        of_ratings(&C::mean)},
       {"ci95_low_points", "points",
        "Lower 95 % confidence limit of difference_points, from Student's t",
        path(&C::points, &TTest::interval, &Interval::low)},
       {"ci95_high_points", "points",
        "Upper 95 % confidence limit of difference_points, from Student's t",
        path(&C::points, &TTest::interval, &Interval::high)},
       {"t", "",
        "Paired t statistic of the log ratios of times or the differences of ratings, method less "
        "reference",
        path(&C::t_test, &TTest::t)},
       {"df", "", "Degrees of freedom of t", path(&C::t_test, &TTest::degrees_of_freedom)},
       {"p_t", "", "Two-sided P of t", path(&C::t_test, &TTest::p)},
       {"d_z", "", "Effect size: mean over standard deviation of the differences",
        path(&C::t_test, &TTest::d_z)},
       {"w_plus", "",
        "Wilcoxon's sum of the ranks of positive differences: log ratios or points, method less "
        "reference",
        path(&C::ranks, &Ranks::w_plus)},
       {"w_minus", "",
        "Wilcoxon's sum of the ranks of negative differences: log ratios or points, method less "
        "reference",
        path(&C::ranks, &Ranks::w_minus)},
       {"zeros", "", "Number of zero differences, which are left out of the ranks",
        path(&C::ranks, &Ranks::zeros)},
       {"p_wilcoxon", "", "Two-sided P of Wilcoxon's signed-rank test", path(&C::ranks, &Ranks::p)},
       {"wilcoxon_exact", "", "Whether p_wilcoxon is exact", path(&C::ranks, &Ranks::exact)},
       {"rank_biserial", "", "Effect size: matched-pairs rank-biserial correlation",
        path(&C::ranks, &Ranks::rank_biserial)}},
      columns);
}

void add_pseudo_medians(ColumnsOf<C>& columns) {
  const auto value = path(&C::pseudo_median, &PseudoMedian::value);
  const auto low = path(&C::pseudo_median, &PseudoMedian::interval, &Interval::low);
  const auto high = path(&C::pseudo_median, &PseudoMedian::interval, &Interval::high);
  append({{"pseudo_median_ratio_percent", "%", "Hodges and Lehmann's estimate of the ratio",
           of_times(value)},
          {"pseudo_median_low_ratio_percent", "%",
           "Lower 95 % confidence limit of pseudo_median_ratio_percent", of_times(low)},
          {"pseudo_median_high_ratio_percent", "%",
           "Upper 95 % confidence limit of pseudo_median_ratio_percent", of_times(high)},
          {"pseudo_median_points", "points",
           "Hodges and Lehmann's estimate of the difference of ratings", of_ratings(value)},
          {"pseudo_median_low_points", "points",
           "Lower 95 % confidence limit of pseudo_median_points", of_ratings(low)},
          {"pseudo_median_high_points", "points",
           "Upper 95 % confidence limit of pseudo_median_points", of_ratings(high)}},
         columns);
}

void add_equivalence(double alpha, ColumnsOf<C>& columns) {
  using E = EquivalenceTest;
  const auto confidence_percent = [=](const E& /*test*/) { return 100.0 * (1.0 - 2.0 * alpha); };
  append({{"equivalence_margin", "", "Planned margin: a factor of times, or points", &C::margin},
          {"equivalence_confidence_percent", "",
           "Confidence level of the equivalence interval, 1 − 2 alpha: it lies within the margins "
           "where "
           "the unadjusted P is below alpha",
           path(&C::equivalent, confidence_percent)},
          {"equivalence_interval_low", "",
           "Lower limit of the equivalence interval, in the margin's unit",
           in_unit(&C::equivalent, &E::interval, &Interval::low)},
          {"equivalence_interval_high", "",
           "Upper limit of the equivalence interval, in the margin's unit",
           in_unit(&C::equivalent, &E::interval, &Interval::high)},
          {"p_above_low_margin", "",
           "One-sided P of the test that the difference lies above the lower margin",
           path(&C::equivalent, &E::p_above_low)},
          {"p_below_high_margin", "",
           "One-sided P of the test that the difference lies below the upper margin",
           path(&C::equivalent, &E::p_below_high)},
          {"p_equivalence", "", "P of equivalence: the larger of the two one-sided P",
           path(&C::equivalent, &E::p)},
          {"p_equivalence_holm", "",
           "p_equivalence adjusted by Holm's method over the planned comparisons with a margin, a "
           "family of "
           "their own; empty for exploratory ones, which are not adjusted",
           &C::p_equivalent_holm},
          {"equivalence_note", "",
           "Reason why a comparison with a margin has no test of equivalence; empty if it has one",
           &C::no_equivalence}},
         columns);
}

void add_complete_cases(ColumnsOf<C>& columns) {
  const auto ratio = path(&C::complete, &CompleteCases::ratio);
  const auto points = path(&C::complete, &CompleteCases::points);
  append(
      {{"n_complete", "",
        "Participants with a scene in which all methods were measured (complete cases)",
        path(&C::complete, &CompleteCases::n)},
       {"complete_ratio_percent", "%", "ratio_percent over complete cases",
        path(ratio, &RatioTest::ratio, in_percent)},
       {"complete_ci95_low_percent", "%",
        "Lower 95 % confidence limit of complete_ratio_percent, from Student's t of the log ratios",
        path(ratio, &RatioTest::interval, &Interval::low, in_percent)},
       {"complete_ci95_high_percent", "%",
        "Upper 95 % confidence limit of complete_ratio_percent, from Student's t of the log ratios",
        path(ratio, &RatioTest::interval, &Interval::high, in_percent)},
       {"complete_difference_points", "points", "difference_points over complete cases",
        path(points, &TTest::mean)},
       {"complete_ci95_low_points", "points",
        "Lower 95 % confidence limit of complete_difference_points, from Student's t",
        path(points, &TTest::interval, &Interval::low)},
       {"complete_ci95_high_points", "points",
        "Upper 95 % confidence limit of complete_difference_points, from Student's t",
        path(points, &TTest::interval, &Interval::high)}},
      columns);
}

void add_influence(ColumnsOf<C>& columns) {
  append({{"leave_one_out_low", "",
           "Minimum of the primary estimates without one participant, a ratio or points",
           in_unit(&C::influence, &Influence::estimates, &Interval::low)},
          {"leave_one_out_low_without", "",
           "Code of the participant without whom the estimate is leave_one_out_low",
           path(&C::influence, &Influence::without_low)},
          {"leave_one_out_high", "",
           "Maximum of the primary estimates without one participant, a ratio or points",
           in_unit(&C::influence, &Influence::estimates, &Interval::high)},
          {"leave_one_out_high_without", "",
           "Code of the participant without whom the estimate is leave_one_out_high",
           path(&C::influence, &Influence::without_high)},
          {"leave_one_out_note", "", "Reason why there is no such estimate; empty if there is one",
           &C::no_influence}},
         columns);
}

}  // namespace

Table comparisons_table(const StudyTables& tables, const Comparisons& comparisons) {
  ColumnsOf<C> columns = {
      {"measure", "", "Id of the mark or rating", &C::measure},
      {"method", "", "Id of the method", &C::method},
      {"reference", "", "Id of the reference method", &C::reference},
      {"status", "", "planned in the protocol, or exploratory",
       [](const C& row) { return row.planned ? "planned" : "exploratory"; }},
      {"n", "", "Number of participants with a pair of trials", &C::n},
      {"pairs", "", "Number of pairs of trials with both values, of a participant in a scene",
       &C::pairs},
      {"censored_pairs", "",
       "Number of pairs with a right-censored time, which pairs does not count", &C::censored}};
  add_primary(columns);
  add_tests_over_participants(columns);
  add_pseudo_medians(columns);
  add_equivalence(comparisons.plan.alpha, columns);
  add_complete_cases(columns);
  add_influence(columns);
  columns.push_back(kind_of_all<C>(tables));
  return tabulate("comparisons", "measure and pair of methods", columns, comparisons.methods);
}

Table omnibus_table(const StudyTables& tables, const Comparisons& comparisons) {
  using O = OmnibusTest;
  using V = VarianceAnalysis;
  using F = FriedmanTest;
  const ColumnsOf<O> columns = {
      {"measure", "", "Id of the mark or rating", &O::measure},
      {"n", "", "Number of participants with values of all methods",
       path(&O::ranks, &F::participants)},
      {"participants_left_out", "", "Number of participants with a missing value", &O::left_out},
      {"censored", "", "Number of right-censored times of the measure, which are left out",
       &O::censored},
      {"f", "", "F of the repeated-measures analysis of variance of log times",
       path(&O::variance, &V::f)},
      {"df", "", "Degrees of freedom of the methods", path(&O::variance, &V::degrees_of_freedom)},
      {"residual_df", "", "Degrees of freedom of the residuals",
       path(&O::variance, &V::residual_degrees_of_freedom)},
      {"p_uncorrected", "", "P of F without a correction for sphericity",
       path(&O::variance, &V::p)},
      {"epsilon_greenhouse_geisser", "", "Greenhouse and Geisser's epsilon",
       path(&O::variance, &V::greenhouse_geisser)},
      {"p_greenhouse_geisser", "",
       "P of F with degrees of freedom times epsilon_greenhouse_geisser",
       path(&O::variance, &V::p_greenhouse_geisser)},
      {"epsilon_huynh_feldt", "", "Huynh and Feldt's epsilon", path(&O::variance, &V::huynh_feldt)},
      {"p_huynh_feldt", "", "P of F with degrees of freedom times epsilon_huynh_feldt",
       path(&O::variance, &V::p_huynh_feldt)},
      {"partial_eta_squared", "", "Effect size of the methods",
       path(&O::variance, &V::partial_eta_squared)},
      {"friedman_chi_squared", "", "Friedman's statistic, corrected for ties",
       path(&O::ranks, &F::chi_squared)},
      {"friedman_df", "", "Degrees of freedom of Friedman's statistic",
       path(&O::ranks, &F::degrees_of_freedom)},
      {"p_friedman", "", "P of Friedman's statistic", path(&O::ranks, &F::p)},
      {"kendalls_w", "", "Kendall's coefficient of concordance", path(&O::ranks, &F::kendalls_w)},
      kind_of_all<O>(tables)};
  return tabulate("omnibus", "measure", columns, comparisons.omnibus);
}

Table order_effects_table(const StudyTables& tables, const Comparisons& comparisons) {
  using O = OrderTest;
  const auto percent = [](auto... steps) {
    return [=](const O& row) {
      return row.is_time ? follow(row, &O::change_per_step, steps...,
                                  [](double log) { return 100.0 * std::expm1(log); })
                         : std::nullopt;
    };
  };
  const auto points = [](auto... steps) {
    return [=](const O& row) {
      return row.is_time ? std::nullopt : follow(row, &O::change_per_step, steps...);
    };
  };
  const ColumnsOf<O> columns = {
      {"measure", "", "Id of the mark or rating", &O::measure},
      {"per", "",
       "A step: trial in the session, method in the scene, or carry-over, as fv after od: right "
       "after that method in the scene, against after the others",
       &O::of},
      {"n", "", "Number of participants whose order varies", path(&O::change_per_step, &TTest::n)},
      {"censored", "", "Number of right-censored times of the measure, which are left out",
       &O::censored},
      {"change_percent", "%", "Change of times per step", percent(&TTest::mean)},
      {"ci95_low_percent", "%", "Lower 95 % confidence limit of change_percent",
       percent(&TTest::interval, &Interval::low)},
      {"ci95_high_percent", "%", "Upper 95 % confidence limit of change_percent",
       percent(&TTest::interval, &Interval::high)},
      {"change_points", "points", "Change of ratings per step", points(&TTest::mean)},
      {"ci95_low_points", "points", "Lower 95 % confidence limit of change_points",
       points(&TTest::interval, &Interval::low)},
      {"ci95_high_points", "points", "Upper 95 % confidence limit of change_points",
       points(&TTest::interval, &Interval::high)},
      {"t", "", "t of the participants' slopes", path(&O::change_per_step, &TTest::t)},
      {"df", "", "Degrees of freedom of t", path(&O::change_per_step, &TTest::degrees_of_freedom)},
      {"p", "", "Two-sided P of t", path(&O::change_per_step, &TTest::p)},
      {"d_z", "", "Effect size: mean over standard deviation of the slopes",
       path(&O::change_per_step, &TTest::d_z)},
      kind_of_all<O>(tables)};
  return tabulate("order_effects", "measure and kind of step", columns, comparisons.order);
}

Table models_table(const StudyTables& tables, const Comparisons& comparisons) {
  using M = FittedModel;
  using Fit = FittedModel::Fit;
  const ColumnsOf<M> columns = {
      {"measure", "", "Id of the mark or rating", &M::measure},
      {"method", "", "Id of the method", &M::method},
      {"reference", "", "Id of the reference method", &M::reference},
      {"model", "",
       "crossed: mixed model of log times, or of points on a scale with many; tobit: of log times "
       "with right-censored ones; ordinal: cumulative link mixed model of ratings",
       &M::model},
      {"scale", "", "Scale of estimate: ratio of times, odds ratio of a higher rating, or points",
       &M::scale},
      {"status", "",
       "fitted; separated: all ratings of one method are higher, with an infinite odds ratio; "
       "singular: the estimates are not determined by the data (singular Hessian); failed: no fit, "
       "for the reason in note. Singular and failed models have no P",
       &M::status},
      {"estimate", "", "Natural logarithm of the ratio or odds ratio, or points",
       path(&M::fit, &Fit::estimate)},
      {"standard_error", "", "Standard error of estimate", path(&M::fit, &Fit::standard_error)},
      {"df", "", "Degrees of freedom of estimate", path(&M::fit, &Fit::degrees_of_freedom)},
      {"ci95_low", "", "Lower 95 % confidence limit of estimate",
       path(&M::fit, &Fit::interval, &Interval::low)},
      {"ci95_high", "", "Upper 95 % confidence limit of estimate",
       path(&M::fit, &Fit::interval, &Interval::high)},
      {"p", "", "Two-sided P of no difference", path(&M::fit, &Fit::p)},
      {"trials", "", "Number of trials of the model", &M::trials},
      {"participants", "", "Number of participants of the model", &M::participants},
      {"scenes", "", "Number of scenes of the model", &M::scenes},
      {"censored", "", "Number of trials with a right-censored time", &M::censored},
      {"participant_sd", "",
       "Standard deviation between participants of the difference between the methods",
       &M::participant_sd},
      {"scene_sd", "", "Standard deviation between scenes of the difference between the methods",
       &M::scene_sd},
      {"residual_sd", "", "Standard deviation of the difference within a scene", &M::residual_sd},
      {"note", "", "Reason why there is no estimate, or warnings of R", &M::note},
      kind_of_all<M>(tables)};
  return tabulate("models", "model that R fitted (--r)", columns, comparisons.models.models);
}

Table model_versions_table(const StudyTables& tables, const Comparisons& comparisons) {
  using V = std::pair<std::string, std::string>;
  const ColumnsOf<V> columns = {{"name", "", "R or one of its packages", &V::first},
                                {"version", "", "Version of the program", &V::second},
                                kind_of_all<V>(tables)};
  return tabulate("model_versions", "program that fitted models (--r)", columns,
                  comparisons.models.versions);
}

}  // namespace foveola::analysis
