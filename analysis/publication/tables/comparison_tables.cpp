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

/// What the steps find, which was tested, in the comparison's unit.
template <typename... Steps>
auto in_unit(Steps... steps) {
  return [=](const C& row) {
    return follow(row, steps..., [&](double tested) { return row.in_unit(tested); });
  };
}

/// The same of times alone, in per cent.
template <typename... Steps>
auto of_times(Steps... steps) {
  return [=](const C& row) {
    return row.is_time ? follow(row, in_unit(steps...), in_percent) : std::nullopt;
  };
}

/// The same of ratings alone.
template <typename... Steps>
auto of_ratings(Steps... steps) {
  return [=](const C& row) { return row.is_time ? std::nullopt : follow(row, steps...); };
}

void add_primary(ColumnsOf<C>& columns) {
  using R = PrimaryResult;
  append({{"analysis", "", "The primary analysis", path(&C::primary, &R::kind)},
          {"analysis_note", "",
           "Why it stands in for the one that was planned; empty if it is that one",
           path(&C::primary, &R::instead)},
          {"analysis_warning", "", "What R warned of it", path(&C::primary, &R::warning)},
          {"scale", "", "What its estimate is: ratio, odds ratio or points",
           path(&C::primary, &R::scale)},
          {"scenes", "", "Scenes that its estimate rests on", path(&C::primary, &R::scenes)},
          {"estimate", "", "Estimate of the primary analysis",
           path(&C::primary, &R::scaled, &Estimate::value)},
          {"estimate_low", "", "Lower end of its 95 % interval",
           path(&C::primary, &R::scaled, &Estimate::interval, &Interval::low)},
          {"estimate_high", "", "Upper end of its 95 % interval",
           path(&C::primary, &R::scaled, &Estimate::interval, &Interval::high)},
          {"estimate_df", "", "Its degrees of freedom, where it has any",
           path(&C::primary, &R::degrees_of_freedom)},
          {"p", "", "Its two-sided P", path(&C::primary, &R::p)},
          {"p_holm", "",
           "P adjusted by Holm's method over all planned comparisons together; empty for "
           "exploratory ones, which are not adjusted",
           &C::p_holm},
          {"missing", "", "Why there is no P; empty if there is one", &C::missing}},
         columns);
}

void add_tests_over_participants(ColumnsOf<C>& columns) {
  using Ranks = SignedRankTest;
  append({{"ratio_percent", "%",
           "Of times: geometric mean of the participants' ratios, method to reference",
           of_times(&C::mean)},
          {"ci95_low_percent", "%", "Lower end of its 95 % t interval",
           path(&C::ratio, &RatioTest::interval, &Interval::low, in_percent)},
          {"ci95_high_percent", "%", "Upper end of its 95 % t interval",
           path(&C::ratio, &RatioTest::interval, &Interval::high, in_percent)},
          {"bca95_low_percent", "%", "Lower end of its 95 % bootstrap interval (BCa)",
           path(&C::ratio_bca, &Interval::low, in_percent)},
          {"bca95_high_percent", "%", "Upper end of its 95 % bootstrap interval (BCa)",
           path(&C::ratio_bca, &Interval::high, in_percent)},
          {"difference_points", "points", "Of ratings: mean difference, method less reference",
           of_ratings(&C::mean)},
          {"ci95_low_points", "points", "Lower end of its 95 % t interval",
           path(&C::points, &TTest::interval, &Interval::low)},
          {"ci95_high_points", "points", "Upper end of its 95 % t interval",
           path(&C::points, &TTest::interval, &Interval::high)},
          {"t", "", "Paired t, of log ratios of times or differences of ratings",
           path(&C::t_test, &TTest::t)},
          {"df", "", "Degrees of freedom of t", path(&C::t_test, &TTest::degrees_of_freedom)},
          {"p_t", "", "Two-sided P of t", path(&C::t_test, &TTest::p)},
          {"d_z", "", "Effect size: mean over standard deviation of the differences",
           path(&C::t_test, &TTest::d_z)},
          {"w_plus", "", "Wilcoxon's sum of ranks of positive differences",
           path(&C::ranks, &Ranks::w_plus)},
          {"w_minus", "", "Wilcoxon's sum of ranks of negative differences",
           path(&C::ranks, &Ranks::w_minus)},
          {"zeros", "", "Differences of zero, which are left out of the ranks",
           path(&C::ranks, &Ranks::zeros)},
          {"p_wilcoxon", "", "Two-sided P of the signed-rank test", path(&C::ranks, &Ranks::p)},
          {"wilcoxon_exact", "", "Whether that P is exact", path(&C::ranks, &Ranks::exact)},
          {"rank_biserial", "", "Effect size: matched-pairs rank-biserial correlation",
           path(&C::ranks, &Ranks::rank_biserial)}},
         columns);
}

