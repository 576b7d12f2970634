#include "analysis/publication/tables/result_tables.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/dataset/answer_data.h"
#include "analysis/dataset/session_columns.h"
#include "analysis/dataset/wording.h"
#include "analysis/r_models/models_plan.h"

namespace foveola::analysis {
namespace {

/// Adds the columns of a correlation coefficient; the names of its limits end in `of`.
template <typename Path>
void add_correlation(const std::string& name, const std::string& of, const std::string& t,
                     const std::string& p, const std::string& p_from, const std::string& meaning,
                     const Path& found, ColumnsOf<BackgroundCorrelation>& columns) {
  const ColumnsOf<BackgroundCorrelation> added = {
      {name, "", meaning, path(found, &Correlation::r)},
      {t, "", "t statistic of " + name + ", with n − 2 degrees of freedom",
       path(found, &Correlation::t)},
      {p, "", "Two-sided P of " + name + p_from, path(found, &Correlation::p)},
      {"ci95_low_" + of, "", "Lower 95 % confidence limit of " + name + ", by Fisher's z",
       path(found, &Correlation::interval, &Interval::low)},
      {"ci95_high_" + of, "", "Upper 95 % confidence limit of " + name + ", by Fisher's z",
       path(found, &Correlation::interval, &Interval::high)}};
  columns.insert(columns.end(), added.begin(), added.end());
}

/// One answer of one method's ratings.
struct CountedAnswer {
  std::string rating;
  std::string method;
  RatingCount answer;
  std::string label;
};

}  // namespace

std::vector<Table> result_tables(const study::StudyRecords& records, const StudyTables& tables,
                                 const Background& background, const Comparisons& comparisons,
                                 const DataQualityReport& checks) {
  const study::AnalysisPlan& plan = comparisons.plan;
  std::vector<Table> all = {times_by_scene(tables),
                            times_by_method(tables),
                            time_to_mark_table(tables),
                            ratings_by_method(tables),
                            rating_counts(tables),
                            comparisons_table(tables, comparisons),
                            models_plan(tables.set, compared_pairs(tables.set, plan), plan.scenes),
                            models_table(tables, comparisons),
                            model_versions_table(tables, comparisons),
                            omnibus_table(tables, comparisons),
                            order_effects_table(tables, comparisons),
                            answers_by_question(records, tables.set),
                            questionnaire_scores(records, tables.set),
                            background_correlation(tables, background),
                            data_quality_table(tables, checks),
                            latency_table(tables, checks),
                            reaction_times_table(tables, checks),
                            catch_trials_table(tables, checks),
                            outlying_times_table(tables, checks),
                            exclusions(tables),
                            amended_sessions(tables)};
  for (Table& table : all) {
    table.columns.push_back(record_column());
    for (Row& row : table.rows) {
      row.push_back(field(tables.set.record));
    }
  }
  return all;
}

const Table& table_named(const std::vector<Table>& tables, std::string_view id) {
  return *std::ranges::find(tables, id, &Table::id);
}

Table with_method_labels(Table table) {
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const bool is_method =
        table.columns[i].name == "method" || table.columns[i].name == "reference";
    for (Row& row : table.rows) {
      if (auto* method = std::get_if<std::string>(&row[i]); is_method && method != nullptr) {
        *method = method_label(*method);
      }
    }
  }
  return table;
}

Table times_by_scene(const StudyTables& tables) {
  using T = SceneTimes;
  const ColumnsOf<T> columns = {
      {"mark", "", mark_meaning, &T::mark},
      {"scene", "", "Name of the scene", &T::scene},
      {"method", "", "Id of the method", &T::method},
      {"n", "", "Number of measured times", path(&T::seconds, &Description::n)},
      {"mean_s", "s", "Arithmetic mean of the measured times",
       path(&T::seconds, &Description::mean)},
      {"sd_s", "s", "Standard deviation of the measured times",
       path(&T::seconds, &Description::standard_deviation)},
      {"median_s", "s", "Median of the measured times", path(&T::seconds, &Description::median)},
      {"n_pairs", "",
       "Number of participants with a measured time of both the method and the baseline in this "
       "scene",
       path(&T::percent_of_baseline, &Description::n)},
      {"mean_percent_of_baseline", "%",
       "Mean of each participant's own time in per cent of the baseline's",
       path(&T::percent_of_baseline, &Description::mean)},
      {"sd_percent_of_baseline", "percentage points",
       "Standard deviation of the participants' percentages",
       path(&T::percent_of_baseline, &Description::standard_deviation)},
      {"geometric_mean_percent_of_baseline", "%",
       "Geometric mean of each participant's own ratio to the baseline",
       path(&T::geometric_percent, &Estimate::value)},
      {"ci95_low_percent_of_baseline", "%",
       "Lower 95 % confidence limit of geometric_mean_percent_of_baseline: Student's t of the "
       "participants' log ratios",
       path(&T::geometric_percent, &Estimate::interval, &Interval::low)},
      {"ci95_high_percent_of_baseline", "%",
       "Upper 95 % confidence limit of geometric_mean_percent_of_baseline: Student's t of the "
       "participants' log ratios",
       path(&T::geometric_percent, &Estimate::interval, &Interval::high)},
      {"ratio_of_means_percent", "%",
       "Mean time in per cent of the baseline's mean time: a ratio of means, not a mean of "
       "ratios",
       path(&T::of_baseline_mean, &OfBaselineMean::mean_percent)},
      {"sd_over_baseline_mean_percent", "percentage points",
       "Standard deviation of the times over the baseline's mean time",
       path(&T::of_baseline_mean, &OfBaselineMean::sd_percent_points)},
      {"censored", "", "Number of right-censored times, which are in no mean", &T::censored},
      {"missing", "", "Number of times that were not recorded", &T::missing},
      kind_of_all<T>(tables)};
  return tabulate("times_by_scene", "mark, scene and method", columns, tables.scene_times);
}

