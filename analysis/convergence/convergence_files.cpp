#include "analysis/convergence/convergence_files.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/csv.h"
#include "renderer/measure/region_error.h"

namespace foveola::analysis {
namespace {

using json = nlohmann::ordered_json;

// --- CSV ---

/// Empty for NaN.
std::string finite(double value) {
  return std::isfinite(value) ? csv_number(value) : std::string();
}

void append(const std::optional<Estimate>& estimate, CsvRow& row) {
  const bool has_interval = estimate && estimate->interval;
  row.push_back(estimate ? csv_number(estimate->value) : "");
  row.push_back(has_interval ? csv_number(estimate->interval->low) : "");
  row.push_back(has_interval ? csv_number(estimate->interval->high) : "");
}

void add_points(const GazeMeasurement& measurement, std::vector<CsvRow>& rows) {
  for (const Repetition& repetition : measurement.repetitions) {
    for (std::size_t i = 0; i < measurement.configurations.size(); ++i) {
      const RenderLog& log = repetition[i];
      for (const Checkpoint& checkpoint : log.checkpoints) {
        for (std::size_t region = 0; region < measurement.regions.size(); ++region) {
          const Score& score = checkpoint.scores[region];
          const RegionError& error = score.error;
          rows.push_back({measurement.scene, measurement.gaze, measurement.configurations[i],
                          std::to_string(log.seed), measurement.regions[region],
                          std::to_string(checkpoint.samples), csv_number(checkpoint.seconds),
                          finite(error.samples_per_pixel), finite(error.mse),
                          finite(std::sqrt(error.mse)), finite(error.relative_mse),
                          finite(score.flip.value_or(std::nan(""))), std::to_string(error.pixels),
                          std::to_string(error.empty), finite(error.empty_share),
                          std::to_string(error.non_finite), std::to_string(log.dropped)});
        }
      }
    }
  }
}

std::string points_csv(const std::vector<GazeMeasurement>& measurements) {
  std::vector<CsvRow> rows = {{"scene", "gaze_deg", "configuration", "seed", "region", "samples",
                               "seconds", "samples_per_pixel", "mse", "rmse", "relative_mse",
                               "flip", "pixels", "empty_pixels", "empty_share", "non_finite_pixels",
                               "non_finite_samples_of_render"}};
  for (const GazeMeasurement& measurement : measurements) {
    add_points(measurement, rows);
  }
  return format_csv(rows);
}

std::string speed_ups_csv(const ConvergenceTables& tables) {
  std::vector<CsvRow> rows = {{"scene", "gaze_deg", "configuration", "region", "metric", "level",
                               "samples", "samples_low", "samples_high", "time", "time_low",
                               "time_high", "predicted"}};
  for (const SpeedUp& speed_up : tables.speed_ups) {
    CsvRow row = {speed_up.scene,
                  speed_up.gaze,
                  speed_up.configuration,
                  speed_up.region,
                  std::string(name_of(speed_up.metric)),
                  std::string(name_of(speed_up.level))};
    append(speed_up.samples, row);
    append(speed_up.time, row);
    row.push_back(csv_number(speed_up.predicted));
    rows.push_back(std::move(row));
  }
  return format_csv(rows);
}

std::string overall_csv(const ConvergenceTables& tables) {
  std::vector<CsvRow> rows = {{"configuration", "region", "metric", "level", "samples",
                               "samples_low", "samples_high", "time", "time_low", "time_high",
                               "predicted"}};
  for (const OverallSpeedUp& overall : tables.overall) {
    CsvRow row = {overall.configuration, overall.region, std::string(name_of(overall.metric)),
                  std::string(name_of(overall.level))};
    append(overall.samples, row);
    append(overall.time, row);
    row.push_back(csv_number(overall.predicted));
    rows.push_back(std::move(row));
  }
  return format_csv(rows);
}

std::string costs_csv(const ConvergenceTables& tables) {
  std::vector<CsvRow> rows = {{"scene", "gaze_deg", "configuration", "ns_per_path",
                               "ns_per_path_low", "ns_per_path_high", "ratio", "ratio_low",
                               "ratio_high"}};
  for (const PathCost& cost : tables.costs) {
    CsvRow row = {cost.scene, cost.gaze, cost.configuration};
    append(cost.ns_per_path, row);
    append(cost.ratio, row);
    rows.push_back(std::move(row));
  }
  return format_csv(rows);
}

std::string convergence_rows_csv(const ConvergenceTables& tables) {
  std::vector<CsvRow> rows = {{"scene", "gaze_deg", "configuration", "region", "slope_in_samples",
                               "slope_in_samples_low", "slope_in_samples_high", "slope_in_time",
                               "slope_in_time_low", "slope_in_time_high", "efficiency",
                               "efficiency_low", "efficiency_high", "efficiency_ratio",
                               "efficiency_ratio_low", "efficiency_ratio_high"}};
  for (const Convergence& convergence : tables.convergence) {
    CsvRow row = {convergence.scene, convergence.gaze, convergence.configuration,
                  convergence.region};
    append(convergence.slope_in_samples, row);
    append(convergence.slope_in_time, row);
    append(convergence.efficiency, row);
    append(convergence.efficiency_ratio, row);
    rows.push_back(std::move(row));
  }
  return format_csv(rows);
}

// --- JSON ---

json number(const std::optional<double>& value) { return value ? json(*value) : json(nullptr); }

json estimate(const std::optional<Estimate>& value) {
  if (!value) {
    return nullptr;
  }
  json object = {{"value", value->value}, {"low", nullptr}, {"high", nullptr}};
  if (value->interval) {
    object["low"] = value->interval->low;
    object["high"] = value->interval->high;
  }
  return object;
}

json crops_json(const ConvergencePlan& plan) {
  json order = json::array();
  for (const Configuration& configuration : plan.configurations) {
    order.push_back(configuration.name);
  }
  order.push_back("reference");
  return {{"seconds", plan.crop_seconds}, {"fov_deg", plan.crop_fov_deg}, {"left_to_right", order}};
}

json plan_json(const ConvergencePlan& plan) {
  return {{"width", plan.size.x},
          {"height", plan.size.y},
          {"samples_per_pixel", plan.samples_per_pixel},
          {"fov_deg", plan.fov_deg},
          {"view_size", plan.view_size},
          {"max_depth", plan.max_depth},
          {"relative_mse_epsilon", relative_mse_epsilon},
          {"reference_samples_per_pixel_of_each_half", plan.reference_samples_per_pixel},
          {"reference_foveated_per_pixel_of_each_half", plan.reference_foveated_per_pixel}};
}

json measured_json(const std::vector<GazeMeasurement>& measurements) {
  json list = json::array();
  for (const GazeMeasurement& measurement : measurements) {
    std::uint64_t dropped = 0;
    for (const Repetition& repetition : measurement.repetitions) {
      for (const RenderLog& log : repetition) {
        dropped += log.dropped;
      }
    }
    list.push_back({{"scene", measurement.scene},
                    {"scene_sha256", measurement.scene_sha256},
                    {"gaze", measurement.gaze},
                    {"repetitions", measurement.repetitions.size()},
                    {"non_finite_samples", dropped}});
  }
  return list;
}

/// An array of describe(row) for each of the rows.
template <typename Row, typename Describe>
json list_of(const std::vector<Row>& rows, const Describe& describe) {
  json list = json::array();
  for (const Row& row : rows) {
    list.push_back(describe(row));
  }
  return list;
}

json speed_ups_json(const ConvergenceTables& tables) {
  return list_of(tables.speed_ups, [](const SpeedUp& row) -> json {
    return {{"scene", row.scene},
            {"gaze", row.gaze},
            {"configuration", row.configuration},
            {"region", row.region},
            {"metric", name_of(row.metric)},
            {"level", name_of(row.level)},
            {"samples", estimate(row.samples)},
            {"time", estimate(row.time)},
            {"predicted", number(row.predicted)}};
  });
}

json overall_json(const ConvergenceTables& tables) {
  return list_of(tables.overall, [](const OverallSpeedUp& row) -> json {
    return {{"configuration", row.configuration}, {"region", row.region},
            {"metric", name_of(row.metric)},      {"level", name_of(row.level)},
            {"samples", estimate(row.samples)},   {"time", estimate(row.time)},
            {"predicted", number(row.predicted)}};
  });
}

json costs_json(const ConvergenceTables& tables) {
  return list_of(tables.costs, [](const PathCost& row) -> json {
    return {{"scene", row.scene},
            {"gaze", row.gaze},
            {"configuration", row.configuration},
            {"ns_per_path", estimate(row.ns_per_path)},
            {"ratio", estimate(row.ratio)}};
  });
}

json convergence_rows_json(const ConvergenceTables& tables) {
  return list_of(tables.convergence, [](const Convergence& row) -> json {
    return {{"scene", row.scene},
            {"gaze", row.gaze},
            {"configuration", row.configuration},
            {"region", row.region},
            {"slope_in_samples", estimate(row.slope_in_samples)},
            {"slope_in_time", estimate(row.slope_in_time)},
            {"efficiency", estimate(row.efficiency)},
            {"efficiency_ratio", estimate(row.efficiency_ratio)}};
  });
}

// --- Words ---

std::string in_words(const std::optional<Estimate>& estimate) {
  if (!estimate) {
    return "-";
  }
  if (!estimate->interval) {
    return fmt::format("{:.2f}", estimate->value);
  }
  return fmt::format("{:.2f} ({:.2f} to {:.2f})", estimate->value, estimate->interval->low,
                     estimate->interval->high);
}

std::string in_words(const std::optional<double>& value) {
  return value ? fmt::format("{:.2f}", *value) : "";
}

}  // namespace

std::vector<TextFile> convergence_csv(const std::vector<GazeMeasurement>& measurements,
                                      const ConvergenceTables& tables) {
  return {{"points.csv", points_csv(measurements)},
          {"speed_ups.csv", speed_ups_csv(tables)},
          {"costs.csv", costs_csv(tables)},
          {"convergence.csv", convergence_rows_csv(tables)},
          {"overall.csv", overall_csv(tables)}};
}

json plan_facts(const ConvergencePlan& plan) {
  return {{"baseline", plan.configurations.front().name},
          {"plan", plan_json(plan)},
          {"crops", crops_json(plan)}};
}

std::string convergence_json(json facts, const std::vector<GazeMeasurement>& measurements,
                             const ConvergenceTables& tables) {
  facts.update(json{{"measured", measured_json(measurements)},
                    {"overall", overall_json(tables)},
                    {"speed_ups", speed_ups_json(tables)},
                    {"costs", costs_json(tables)},
                    {"convergence", convergence_rows_json(tables)}});
  return facts.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

std::string convergence_summary(const ConvergenceTables& tables) {
  constexpr const char* columns = "{:<24} {:<9} {:>9}  {:<25} {:<25} {:<25}\n";
  std::string text = fmt::format(columns, "speed-up to equal MSE", "within", "predicted",
                                 "in samples", "at a quarter of them", "in time");
  for (const OverallSpeedUp& row : tables.overall) {
    if (row.metric == Metric::mse && row.level == Level::all) {
      const auto quarter =
          std::find_if(tables.overall.begin(), tables.overall.end(), [&](const auto& other) {
            return other.configuration == row.configuration && other.region == row.region &&
                   other.metric == row.metric && other.level == Level::quarter;
          });
      text += fmt::format(columns, row.configuration, row.region, in_words(row.predicted),
                          in_words(row.samples), in_words(quarter->samples), in_words(row.time));
    }
  }
  text += "A path's cost, and its ratio to the baseline's:\n";
  for (const PathCost& cost : tables.costs) {
    text += fmt::format("{:<12} {:>10}  {:<28} {:>8.0f} ns  {}\n", cost.scene, cost.gaze,
                        cost.configuration, cost.ns_per_path ? cost.ns_per_path->value : 0.0,
                        in_words(cost.ratio));
  }
  return text;
}

}  // namespace foveola::analysis
