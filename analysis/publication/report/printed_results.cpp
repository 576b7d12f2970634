#include "analysis/publication/report/printed_results.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/dataset/wording.h"
#include "analysis/koskela2018/profile.h"
#include "analysis/publication/report/published_comparison_report.h"
#include "analysis/publication/tables/result_tables.h"
#include "analysis/tables/row_text.h"

namespace foveola::analysis {
namespace {

std::string baseline_name(const StudyTables& tables) {
  return method_label(tables.set.methods[baseline]);
}

/// Returns one number if it is the same for every method, else one per method, in their order.
std::string count_per_method(const std::vector<std::size_t>& counts) {
  const bool same =
      std::ranges::all_of(counts, [&](std::size_t count) { return count == counts.front(); });
  return same ? std::to_string(counts.front()) : fmt::format("{}", fmt::join(counts, " / "));
}

std::vector<std::string> scene_row(const StudyTables& tables, std::size_t mark, std::size_t scene) {
  std::vector<std::string> row = {tables.set.scenes[scene]};
  std::vector<std::size_t> n;
  int censored = 0;
  int missing = 0;
  for (std::size_t method = 0; method < tables.set.methods.size(); ++method) {
    const SceneTimes& times = tables.scene_times_of(mark, scene, method);
    const Description& shown = method == baseline ? times.seconds : times.percent_of_baseline;
    row.push_back(mean_and_deviation(shown, method == baseline ? 2 : 1));
    n.push_back(shown.n);
    censored += times.censored;
    missing += times.missing;
  }
  row.push_back(count_per_method(n));
  row.push_back(std::to_string(censored));
  row.push_back(std::to_string(missing));
  return row;
}

std::vector<std::string> overall_row(const StudyTables& tables, std::size_t mark) {
  std::vector<std::string> row = {"geometric mean"};
  std::vector<std::size_t> n;
  for (std::size_t method = 0; method < tables.set.methods.size(); ++method) {
    const MethodTimes& times = tables.method_times_of(mark, method);
    row.push_back(method == baseline ? with_interval(times.seconds, 2)
                                     : with_interval(times.percent_of_baseline, 1));
    n.push_back(times.participant_seconds.size());
  }
  row.push_back(count_per_method(n));
  row.insert(row.end(), 2, "");
  return row;
}

}  // namespace

PrintedTable printed_times(const StudyTables& tables, std::size_t mark,
                           const std::optional<PublishedStudy>& published) {
  const Measure& measure = tables.set.measures[mark];
  const std::string reference = baseline_name(tables);
  PrintedTable table;
  table.id = "times-" + measure.id();
  table.title = fmt::format("Time until {}.", moment_of(tables.set, measure));
  table.note = fmt::format(
      "{} in seconds; other methods in per cent of each participant’s own {} time in the same "
      "scene. Mean ± standard deviation over n participants; last, the geometric mean over scenes "
      "with its 95 % confidence interval.{}",
      reference, reference, published_rows_explained(tables, published));
  table.columns = {"Scene"};
  for (std::size_t method = 0; method < tables.set.methods.size(); ++method) {
    table.columns.push_back(method_label(tables.set.methods[method]) +
                            (method == baseline ? ", s" : ", %"));
  }
  table.columns.insert(table.columns.end(), {"n", "right-censored", "missing"});
  for (std::size_t scene = 0; scene < tables.set.scenes.size(); ++scene) {
    table.rows.push_back(scene_row(tables, mark, scene));
    if (auto row = published_row(tables, mark, scene, tables.set.methods, published)) {
      row->push_back(fmt::format("{:g}", published_number(*published, "participants").value));
      row->insert(row->end(), 2, "");
      table.rows.push_back(std::move(*row));
    }
  }
  table.rows.push_back(overall_row(tables, mark));
  return table;
}

PrintedTable printed_ratios_of_means(const StudyTables& tables, std::size_t mark,
                                     const std::optional<PublishedStudy>& published) {
  const std::string reference = baseline_name(tables);
  PrintedTable table;
  table.id = "ratios-of-means-" + tables.set.measures[mark].id();
  table.title = fmt::format("Time until {}, in per cent of {}’s mean time.",
                            moment_of(tables.set, tables.set.measures[mark]), reference);
  table.note = fmt::format(
      "Mean time over participants in per cent of {}’s mean time in the scene ± standard deviation "
      "in percentage points of it.{}",
      reference, published_rows_explained(tables, published));
  table.columns = {"Scene"};
  for (std::size_t method = baseline + 1; method < tables.set.methods.size(); ++method) {
    table.columns.push_back(method_label(tables.set.methods[method]) + ", %");
  }
  const std::vector<std::string> methods(tables.set.methods.begin() + baseline + 1,
                                         tables.set.methods.end());
  for (std::size_t scene = 0; scene < tables.set.scenes.size(); ++scene) {
    std::vector<std::string> row = {tables.set.scenes[scene]};
    for (std::size_t method = baseline + 1; method < tables.set.methods.size(); ++method) {
      const OfBaselineMean& times = tables.scene_times_of(mark, scene, method).of_baseline_mean;
      row.push_back(mean_and_deviation(
          {.n = 0, .mean = times.mean_percent, .standard_deviation = times.sd_percent_points}, 1));
    }
    table.rows.push_back(std::move(row));
    if (auto beside = published_row(tables, mark, scene, methods, published)) {
      table.rows.push_back(std::move(*beside));
    }
  }
  return table;
}

PrintedTable printed_geometric_means(const StudyTables& tables,
                                     const std::optional<PublishedStudy>& published) {
  PrintedTable table;
  table.id = "geometric-means";
  table.title = "Geometric means over scenes.";
  table.note = join_sentences("With 95 % confidence intervals over n participants.",
                              censored_times_in_words(tables.set));
  table.columns = {"Method and mark", "n", "seconds", "% of " + baseline_name(tables)};
  const bool has_published = published && is_relative_to_od(tables.set);
  if (has_published) {
    table.title = "Geometric means over scenes; published: geometric mean over scenes of Table 2.";
    table.note +=
        " The published column is computed by us from the printed means of Table 2 (Koskela et al. "
        "2018, section 5.2); the paper does not say how its percentages were formed. Difference: "
        "this study’s less the published, of percentages in percentage points.";
    table.columns.insert(table.columns.end(), {"published", "difference"});
  }
  for (const MethodTimes& times : tables.method_times) {
    std::vector<std::string>& row = table.rows.emplace_back();
    row = {fmt::format("{}, {}", method_label(times.method), times.mark),
           std::to_string(times.participant_seconds.size()), with_interval(times.seconds, 2),
           with_interval(times.percent_of_baseline, 1)};
    if (has_published) {
      const std::vector<std::string> beside = published_mean_and_difference(times, *published);
      row.insert(row.end(), beside.begin(), beside.end());
    }
  }
  return table;
}

PrintedTable printed_time_to_mark(const Table& time_to_mark) {
  return print_rows(
      {.id = "time-to-mark",
       .title = "Time to each mark, including right-censored trials.",
       .note =
           "Kaplan and Meier’s estimate over trials; restricted means count times up to "
           "the horizon. They describe these trials: intervals treat trials as independent, but "
           "those of one participant are dependent."},
      with_method_labels(time_to_mark), "",
      {{"Mark, method", "{mark}, {method}"},
       {"trials", "{trials}"},
       {"not reached", "{right_censored}"},
       {"median, s [95 %]", "{median_s:.1} [{median_ci95_low_s:.1}, {median_ci95_high_s:.1}]",
        "{median_s:.1} [{median_ci95_low_s:.1}, ∞]", "{median_s:.1} [–, {median_ci95_high_s:.1}]",
        "{median_s:.1} [–, ∞]", "not reached"},
       {"restricted mean, s", "{restricted_mean_s:.1}"},
       {"horizon, s", "{horizon_s:.1}"}});
}

PrintedTable printed_ratings(const StudyTables& tables, std::size_t rating) {
  const Measure& measure = tables.set.measures[rating];
  PrintedTable table;
  table.id = "ratings-" + measure.id();
  table.title = fmt::format("Ratings: {}.", measure.id());
  table.note = fmt::format("“{}” {}.{}", measure.question.text, study::scale_in_words(measure),
                           amendments_of_scale(tables.set, rating));
  table.columns = {"Method"};
  const std::vector<double> points = measure.points();
  for (const double point : points) {
    table.columns.push_back(fmt::format("{:g}", point));
  }
  if (!points.empty()) {
    table.groups = {{"", 1}, {"Answers", static_cast<int>(points.size())}, {"Summary", 4}};
  }
  table.columns.insert(table.columns.end(), {"n", "missing", "mean ± sd", "median"});
  for (const MethodRatings& ratings : tables.ratings_of(rating)) {
    std::vector<std::string>& row = table.rows.emplace_back();
    row.push_back(method_label(ratings.method));
    for (const RatingCount& answer : ratings.counts) {
      row.push_back(std::to_string(answer.count));
    }
    row.push_back(std::to_string(ratings.description.n));
    row.push_back(std::to_string(ratings.missing));
    row.push_back(mean_and_deviation(ratings.description, 2));
    row.push_back(fixed(ratings.description.median, 1));
  }
  return table;
}

PrintedTable printed_answers(const Table& answers) {
  return print_rows(
      {.id = "answers",
       .title = "Answers of questionnaires.",
       .note = "Mean, standard deviation (sd) and median of the answers that are numbers."},
      answers, "",
      {{"Question", "{questionnaire}: {question}"},
       {"scale", "{scale}", ""},
       {"n", "{n}"},
       {"mean", "{mean:.2}"},
       {"sd", "{sd:.2}"},
       {"median", "{median:.1}"},
       {"missing", "{missing}"}});
}

PrintedTable printed_scores(const Table& scores) {
  // Grouped by the texts of the first two cells, in the order of the rows.
  std::vector<std::pair<std::vector<std::string>, std::vector<double>>> groups;
  for (const Row& row : scores.rows) {
    const auto name = fill("{status=analysed}{questionnaire} (step {step}), {score}", scores, row);
    if (!name) {
      continue;
    }
    const std::vector<std::string> key = {*name, fill("{instrument}", scores, row).value_or("")};
    auto group =
        std::ranges::find_if(groups, [&](const auto& known) { return known.first == key; });
    if (group == groups.end()) {
      group = groups.insert(groups.end(), {key, {}});
    }
    if (const auto value = number_of(field_in(scores, row, "value"))) {
      group->second.push_back(*value);
    }
  }
  PrintedTable table{
      .id = "scores",
      .title = "Scores of questionnaires.",
      .note = "By their published keys, of the analysed sessions that filled them in.",
      .columns = {"Questionnaire and score", "instrument", "n", "mean", "sd", "median"}};
  for (const auto& [key, values] : groups) {
    const Description found = describe(values);
    table.rows.push_back({key[0], key[1], std::to_string(found.n), fixed(found.mean, 1),
                          fixed(found.standard_deviation, 1), fixed(found.median, 1)});
  }
  return table;
}

PrintedTable printed_background_answers(const Background& background,
                                        const std::optional<PublishedStudy>& published) {
  PrintedTable table;
  table.id = "background-answers";
  table.title = "Background; published: Table 1.";
  table.note =
      "Means over n participants with 95 % confidence intervals by Student’s t; age in years, else "
      "points. "
      "Published: Table 1 of Koskela et al. 2018, section 5.1. Difference: of the means, this "
      "study’s less the published.";
  table.columns = {"Question", "n", "mean [95 %]", "sd", "published", "difference"};
  for (const QuestionAnswers& own : background.answers) {
    const PublishedAnswers* answers =
        published ? published_answers(*published, own.question) : nullptr;
    if (answers != nullptr) {
      const Description& given = own.answers;
      table.rows.push_back(
          {own.question, std::to_string(given.n), with_interval(mean_estimate(given), 2),
           fixed(given.standard_deviation, 2),
           fmt::format("{:.1f} ± {:.1f}", answers->mean, answers->standard_deviation),
           given.mean ? with_sign(*given.mean - answers->mean, 2) : "–"});
    }
  }
  return table;
}

PrintedTable printed_background(const StudyTables& tables, const Table& correlation) {
  const std::string reference = baseline_name(tables);
  return print_rows(
      {.id = "background",
       .title = "Correlation of background with speed-up.",
       .note = join_sentences(
           fmt::format("Pearson’s r of the values, whose two-sided P is that of the stated "
                       "hypothesis, and Spearman’s ρ of their ranks, with 95 % confidence "
                       "intervals. Speed-up "
                       "is a participant’s mean over scenes of the logarithm of {}’s time over the "
                       "method’s. A dash: not defined, because of fewer than three participants or "
                       "constant values.",
                       reference),
           censored_times_in_words(tables.set))},
      with_method_labels(correlation), "",
      {{"Speed-up", fmt::format("log({}/{{method}}), {{mark}}", reference)},
       {"n", "{n}"},
       {"r [95 %]", "{pearson_r:.2}| [{ci95_low_r:.2}, {ci95_high_r:.2}]"},
       {"t", "{t:.2}"},
       {"P", "{p_two_sided:p}"},
       {"ρ [95 %]", "{spearman_rho:.2}| [{ci95_low_rho:.2}, {ci95_high_rho:.2}]"},
       {"P, ρ", "{p_rho:p}{p_rho_exact: (exact)/}"}});
}

}  // namespace foveola::analysis