Table times_by_method(const StudyTables& tables) {
  using T = MethodTimes;
  const ColumnsOf<T> columns = {
      {"mark", "", mark_meaning, &T::mark},
      {"method", "", "Id of the method", &T::method},
      {"n", "", "Number of participants with a scene in which every method was measured",
       [](const T& row) { return row.participant_seconds.size(); }},
      {"geometric_mean_s", "s", "Geometric mean over scenes, then over participants",
       path(&T::seconds, &Estimate::value)},
      {"ci95_low_s", "s", "Lower 95 % confidence limit of geometric_mean_s, over participants",
       path(&T::seconds, &Estimate::interval, &Interval::low)},
      {"ci95_high_s", "s", "Upper 95 % confidence limit of geometric_mean_s, over participants",
       path(&T::seconds, &Estimate::interval, &Interval::high)},
      {"geometric_mean_percent_of_baseline", "%",
       "Geometric mean of each participant's own ratio to the baseline",
       path(&T::percent_of_baseline, &Estimate::value)},
      {"ci95_low_percent_of_baseline", "%",
       "Lower 95 % confidence limit of geometric_mean_percent_of_baseline: Student's t of the "
       "participants' log ratios",
       path(&T::percent_of_baseline, &Estimate::interval, &Interval::low)},
      {"ci95_high_percent_of_baseline", "%",
       "Upper 95 % confidence limit of geometric_mean_percent_of_baseline: Student's t of the "
       "participants' log ratios",
       path(&T::percent_of_baseline, &Estimate::interval, &Interval::high)},
      kind_of_all<T>(tables)};
  return tabulate("times_by_method", "mark and method", columns, tables.method_times);
}

Table time_to_mark_table(const StudyTables& tables) {
  using S = MarkSurvival;
  const auto median = path(&S::curve, &SurvivalCurve::median);
  const ColumnsOf<S> columns = {
      {"mark", "", mark_meaning, &S::mark},
      {"method", "", "Id of the method", &S::method},
      {"trials", "", "Number of trials with a time, measured or right-censored",
       path(&S::curve, &SurvivalCurve::n)},
      {"reached", "", "Number of trials in which the mark was reached",
       path(&S::curve, &SurvivalCurve::events)},
      {"right_censored", "", "Number of trials in which a time-out came first",
       path(&S::curve, &SurvivalCurve::censored)},
      {"median_s", "s",
       "Kaplan-Meier median time; empty if more than half of the trials have no mark",
       path(median, &SurvivalMedian::value)},
      {"median_ci95_low_s", "s",
       "Lower 95 % confidence limit of median_s, trials taken as independent",
       path(median, &SurvivalMedian::low)},
      {"median_ci95_high_s", "s", "Upper 95 % confidence limit of median_s; empty if there is none",
       path(median, &SurvivalMedian::high)},
      {"restricted_mean_s", "s", "Restricted mean of the times, each at most horizon_s",
       path(&S::restricted, &RestrictedMean::mean)},
      {"restricted_mean_se_s", "s",
       "Standard error of restricted_mean_s, trials taken as independent",
       path(&S::restricted, &RestrictedMean::standard_error)},
      {"horizon_s", "s",
       "Horizon of the restricted means: minimum right-censored time of any method, or the maximum "
       "time if none is",
       path(&S::restricted, &RestrictedMean::horizon)},
      kind_of_all<S>(tables)};
  return tabulate("time_to_mark", "mark and method", columns, tables.survival);
}

