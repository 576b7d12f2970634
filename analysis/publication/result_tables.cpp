#include "analysis/publication/result_tables.h"

#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/publication/comparison_tables.h"

namespace foveola::analysis {
namespace {

using enum ColumnType;

Field value_of(const std::optional<Estimate>& estimate) {
  return field_in(estimate, [](const Estimate& found) { return found.value; });
}

Field low_of(const std::optional<Estimate>& estimate) {
  return estimate && estimate->interval ? field(estimate->interval->low) : Field();
}

Field high_of(const std::optional<Estimate>& estimate) {
  return estimate && estimate->interval ? field(estimate->interval->high) : Field();
}

/// The columns of a correlation coefficient, whose names end in `of`.
void add_correlation(
    const std::string& name, const std::string& of, const std::string& t, const std::string& p,
    const std::string& meaning,
    const std::function<const std::optional<Correlation>&(const BackgroundCorrelation&)>& found,
    ColumnsOf<BackgroundCorrelation>& columns) {
  const auto add = [&](std::string column, std::string description, auto value) {
    columns.push_back({{std::move(column), number, "", std::move(description)},
                       [=](const BackgroundCorrelation& row) { return value(found(row)); }});
  };
  using Found = std::optional<Correlation>;
  add(name, meaning, [](const Found& r) { return field_in(r, [](auto& c) { return c.r; }); });
  add(t, "t of " + name + ", of n − 2 degrees of freedom",
      [](const Found& r) { return field_in(r, [](auto& c) { return c.t; }); });
  add(p, "Two-sided P of no correlation",
      [](const Found& r) { return field_in(r, [](auto& c) { return c.p; }); });
  add("ci95_low_" + of, "Lower end of the 95 % interval of " + name,
      [](const Found& r) { return r && r->interval ? field(r->interval->low) : Field(); });
  add("ci95_high_" + of, "Upper end of the 95 % interval of " + name,
      [](const Found& r) { return r && r->interval ? field(r->interval->high) : Field(); });
}

/// One answer of one method's ratings.
struct CountedAnswer {
  const MethodRatings& ratings;
  const RatingCount& answer;
  std::string label;
};

}  // namespace

Column kind_column() {
  return {"participant_kind", text, "", "Who took part: human, pilot or simulated"};
}

Column record_column() {
  return {"record", text, "",
          "The study's file: verified, changed (analysed with --unverified), or none"};
}

Table stamped(Table table, const Dataset& set) {
  table.columns.push_back(record_column());
  for (Row& row : table.rows) {
    row.push_back(field(set.record));
  }
  return table;
}

Table times_by_scene(const StudyTables& tables) {
  using T = SceneTimes;
  const ColumnsOf<T> columns = {
      {{"mark", text, "", "Id of the mark"}, [](const T& row) { return field(row.mark); }},
      {{"scene", text, "", "Name of the scene"}, [](const T& row) { return field(row.scene); }},
      {{"method", text, "", "Id of the method"}, [](const T& row) { return field(row.method); }},
      {{"n", whole, "", "Number of measured times"},
       [](const T& row) { return field(row.seconds.n); }},
      {{"mean_s", number, "s", "Mean of the measured times"},
       [](const T& row) { return field(row.seconds.mean); }},
      {{"sd_s", number, "s", "Their standard deviation"},
       [](const T& row) { return field(row.seconds.standard_deviation); }},
      {{"median_s", number, "s", "Their median"},
       [](const T& row) { return field(row.seconds.median); }},
      {{"n_pairs", whole, "", "Participants with a time of the method and of the baseline"},
       [](const T& row) { return field(row.percent_of_baseline.n); }},
      {{"mean_percent_of_baseline", number, "%",
        "Mean of each participant's own time in per cent of the baseline's"},
       [](const T& row) { return field(row.percent_of_baseline.mean); }},
      {{"sd_percent_of_baseline", number, "percentage points", "Their standard deviation"},
       [](const T& row) { return field(row.percent_of_baseline.standard_deviation); }},
      {{"geometric_mean_percent_of_baseline", number, "%",
        "Geometric mean of each participant's own ratio to the baseline"},
       [](const T& row) { return value_of(row.geometric_percent); }},
      {{"ci95_low_percent_of_baseline", number, "%",
        "Lower end of its 95 % interval over participants, in this scene"},
       [](const T& row) { return low_of(row.geometric_percent); }},
      {{"ci95_high_percent_of_baseline", number, "%",
        "Upper end of its 95 % interval over participants, in this scene"},
       [](const T& row) { return high_of(row.geometric_percent); }},
      {{"ratio_of_means_percent", number, "%",
        "Mean time in per cent of the baseline's mean time: a ratio of means, not a mean of "
        "ratios"},
       [](const T& row) { return field(row.of_baseline_mean.mean_percent); }},
      {{"sd_over_baseline_mean_percent", number, "percentage points",
        "Standard deviation of the times over the baseline's mean time"},
       [](const T& row) { return field(row.of_baseline_mean.sd_percent_points); }},
      {{"censored", whole, "", "Number of right-censored times, which are in no mean"},
       [](const T& row) { return field(row.censored); }},
      {{"missing", whole, "", "Number of times that were not recorded"},
       [](const T& row) { return field(row.missing); }},
      kind_of_all<T>(tables)};
  return tabulate("times_by_scene", "mark, scene and method", columns, tables.scene_times);
}

Table times_by_method(const StudyTables& tables) {
  using T = MethodTimes;
  const ColumnsOf<T> columns = {
      {{"mark", text, "", "Id of the mark"}, [](const T& row) { return field(row.mark); }},
      {{"method", text, "", "Id of the method"}, [](const T& row) { return field(row.method); }},
      {{"n", whole, "", "Participants with a scene in which every method was measured"},
       [](const T& row) { return field(row.participant_seconds.size()); }},
      {{"geometric_mean_s", number, "s", "Geometric mean over scenes, then over participants"},
       [](const T& row) { return value_of(row.seconds); }},
      {{"ci95_low_s", number, "s", "Lower end of its 95 % interval over participants"},
       [](const T& row) { return low_of(row.seconds); }},
      {{"ci95_high_s", number, "s", "Upper end of its 95 % interval over participants"},
       [](const T& row) { return high_of(row.seconds); }},
      {{"geometric_mean_percent_of_baseline", number, "%",
        "Geometric mean of each participant's own ratio to the baseline"},
       [](const T& row) { return value_of(row.percent_of_baseline); }},
      {{"ci95_low_percent_of_baseline", number, "%",
        "Lower end of its 95 % interval over participants"},
       [](const T& row) { return low_of(row.percent_of_baseline); }},
      {{"ci95_high_percent_of_baseline", number, "%",
        "Upper end of its 95 % interval over participants"},
       [](const T& row) { return high_of(row.percent_of_baseline); }},
      kind_of_all<T>(tables)};
  return tabulate("times_by_method", "mark and method", columns, tables.method_times);
}

Table ratings_by_method(const StudyTables& tables) {
  using R = MethodRatings;
  const ColumnsOf<R> columns = {
      {{"rating", text, "", "Id of the rating"}, [](const R& row) { return field(row.rating); }},
      {{"method", text, "", "Id of the method"}, [](const R& row) { return field(row.method); }},
      {{"n", whole, "", "Number of answers, of all scenes and participants"},
       [](const R& row) { return field(row.description.n); }},
      {{"mean", number, "", "Mean of the answers"},
       [](const R& row) { return field(row.description.mean); }},
      {{"sd", number, "", "Their standard deviation"},
       [](const R& row) { return field(row.description.standard_deviation); }},
      {{"median", number, "", "Their median"},
       [](const R& row) { return field(row.description.median); }},
      {{"missing", whole, "", "Number of trials without an answer"},
       [](const R& row) { return field(row.missing); }},
      kind_of_all<R>(tables)};
  return tabulate("ratings_by_method", "rating and method", columns, tables.ratings);
}

Table rating_counts(const StudyTables& tables) {
  std::vector<CountedAnswer> answers;
  for (const MethodRatings& ratings : tables.ratings) {
    const Measure& measure = tables.set.measures[*tables.set.measure_named(ratings.rating)];
    for (const RatingCount& answer : ratings.counts) {
      answers.push_back({ratings, answer, measure.label_of(answer.value)});
    }
  }
  using A = CountedAnswer;
  const ColumnsOf<A> columns = {
      {{"rating", text, "", "Id of the rating"},
       [](const A& row) { return field(row.ratings.rating); }},
      {{"method", text, "", "Id of the method"},
       [](const A& row) { return field(row.ratings.method); }},
      {{"value", number, "", "The answer"}, [](const A& row) { return field(row.answer.value); }},
      {{"label", text, "", "Its label in the protocol, if it has one"},
       [](const A& row) { return field(row.label); }},
      {{"count", whole, "", "How often it was given"},
       [](const A& row) { return field(row.answer.count); }},
      kind_of_all<A>(tables)};
  return tabulate("rating_counts", "rating, method and answer", columns, answers);
}

Table background_correlation(const StudyTables& tables, const Background& background) {
  using B = BackgroundCorrelation;
  const std::string questions = fmt::format("{}", fmt::join(background.scale, "+"));
  ColumnsOf<B> columns = {
      {{"mark", text, "", "Id of the mark"}, [](const B& row) { return field(row.mark); }},
      {{"method", text, "", "The method whose times are compared with the baseline's"},
       [](const B& row) { return field(row.method); }},
      {{"quantity", text, "",
        "What background is held against, a mean over scenes: log_ratio (natural logarithm of the "
        "baseline's time over the method's)"},
       [](const B& row) { return field(std::string(name_of(row.quantity))); }},
      {{"background_questions", text, "", "The questions whose answers are averaged"},
       [=](const B& /*row*/) { return field(questions); }},
      {{"n", whole, "", "Participants with all answers and a complete scene"},
       [](const B& row) { return field(row.participants); }},
      {{"censored", whole, "", "Right-censored times of the mark, which are left out"},
       [&](const B& row) {
         return field(tables.set.censored(*tables.set.measure_named(row.mark)));
       }}};
  add_correlation(
      "pearson_r", "r", "t", "p_two_sided",
      "Pearson's correlation of the mean answer with the quantity",
      [](const B& row) -> const auto& { return row.pearson; }, columns);
  add_correlation(
      "spearman_rho", "rho", "t_rho", "p_rho", "Spearman's rank correlation of the same",
      [](const B& row) -> const auto& { return row.spearman; }, columns);
  columns.push_back(
      {{"p_rho_exact", truth, "", "Whether p_rho is of all orders of the ranks"}, [](const B& row) {
         return field_in(row.spearman, [](auto& found) { return found.exact; });
       }});
  columns.push_back(kind_of_all<B>(tables));
  return tabulate("background_correlation", "correlation that the protocol states", columns,
                  background.correlation ? std::vector{*background.correlation} : std::vector<B>());
}

Table exclusions(const StudyTables& tables) {
  using E = Exclusion;
  const auto kind_of = [&](const E& row) {
    const auto kind = tables.set.kinds.find(row.participant);
    return kind == tables.set.kinds.end() ? Field() : field(kind->second);
  };
  const ColumnsOf<E> columns = {{{"participant", text, "", "Code of the participant"},
                                 [](const E& row) { return field(row.participant); }},
                                {{"scene", text, "", "Name of the scene; empty: all"},
                                 [](const E& row) { return field(row.scene); }},
                                {{"method", text, "", "Id of the method; empty: all"},
                                 [](const E& row) { return field(row.method); }},
                                {{"measure", text, "", "Id of the mark or rating; empty: all"},
                                 [](const E& row) { return field(row.measure); }},
                                {{"reason", text, "", "Why no number uses it"},
                                 [](const E& row) { return field(row.reason); }},
                                {kind_column(), kind_of}};
  return tabulate("exclusions", "session or value that no number uses", columns,
                  tables.set.exclusions);
}

Table amended_sessions(const StudyTables& tables) {
  using A = AmendedSession;
  const ColumnsOf<A> columns = {
      {{"participant", text, "", "Code of the participant"},
       [](const A& row) { return field(row.participant); }},
      {{"protocol_sha256", text, "", "SHA-256 of the amended protocol's text"},
       [](const A& row) { return field(row.protocol_sha256); }},
      {{"changed_keys", text, "",
        "The keys that were changed, separated by spaces; empty: comments only"},
       [](const A& row) { return field(fmt::format("{}", fmt::join(row.changed_keys, " "))); }},
      {{"analysed", truth, "", "Whether the session is in the analysis"},
       [](const A& row) { return field(row.is_analysed); }},
      {kind_column(), [](const A& row) { return field(row.kind); }}};
  return tabulate("amended_sessions",
                  "session by other words or time-outs than the study's protocol", columns,
                  tables.amended);
}

using enum ColumnType;

Table models_table(const StudyTables& tables, const Comparisons& comparisons) {
  using M = FittedModel;
  using Fit = FittedModel::Fit;
  const auto of_fit = [](const char* name, const char* description, auto value) {
    return ColumnOf<M>{{name, number, "", description},
                       [=](const M& row) { return field_in(row.fit, value); }};
  };
  const auto end = [](const Fit& fit, double Interval::* which) {
    return fit.interval ? std::optional(*fit.interval.*which) : std::nullopt;
  };
  const ColumnsOf<M> columns = {
      {{"measure", text, "", "Id of the mark or rating"},
       [](const M& row) { return field(row.measure); }},
      {{"method", text, "", "Id of the method"}, [](const M& row) { return field(row.method); }},
      {{"reference", text, "", "Id of the method that it is compared with"},
       [](const M& row) { return field(row.reference); }},
      {{"model", text, "",
        "crossed: mixed model of log times, or of points on a scale with many; tobit: of log times "
        "with right-censored ones; ordinal: cumulative link mixed model of ratings"},
       [](const M& row) { return field(row.model); }},
      {{"scale", text, "", "ratio of times, odds ratio of a higher rating, or points"},
       [](const M& row) { return field(std::string(name_of(row.scale))); }},
      of_fit("estimate", "Natural logarithm of the ratio or odds ratio, or points",
             [](const Fit& fit) { return fit.estimate; }),
      of_fit("standard_error", "Its standard error",
             [](const Fit& fit) { return fit.standard_error; }),
      of_fit("df", "Its degrees of freedom", [](const Fit& fit) { return fit.degrees_of_freedom; }),
      of_fit("ci95_low", "Lower end of its 95 % interval",
             [=](const Fit& fit) { return end(fit, &Interval::low); }),
      of_fit("ci95_high", "Upper end of its 95 % interval",
             [=](const Fit& fit) { return end(fit, &Interval::high); }),
      of_fit("p", "Its two-sided P", [](const Fit& fit) { return fit.p; }),
      {{"trials", whole, "", "Trials of the model"},
       [](const M& row) { return field(row.trials); }},
      {{"participants", whole, "", "Participants of the model"},
       [](const M& row) { return field(row.participants); }},
      {{"scenes", whole, "", "Scenes of the model"},
       [](const M& row) { return field(row.scenes); }},
      {{"censored", whole, "", "Trials with a right-censored time"},
       [](const M& row) { return field(row.censored); }},
      {{"participant_sd", number, "",
        "Standard deviation between participants of the difference between the methods"},
       [](const M& row) { return field(row.participant_sd); }},
      {{"scene_sd", number, "",
        "Standard deviation between scenes of the difference between the methods"},
       [](const M& row) { return field(row.scene_sd); }},
      {{"residual_sd", number, "", "Standard deviation of the difference within a scene"},
       [](const M& row) { return field(row.residual_sd); }},
      {{"note", text, "", "Why there is no estimate, or warnings of R"},
       [](const M& row) { return field(row.note); }},
      kind_of_all<M>(tables)};
  return tabulate("models", "model that R fitted (--r)", columns, comparisons.models.models);
}

Table model_versions_table(const StudyTables& tables, const Comparisons& comparisons) {
  using V = std::pair<std::string, std::string>;
  const ColumnsOf<V> columns = {
      {{"name", text, "", "R or one of its packages"},
       [](const V& row) { return field(row.first); }},
      {{"version", text, "", "Its version"}, [](const V& row) { return field(row.second); }},
      kind_of_all<V>(tables)};
  return tabulate("model_versions", "program that fitted models (--r)", columns,
                  comparisons.models.versions);
}

}  // namespace foveola::analysis
