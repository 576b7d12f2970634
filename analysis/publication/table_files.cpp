#include "analysis/publication/table_files.h"

#include <utility>

#include <fmt/format.h>

#include "renderer/base/csv.h"

namespace foveola::analysis {
namespace {

std::string low_of(const std::optional<Estimate>& estimate) {
  return estimate && estimate->interval ? csv_number(estimate->interval->low) : "";
}

std::string high_of(const std::optional<Estimate>& estimate) {
  return estimate && estimate->interval ? csv_number(estimate->interval->high) : "";
}

std::string value_of(const std::optional<Estimate>& estimate) {
  return estimate ? csv_number(estimate->value) : "";
}

/// Ends each row with the kind of participants, so that simulated data cannot pass for people's.
std::string finished_csv(std::vector<CsvRow> rows, const StudyTables& tables) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].push_back(i == 0 ? "participant_kind" : tables.set.kind);
  }
  return format_csv(rows);
}

std::string scene_times_csv(const StudyTables& tables) {
  std::vector<CsvRow> rows = {{"mark", "scene", "method", "n", "mean_s", "sd_s", "median_s",
                               "n_pairs", "mean_percent_of_baseline", "sd_percent_of_baseline",
                               "ratio_of_means_percent", "sd_over_baseline_mean_percent",
                               "censored", "missing"}};
  for (const SceneTimes& row : tables.scene_times) {
    rows.push_back({std::string(name_of(row.mark)), row.scene, row.method,
                    std::to_string(row.seconds.n), csv_number(row.seconds.mean),
                    csv_number(row.seconds.standard_deviation), csv_number(row.seconds.median),
                    std::to_string(row.percent_of_baseline.n),
                    csv_number(row.percent_of_baseline.mean),
                    csv_number(row.percent_of_baseline.standard_deviation),
                    csv_number(row.of_baseline_mean.mean_percent),
                    csv_number(row.of_baseline_mean.sd_percent_points),
                    std::to_string(row.censored), std::to_string(row.missing)});
  }
  return finished_csv(std::move(rows), tables);
}

std::string method_times_csv(const StudyTables& tables) {
  std::vector<CsvRow> rows = {{"mark", "method", "n", "geometric_mean_s", "ci95_low_s",
                               "ci95_high_s", "geometric_mean_percent_of_baseline",
                               "ci95_low_percent_of_baseline", "ci95_high_percent_of_baseline"}};
  for (const MethodTimes& row : tables.method_times) {
    rows.push_back({std::string(name_of(row.mark)), row.method,
                    std::to_string(row.participant_seconds.size()), value_of(row.seconds),
                    low_of(row.seconds), high_of(row.seconds), value_of(row.percent_of_baseline),
                    low_of(row.percent_of_baseline), high_of(row.percent_of_baseline)});
  }
  return finished_csv(std::move(rows), tables);
}

std::string ratings_csv(const StudyTables& tables) {
  std::vector<CsvRow> rows = {{"method", "n", "mean", "sd", "median", "count_1", "count_2",
                               "count_3", "count_4", "count_5", "missing"}};
  for (const MethodRatings& ratings : tables.ratings) {
    CsvRow row = {ratings.method, std::to_string(ratings.rating.n), csv_number(ratings.rating.mean),
                  csv_number(ratings.rating.standard_deviation), csv_number(ratings.rating.median)};
    for (const int count : ratings.counts) {
      row.push_back(std::to_string(count));
    }
    row.push_back(std::to_string(ratings.missing));
    rows.push_back(std::move(row));
  }
  return finished_csv(std::move(rows), tables);
}

/// The coefficient, t, P and the coefficient's interval; empty fields where it is not defined.
CsvRow correlation_fields(const std::optional<Correlation>& found) {
  if (!found) {
    return {"", "", "", "", ""};
  }
  return {csv_number(found->r), csv_number(found->t), csv_number(found->p),
          found->interval ? csv_number(found->interval->low) : "",
          found->interval ? csv_number(found->interval->high) : ""};
}

std::string background_csv(const StudyTables& tables) {
  std::vector<CsvRow> rows = {{"mark", "method", "background_questions", "n", "pearson_r", "t",
                               "p_two_sided", "ci95_low_r", "ci95_high_r", "spearman_rho", "t_rho",
                               "p_rho", "ci95_low_rho", "ci95_high_rho", "p_rho_exact"}};
  const std::string questions = fmt::format("{}", fmt::join(tables.background.questions, "+"));
  for (const BackgroundCorrelation& correlation : tables.background_correlations) {
    CsvRow row = {std::string(name_of(correlation.mark)), correlation.method, questions,
                  std::to_string(correlation.participants)};
    for (const auto* found : {&correlation.pearson, &correlation.spearman}) {
      const CsvRow fields = correlation_fields(*found);
      row.insert(row.end(), fields.begin(), fields.end());
    }
    row.emplace_back(!correlation.spearman ? "" : correlation.spearman->exact ? "true" : "false");
    rows.push_back(std::move(row));
  }
  return finished_csv(std::move(rows), tables);
}

std::string background_answers_csv(const StudyTables& tables) {
  std::vector<CsvRow> rows = {{"question", "n", "mean", "sd", "median", "missing"}};
  for (const QuestionAnswers& row : tables.background_answers) {
    rows.push_back({row.question, std::to_string(row.answers.n), csv_number(row.answers.mean),
                    csv_number(row.answers.standard_deviation), csv_number(row.answers.median),
                    std::to_string(row.missing)});
  }
  return finished_csv(std::move(rows), tables);
}

std::string amended_csv(const StudyTables& tables) {
  std::vector<CsvRow> rows = {
      {"participant", "protocol_sha256", "changed_keys", "analysed", "participant_kind"}};
  for (const AmendedSession& row : tables.amended) {
    rows.push_back({row.participant, row.protocol_sha256,
                    fmt::format("{}", fmt::join(row.changed_keys, " ")),
                    row.is_analysed ? "true" : "false", row.kind});
  }
  return format_csv(rows);
}

std::string exclusions_csv(const StudyTables& tables) {
  std::vector<CsvRow> rows = {
      {"participant", "scene", "method", "measure", "reason", "participant_kind"}};
  for (const Exclusion& row : tables.set.exclusions) {
    const auto kind = tables.set.kinds.find(row.participant);
    rows.push_back({row.participant, row.scene, row.method, row.measure, row.reason,
                    kind == tables.set.kinds.end() ? "" : kind->second});
  }
  return format_csv(rows);
}

}  // namespace

std::vector<TextFile> table_files(const StudyTables& tables) {
  return {{"table1_background.csv", background_answers_csv(tables)},
          {"table2_times.csv", scene_times_csv(tables)},
          {"figure5_geometric_means.csv", method_times_csv(tables)},
          {"figure6_artifact_ratings.csv", ratings_csv(tables)},
          {"background_correlation.csv", background_csv(tables)},
          {"exclusions.csv", exclusions_csv(tables)},
          {"amended_sessions.csv", amended_csv(tables)}};
}

}  // namespace foveola::analysis