Table ratings_by_method(const StudyTables& tables) {
  using R = MethodRatings;
  const ColumnsOf<R> columns = {
      {"rating", "", "Id of the rating", &R::rating},
      {"method", "", "Id of the method", &R::method},
      {"n", "", "Number of answers, of all scenes and participants",
       path(&R::description, &Description::n)},
      {"mean", "", "Mean of the answers", path(&R::description, &Description::mean)},
      {"sd", "", "Standard deviation of the answers",
       path(&R::description, &Description::standard_deviation)},
      {"median", "", "Median of the answers", path(&R::description, &Description::median)},
      {"missing", "", "Number of trials without an answer", &R::missing},
      kind_of_all<R>(tables)};
  return tabulate("ratings_by_method", "rating and method", columns, tables.ratings);
}

Table rating_counts(const StudyTables& tables) {
  std::vector<CountedAnswer> answers;
  for (const MethodRatings& ratings : tables.ratings) {
    const Measure& measure = tables.set.measures[*tables.set.measure_named(ratings.rating)];
    for (const RatingCount& answer : ratings.counts) {
      answers.push_back({ratings.rating, ratings.method, answer, measure.label_of(answer.value)});
    }
  }
  using A = CountedAnswer;
  const ColumnsOf<A> columns = {
      {"rating", "", "Id of the rating", &A::rating},
      {"method", "", "Id of the method", &A::method},
      {"value", "", "Answer in points", path(&A::answer, &RatingCount::value)},
      {"label", "", "Label of the answer in the protocol, if it has one", &A::label},
      {"count", "", "Number of times that the answer was given",
       path(&A::answer, &RatingCount::count)},
      kind_of_all<A>(tables)};
  return tabulate("rating_counts", "rating, method and answer", columns, answers);
}

Table background_correlation(const StudyTables& tables, const Background& background) {
  using B = BackgroundCorrelation;
  const std::string questions = fmt::format("{}", fmt::join(background.scale, "+"));
  ColumnsOf<B> columns = {
      {"mark", "", mark_meaning, &B::mark},
      {"method", "", "Id of the method whose times are compared with the baseline's", &B::method},
      {"quantity", "",
       "Quantity correlated with background, a mean over scenes: log_ratio (natural logarithm of "
       "the "
       "baseline's time over the method's)",
       &B::quantity},
      {"background_questions", "", "The questions whose answers are averaged",
       [=](const B& /*row*/) { return questions; }},
      {"n", "", "Number of participants with all answers and a complete scene", &B::participants},
      {"censored", "", "Number of right-censored times of the mark, which are left out",
       [&](const B& row) { return tables.set.censored(*tables.set.measure_named(row.mark)); }}};
  add_correlation("pearson_r", "r", "t", "p_two_sided", ", from t",
                  "Pearson's correlation coefficient of the mean answer and the quantity",
                  &B::pearson, columns);
  add_correlation("spearman_rho", "rho", "t_rho", "p_rho", ", see p_rho_exact",
                  "Spearman's rank correlation coefficient of the mean answer and the quantity",
                  &B::spearman, columns);
  columns.push_back(
      {"p_rho_exact", "",
       "True: p_rho is exact, from all permutations of the ranks; false: it is from t_rho",
       path(&B::spearman, &Correlation::exact)});
  columns.push_back(kind_of_all<B>(tables));
  return tabulate("background_correlation", "correlation that the protocol states", columns,
                  background.correlation ? std::vector{*background.correlation} : std::vector<B>());
}

Table exclusions(const StudyTables& tables) {
  using E = Exclusion;
  const auto kind_of = [&](const E& row) {
    const auto kind = tables.set.kinds.find(row.participant);
    return kind == tables.set.kinds.end() ? std::nullopt : std::optional(kind->second);
  };
  const ColumnsOf<E> columns = {
      {"participant", "", "Code of the participant", &E::participant},
      {"scene", "", "Name of the scene; empty: all", &E::scene},
      {"method", "", "Id of the method; empty: all", &E::method},
      {"measure", "", "Id of the mark or rating; empty: all", &E::measure},
      {"reason", "",
       "Reason for the exclusion: the end of the session, with the recorded reason, or the fault "
       "of the value",
       &E::reason},
      {kind_column(), kind_of}};
  return tabulate("exclusions", "session or value that no number uses", columns,
                  tables.set.exclusions);
}

Table amended_sessions(const StudyTables& tables) {
  using A = AmendedSession;
  const ColumnsOf<A> columns = {
      {"participant", "", "Code of the participant", &A::participant},
      {"protocol_sha256", "", "SHA-256 of the amended protocol's text", &A::protocol_sha256},
      {"changed_keys", "", "Changed keys, separated by spaces; empty: comments only",
       [](const A& row) { return fmt::format("{}", fmt::join(row.changed_keys, " ")); }},
      {"analysed", "", "Whether the session is in the analysis", &A::is_analysed},
      {kind_column(), &A::kind}};
  return tabulate("amended_sessions",
                  "session with other texts or time-outs than the study's protocol", columns,
                  tables.amended);
}

}  // namespace foveola::analysis
