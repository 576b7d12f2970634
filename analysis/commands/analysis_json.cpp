#include "analysis/commands/analysis_json.h"

#include <nlohmann/json.hpp>

#include "analysis/commands/comparisons_json.h"
#include "analysis/publication/wording.h"
#include "study/record/verification_json.h"

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

json correlation(const std::optional<Correlation>& found) {
  if (!found) {
    return nullptr;
  }
  return {{"r", found->r},
          {"ci95", interval(found->interval)},
          {"t", found->t},
          {"p_two_sided", found->p},
          {"exact", found->exact}};
}

json background(const StudyTables& tables) {
  json answers = json::array();
  for (const QuestionAnswers& row : tables.background_answers) {
    answers.push_back({{"question", row.question},
                       {"answers", description(row.answers)},
                       {"missing", row.missing},
                       {"participant_kind", tables.set.kind}});
  }
  json rows = json::array();
  for (const BackgroundCorrelation& row : tables.background_correlations) {
    rows.push_back({{"mark", name_of(row.mark)},
                    {"method", row.method},
                    {"n", row.participants},
                    {"pearson", correlation(row.pearson)},
                    {"spearman", correlation(row.spearman)},
                    {"participant_kind", tables.set.kind}});
  }
  return {{"answers", answers},
          {"scale", tables.background.questions},
          {"scale_as_published", tables.background.as_published},
          {"correlations", rows}};
}

json amended(const StudyTables& tables) {
  json rows = json::array();
  for (const AmendedSession& row : tables.amended) {
    rows.push_back({{"participant", row.participant},
                    {"protocol_sha256", row.protocol_sha256},
                    {"changed_keys", row.changed_keys},
                    {"analysed", row.is_analysed},
                    {"participant_kind", row.kind}});
  }
  return rows;
}

json data_quality(const DataQualityReport& report, const std::string& kind) {
  json checks = json::array();
  for (const DataQualityCheck& check : report.checks) {
    checks.push_back({{"check", check.name},
                      {"verdict", name_of(check.verdict)},
                      {"found", check.found},
                      {"limit", check.limit}});
  }
  json latency = json::array();
  for (const study::FrameFigures& row : report.frames) {
    latency.push_back({{"participant", row.participant},
                       {"frames", row.frames},
                       {"late_frames", row.late},
                       {"untracked_frames", row.untracked},
                       {"mean_gaze_age_s", row.mean_gaze_age_s},
                       {"mean_poll_to_display_s", row.mean_to_display_s},
                       {"longest_frame_s", row.longest_frame_s},
                       {"longest_frame_to_mark_s", row.longest_mark_after_frame_s}});
  }
  json reactions = json::array();
  for (const ReactionFloor& row : report.reactions) {
    reactions.push_back({{"participant", row.participant},
                         {"presses", row.presses},
                         {"false_starts", row.false_starts},
                         {"median_s", number(row.median_s)},
                         {"marks", row.marks},
                         {"marks_within_median", row.within_floor}});
  }
  return {{"checks", checks},
          {"latency", latency},
          {"reaction_times", reactions},
          {"participant_kind", kind}};
}

}  // namespace

std::string analysis_json(const AnalysisOutput& output) {
  const StudyTables& tables = output.tables;
  const std::string notice = data_notice(tables);
  json files = json::array();
  for (const std::filesystem::path& file : output.files) {
    files.push_back(file.string());
  }
  const json result = {
      {"report", output.report.string()},
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
      {"order_effects", order_json(output.comparisons, tables.set.kind)},
      {"record", output.record ? study::verification_json(*output.record) : json(nullptr)},
      {"data_quality", data_quality(output.checks, tables.set.kind)},
      {"amended_sessions", amended(tables)},
      {"excluded", tables.set.exclusions.size()}};
  return result.dump(2, ' ', false, json::error_handler_t::replace);
}

}  // namespace foveola::analysis