void add_pseudo_medians(ColumnsOf<C>& columns) {
  const auto value = path(&C::pseudo_median, &PseudoMedian::value);
  const auto low = path(&C::pseudo_median, &PseudoMedian::interval, &Interval::low);
  const auto high = path(&C::pseudo_median, &PseudoMedian::interval, &Interval::high);
  append(
      {{"pseudo_median_ratio_percent", "%", "Hodges and Lehmann's estimate", of_times(value)},
       {"pseudo_median_low_ratio_percent", "%", "Lower end of its 95 % interval", of_times(low)},
       {"pseudo_median_high_ratio_percent", "%", "Upper end of its 95 % interval", of_times(high)},
       {"pseudo_median_points", "points", "Hodges and Lehmann's estimate", of_ratings(value)},
       {"pseudo_median_low_points", "points", "Lower end of its 95 % interval", of_ratings(low)},
       {"pseudo_median_high_points", "points", "Upper end of its 95 % interval", of_ratings(high)}},
      columns);
}

void add_equivalence(double alpha, ColumnsOf<C>& columns) {
  using E = EquivalenceTest;
  const auto confidence_percent = [=](const E& /*test*/) { return 100.0 * (1.0 - 2.0 * alpha); };
  append(
      {{"equivalence_margin", "", "Planned margin: a factor of times, or points", &C::margin},
       {"equivalence_confidence_percent", "",
        "Confidence of the interval that follows, 1 − 2 alpha: it lies within the margins where "
        "the unadjusted P is below alpha",
        path(&C::equivalent, confidence_percent)},
       {"equivalence_interval_low", "", "Lower end of that interval, in the margin's unit",
        in_unit(&C::equivalent, &E::interval, &Interval::low)},
       {"equivalence_interval_high", "", "Its upper end",
        in_unit(&C::equivalent, &E::interval, &Interval::high)},
       {"p_above_low_margin", "", "One-sided P that the difference lies above the lower margin",
        path(&C::equivalent, &E::p_above_low)},
       {"p_below_high_margin", "", "One-sided P that it lies below the upper margin",
        path(&C::equivalent, &E::p_below_high)},
       {"p_equivalence", "", "The larger of the two", path(&C::equivalent, &E::p)},
       {"p_equivalence_holm", "",
        "That P adjusted by Holm's method over the planned comparisons with a margin, a family of "
        "their own; empty for exploratory ones, which are not adjusted",
        &C::p_equivalent_holm},
       {"equivalence_note", "",
        "Why a comparison with a margin has no test of equivalence; empty if it has",
        &C::no_equivalence}},
      columns);
}

