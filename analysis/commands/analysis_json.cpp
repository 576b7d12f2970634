#include "analysis/commands/analysis_json.h"

#include <nlohmann/json.hpp>

#include "analysis/commands/comparisons_json.h"
#include "analysis/publication/wording.h"

namespace foveola::analysis {
namespace {

using json = nlohmann::ordered_json;

json number(const std::optional<double>& value) { return value ? json(*value) : json(nullptr); }

json description(const Description& description) {
  return {{"n", description.n},
          {"mean", number(description.mean)},
          {"sd", number(description.standard_deviation)},
          {"median", number(description.median)}};
}

json interval(const std::optional<Interval>& interval) {
  return interval ? json{interval->low, interval->high} : json(nullptr);
}

json estimate(const std::optional<Estimate>& estimate) {
  if (!estimate) {
    return nullptr;
  }
  return {{"n", estimate->n}, {"value", estimate->value}, {"ci95", interval(estimate->interval)}};
}

json scene_times(const StudyTables& tables) {
  json rows = json::array();
  for (const SceneTimes& row : tables.scene_times) {
    rows.push_back(
        {{"mark", name_of(row.mark)},
         {"scene", row.scene},
         {"method", row.method},
         {"seconds", description(row.seconds)},
         {"percent_of_baseline", description(row.percent_of_baseline)},
         {"ratio_of_means_percent", number(row.of_baseline_mean.mean_percent)},
         {"sd_over_baseline_mean_percent", number(row.of_baseline_mean.sd_percent_points)},
         {"censored", row.censored},
         {"missing", row.missing},
         {"participant_kind", tables.set.kind}});
  }
  return rows;
}

json geometric_means(const StudyTables& tables) {
  json rows = json::array();
  for (const MethodTimes& row : tables.method_times) {
    rows.push_back({{"mark", name_of(row.mark)},
                    {"method", row.method},
                    {"seconds", estimate(row.seconds)},
                    {"percent_of_baseline", estimate(row.percent_of_baseline)},
                    {"participant_kind", tables.set.kind}});
  }
  return rows;
}

json artifact_ratings(const StudyTables& tables) {
  json rows = json::array();
  for (const MethodRatings& row : tables.ratings) {
    rows.push_back({{"method", row.method},
                    {"rating", description(row.rating)},
                    {"counts", row.counts},
                    {"missing", row.missing},
                    {"participant_kind", tables.set.kind}});
  }
  return rows;
}

json background(const StudyTables& tables) {
  json rows = json::array();
  for (const BackgroundCorrelation& row : tables.background_correlations) {
    json entry = {{"mark", name_of(row.mark)},
                  {"method", row.method},
                  {"n", row.participants},
                  {"pearson_r", nullptr},
                  {"p_two_sided", nullptr},
                  {"ci95_r", nullptr},
                  {"participant_kind", tables.set.kind}};
    if (row.correlation) {
      entry["pearson_r"] = row.correlation->r;
      entry["p_two_sided"] = row.correlation->p;
      entry["ci95_r"] = interval(row.correlation->interval);
    }
    rows.push_back(std::move(entry));
  }
  return {{"questions", tables.background.questions}, {"correlations", rows}};
}

}  // namespace

std::string analysis_json(const AnalysisOutput& output) {
  const StudyTables& tables = output.tables;
  const std::string notice = data_notice(tables);
  json files = json::array();
  for (const std::filesystem::path& file : output.files) {
    files.push_back(file.string());
  }
  const json result = {{"report", output.report.string()},
                       {"files", files},
                       {"warnings", output.warnings},
                       {"protocol", tables.protocol_name},
                       {"protocol_sha256", tables.protocol_sha256},
                       {"participant_kind", tables.set.kind},
                       {"data_notice", notice.empty() ? json(nullptr) : json(notice)},
                       {"participants", tables.set.participants.size()},
                       {"scenes", tables.set.scenes},
                       {"methods", tables.set.methods},
                       {"baseline", tables.set.methods.front()},
                       {"scene_times", scene_times(tables)},
                       {"geometric_means", geometric_means(tables)},
                       {"artifact_ratings", artifact_ratings(tables)},
                       {"background", background(tables)},
                       {"comparisons", comparisons_json(output.comparisons, tables.set.kind)},
                       {"omnibus", omnibus_json(output.comparisons, tables.set.kind)},
                       {"excluded", tables.set.exclusions.size()}};
  return result.dump(2, ' ', false, json::error_handler_t::replace);
}

}  // namespace foveola::analysis