void add_complete_cases(ColumnsOf<C>& columns) {
  const auto ratio = path(&C::complete, &CompleteCases::ratio);
  const auto points = path(&C::complete, &CompleteCases::points);
  append({{"n_complete", "",
           "Participants with a scene in which all methods were measured (complete cases)",
           path(&C::complete, &CompleteCases::n)},
          {"complete_ratio_percent", "%", "Of times, in those scenes: ratio_percent",
           path(ratio, &RatioTest::ratio, in_percent)},
          {"complete_ci95_low_percent", "%", "Lower end of its 95 % t interval",
           path(ratio, &RatioTest::interval, &Interval::low, in_percent)},
          {"complete_ci95_high_percent", "%", "Upper end of its 95 % t interval",
           path(ratio, &RatioTest::interval, &Interval::high, in_percent)},
          {"complete_difference_points", "points", "Of ratings, in those scenes: difference_points",
           path(points, &TTest::mean)},
          {"complete_ci95_low_points", "points", "Lower end of its 95 % t interval",
           path(points, &TTest::interval, &Interval::low)},
          {"complete_ci95_high_points", "points", "Upper end of its 95 % t interval",
           path(points, &TTest::interval, &Interval::high)}},
         columns);
}

void add_influence(ColumnsOf<C>& columns) {
  append({{"leave_one_out_low", "",
           "Smallest primary estimate without one participant, as a ratio or in points",
           in_unit(&C::influence, &Influence::estimates, &Interval::low)},
          {"leave_one_out_low_without", "", "The code of that participant",
           path(&C::influence, &Influence::without_low)},
          {"leave_one_out_high", "", "Largest estimate without one participant",
           in_unit(&C::influence, &Influence::estimates, &Interval::high)},
          {"leave_one_out_high_without", "", "The code of that participant",
           path(&C::influence, &Influence::without_high)},
          {"leave_one_out_note", "", "Why there is none; empty if there is", &C::no_influence}},
         columns);
}

}  // namespace

Table comparisons_table(const StudyTables& tables, const Comparisons& comparisons) {
  ColumnsOf<C> columns = {
      {"measure", "", "Id of the mark or rating", &C::measure},
      {"method", "", "Id of the method", &C::method},
      {"reference", "", "Id of the method that it is compared with", &C::reference},
      {"status", "", "planned in the protocol, or exploratory",
       [](const C& row) { return row.planned ? "planned" : "exploratory"; }},
      {"n", "", "Participants with a pair of trials", &C::n},
      {"pairs", "", "Pairs of trials with both values, of a participant in a scene", &C::pairs},
      {"censored_pairs", "", "Pairs with a right-censored time, which are not among these",
       &C::censored}};
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
      {"n", "", "Participants with values of all methods", path(&O::ranks, &F::participants)},
      {"participants_left_out", "", "Participants with a missing value", &O::left_out},
      {"censored", "", "Right-censored times of the measure, which are left out", &O::censored},
      {"f", "", "F of the repeated-measures analysis of variance of log times",
       path(&O::variance, &V::f)},
      {"df", "", "Degrees of freedom of the methods", path(&O::variance, &V::degrees_of_freedom)},
      {"residual_df", "", "Degrees of freedom of the residuals",
       path(&O::variance, &V::residual_degrees_of_freedom)},
      {"p_uncorrected", "", "P of F without a correction for sphericity",
       path(&O::variance, &V::p)},
      {"epsilon_greenhouse_geisser", "", "Greenhouse and Geisser's epsilon",
       path(&O::variance, &V::greenhouse_geisser)},
      {"p_greenhouse_geisser", "", "P with both degrees of freedom times that epsilon",
       path(&O::variance, &V::p_greenhouse_geisser)},
      {"epsilon_huynh_feldt", "", "Huynh and Feldt's epsilon", path(&O::variance, &V::huynh_feldt)},
      {"p_huynh_feldt", "", "P with both degrees of freedom times that epsilon",
       path(&O::variance, &V::p_huynh_feldt)},
      {"partial_eta_squared", "", "Effect size of the methods",
       path(&O::variance, &V::partial_eta_squared)},
      {"friedman_chi_squared", "", "Friedman's statistic, corrected for ties",
       path(&O::ranks, &F::chi_squared)},
      {"friedman_df", "", "Its degrees of freedom", path(&O::ranks, &F::degrees_of_freedom)},
      {"p_friedman", "", "Its P", path(&O::ranks, &F::p)},
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
      {"n", "", "Participants whose order varies", path(&O::change_per_step, &TTest::n)},
      {"censored", "", "Right-censored times of the measure, which are left out", &O::censored},
      {"change_percent", "%", "Of times: change with each step", percent(&TTest::mean)},
      {"ci95_low_percent", "%", "Lower end of its 95 % interval",
       percent(&TTest::interval, &Interval::low)},
      {"ci95_high_percent", "%", "Upper end of its 95 % interval",
       percent(&TTest::interval, &Interval::high)},
      {"change_points", "points", "Of ratings: change with each step", points(&TTest::mean)},
      {"ci95_low_points", "points", "Lower end of its 95 % interval",
       points(&TTest::interval, &Interval::low)},
      {"ci95_high_points", "points", "Upper end of its 95 % interval",
       points(&TTest::interval, &Interval::high)},
      {"t", "", "t of the participants' slopes", path(&O::change_per_step, &TTest::t)},
      {"df", "", "Its degrees of freedom", path(&O::change_per_step, &TTest::degrees_of_freedom)},
      {"p", "", "Its two-sided P", path(&O::change_per_step, &TTest::p)},
      {"d_z", "", "Effect size: mean over standard deviation of the slopes",
       path(&O::change_per_step, &TTest::d_z)},
      kind_of_all<O>(tables)};
  return tabulate("order_effects", "measure and way of counting", columns, comparisons.order);
}

Table models_table(const StudyTables& tables, const Comparisons& comparisons) {
  using M = FittedModel;
  using Fit = FittedModel::Fit;
  const ColumnsOf<M> columns = {
      {"measure", "", "Id of the mark or rating", &M::measure},
      {"method", "", "Id of the method", &M::method},
      {"reference", "", "Id of the method that it is compared with", &M::reference},
      {"model", "",
       "crossed: mixed model of log times, or of points on a scale with many; tobit: of log times "
       "with right-censored ones; ordinal: cumulative link mixed model of ratings",
       &M::model},
      {"scale", "", "ratio of times, odds ratio of a higher rating, or points", &M::scale},
      {"estimate", "", "Natural logarithm of the ratio or odds ratio, or points",
       path(&M::fit, &Fit::estimate)},
      {"standard_error", "", "Its standard error", path(&M::fit, &Fit::standard_error)},
      {"df", "", "Its degrees of freedom", path(&M::fit, &Fit::degrees_of_freedom)},
      {"ci95_low", "", "Lower end of its 95 % interval",
       path(&M::fit, &Fit::interval, &Interval::low)},
      {"ci95_high", "", "Upper end of its 95 % interval",
       path(&M::fit, &Fit::interval, &Interval::high)},
      {"p", "", "Its two-sided P", path(&M::fit, &Fit::p)},
      {"trials", "", "Trials of the model", &M::trials},
      {"participants", "", "Participants of the model", &M::participants},
      {"scenes", "", "Scenes of the model", &M::scenes},
      {"censored", "", "Trials with a right-censored time", &M::censored},
      {"participant_sd", "",
       "Standard deviation between participants of the difference between the methods",
       &M::participant_sd},
      {"scene_sd", "", "Standard deviation between scenes of the difference between the methods",
       &M::scene_sd},
      {"residual_sd", "", "Standard deviation of the difference within a scene", &M::residual_sd},
      {"note", "", "Why there is no estimate, or warnings of R", &M::note},
      kind_of_all<M>(tables)};
  return tabulate("models", "model that R fitted (--r)", columns, comparisons.models.models);
}

Table model_versions_table(const StudyTables& tables, const Comparisons& comparisons) {
  using V = std::pair<std::string, std::string>;
  const ColumnsOf<V> columns = {{"name", "", "R or one of its packages", &V::first},
                                {"version", "", "Its version", &V::second},
                                kind_of_all<V>(tables)};
  return tabulate("model_versions", "program that fitted models (--r)", columns,
                  comparisons.models.versions);
}

}  // namespace foveola::analysis
