#include "analysis/convergence/convergence_files.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analysis/tables/table.h"
#include "analysis/tables/table_formats.h"
#include "renderer/base/transformed.h"
#include "renderer/measure/region_error.h"

namespace foveola::analysis {
namespace {

using json = nlohmann::ordered_json;

template <typename Item>
void add_estimate(const std::string& name, const std::string& description,
                  std::optional<Estimate> Item::* estimate, ColumnsOf<Item>& columns) {
  columns.push_back({name, "", description, path(estimate, &Estimate::value)});
  columns.push_back({name + "_low", "", "Lower end of its 95 % interval over repetitions",
                     path(estimate, &Estimate::interval, &Interval::low)});
  columns.push_back(
      {name + "_high", "", "Its upper end", path(estimate, &Estimate::interval, &Interval::high)});
}

template <typename Item>
ColumnsOf<Item> columns_of_gaze() {
  return {{"scene", "", "Name of the scene", &Item::scene},
          {"gaze_deg", "deg", "Azimuth and elevation of the gaze", &Item::gaze},
          {"configuration", "", "Name of the configuration", &Item::configuration}};
}

ColumnsOf<SpeedUp> speed_up_columns() {
  ColumnsOf<SpeedUp> columns = columns_of_gaze<SpeedUp>();
  columns.push_back({"region", "", "Region of the error", &SpeedUp::region});
  columns.push_back({"metric", "", "Metric of the error", &SpeedUp::metric});
  columns.push_back(
      {"level", "", "Reference error: that of all samples, or of a quarter", &SpeedUp::level});
  add_estimate("samples", "The baseline's samples over this configuration's, at equal error",
               &SpeedUp::samples_ratio, columns);
  add_estimate("time", "The baseline's time over this configuration's, at equal error",
               &SpeedUp::time_ratio, columns);
  columns.push_back({"predicted", "", "Speed-up in mean squared error predicted by density alone",
                     &SpeedUp::predicted});
  return columns;
}

Table speed_ups_table(const ConvergenceTables& tables) {
  return tabulate("speed_ups", "scene, gaze, configuration, region, metric and level",
                  speed_up_columns(), tables.speed_ups);
}

Table overall_table(const ConvergenceTables& tables) {
  ColumnsOf<SpeedUp> columns = speed_up_columns();
  std::erase_if(columns, [](const ColumnOf<SpeedUp>& column) {
    return column.column.name == "scene" || column.column.name == "gaze_deg";
  });
  return tabulate("overall", "configuration, region, metric and level", columns, tables.overall);
}

Table costs_table(const ConvergenceTables& tables) {
  ColumnsOf<PathCost> columns = columns_of_gaze<PathCost>();
  add_estimate("ns_per_path", "Nanoseconds per path, with all threads", &PathCost::ns_per_path,
               columns);
  add_estimate("ratio", "ns_per_path over the baseline's", &PathCost::ratio, columns);
  return tabulate("costs", "scene, gaze and configuration", columns, tables.costs);
}

Table convergence_table(const ConvergenceTables& tables) {
  using C = Convergence;
  ColumnsOf<C> columns = columns_of_gaze<C>();
  columns.push_back({"region", "", "Region of the error", &C::region});
  add_estimate("slope_in_samples", "Slope of log RMSE over log samples", &C::slope_in_samples,
               columns);
  add_estimate("slope_in_time", "Slope of log RMSE over log seconds", &C::slope_in_time, columns);
  add_estimate("efficiency", "1 / (mean squared error x seconds) at the render's end",
               &C::efficiency, columns);
  add_estimate("efficiency_ratio", "efficiency over the baseline's", &C::efficiency_ratio, columns);
  return tabulate("convergence", "scene, gaze, configuration and region", columns,
                  tables.convergence);
}

/// One region's error at a checkpoint of a render.
struct MeasuredPoint {
  std::string scene;
  std::string gaze;
  std::string configuration;
  std::string region;
  const RenderLog* log;
  const Checkpoint* checkpoint;
  Score score;
};

std::vector<MeasuredPoint> points_of(const std::vector<GazeMeasurement>& measurements) {
  std::vector<MeasuredPoint> points;
  for (const GazeMeasurement& measurement : measurements) {
    for (const Repetition& repetition : measurement.repetitions) {
      for (std::size_t i = 0; i < measurement.configurations.size(); ++i) {
        for (const Checkpoint& checkpoint : repetition[i].checkpoints) {
          for (std::size_t region = 0; region < measurement.regions.size(); ++region) {
            points.push_back({measurement.scene, measurement.gaze, measurement.configurations[i],
                              measurement.regions[region], &repetition[i], &checkpoint,
                              checkpoint.scores[region]});
          }
        }
      }
    }
  }
  return points;
}

Table points_table(const std::vector<GazeMeasurement>& measurements) {
  using P = MeasuredPoint;
  using E = RegionError;
  const auto finite = [](double value) {
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
  };
  const auto error = path(&P::score, &Score::error);
  ColumnsOf<P> columns = columns_of_gaze<P>();
  const ColumnsOf<P> others = {
      {"seed", "", "Seed of the render", path(&P::log, &RenderLog::seed)},
      {"region", "", "Region of the error", &P::region},
      {"samples", "", "Number of samples up to the checkpoint",
       path(&P::checkpoint, &Checkpoint::samples)},
      {"seconds", "s", "Time up to the checkpoint", path(&P::checkpoint, &Checkpoint::seconds)},
      {"samples_per_pixel", "", "Mean number of samples per pixel of the region",
       path(error, &E::samples_per_pixel, finite)},
      {"mse", "", "Mean squared error", path(error, &E::mse, finite)},
      {"rmse", "", "Root of the mean squared error",
       path(
           error, &E::mse, [](double mse) { return std::sqrt(mse); }, finite)},
      {"relative_mse", "", "Relative mean squared error", path(error, &E::relative_mse, finite)},
      {"flip", "", "FLIP", path(&P::score, &Score::flip, finite)},
      {"pixels", "", "Number of pixels of the region", path(error, &E::pixels)},
      {"empty_pixels", "", "Number of pixels without a sample", path(error, &E::empty)},
      {"empty_share", "", "Share of the region without a sample",
       path(error, &E::empty_share, finite)},
      {"non_finite_pixels", "", "Number of pixels that are not finite",
       path(error, &E::non_finite)},
      {"non_finite_samples_of_render", "", "Number of samples of the render that were left out",
       path(&P::log, &RenderLog::dropped)}};
  columns.insert(columns.end(), others.begin(), others.end());
  return tabulate("points", "region at a checkpoint of a render", columns, points_of(measurements));
}

/// Returns the rows with each estimate, NAME, NAME_low and NAME_high, as an object, or null.
json rows_json(const Table& table) {
  json rows = json_of(table);
  for (json& row : rows) {
    json grouped = json::object();
    for (const auto& [name, value] : row.items()) {
      if (name.ends_with("_low") || name.ends_with("_high")) {
        continue;
      }
      grouped[name == "gaze_deg" ? "gaze" : name] =
          !row.contains(name + "_low") || value.is_null()
              ? value
              : json{{"value", value}, {"low", row[name + "_low"]}, {"high", row[name + "_high"]}};
    }
    row = std::move(grouped);
  }
  return rows;
}

json crops_json(const ConvergencePlan& plan) {
  json order(transformed(plan.configurations, &Configuration::name));
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
  std::vector<TextFile> files;
  for (Table table :
       std::array{points_table(measurements), speed_ups_table(tables), costs_table(tables),
                  convergence_table(tables), overall_table(tables)}) {
    table.texts = CsvTexts::as_typed;
    files.push_back({table.id + ".csv", csv_of(table)});
  }
  return files;
}

json plan_facts(const ConvergencePlan& plan) {
  return {{"baseline", plan.configurations.front().name},
          {"plan", plan_json(plan)},
          {"crops", crops_json(plan)}};
}

std::string convergence_json(json facts, const std::vector<GazeMeasurement>& measurements,
                             const ConvergenceTables& tables) {
  facts.update(json{{"measured", measured_json(measurements)},
                    {"overall", rows_json(overall_table(tables))},
                    {"speed_ups", rows_json(speed_ups_table(tables))},
                    {"costs", rows_json(costs_table(tables))},
                    {"convergence", rows_json(convergence_table(tables))}});
  return facts.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

std::string convergence_summary(const ConvergenceTables& tables) {
  constexpr const char* columns = "{:<24} {:<9} {:>9}  {:<25} {:<25} {:<25}\n";
  std::string text = fmt::format(columns, "speed-up to equal MSE", "within", "predicted",
                                 "in samples", "at a quarter of them", "in time");
  for (const SpeedUp& row : tables.overall) {
    if (row.metric == Metric::mse && row.level == Level::all) {
      const auto quarter = std::ranges::find_if(tables.overall, [&](const auto& other) {
        return other.configuration == row.configuration && other.region == row.region &&
               other.metric == row.metric && other.level == Level::quarter;
      });
      text += fmt::format(columns, row.configuration, row.region, in_words(row.predicted),
                          in_words(row.samples_ratio), in_words(quarter->samples_ratio),
                          in_words(row.time_ratio));
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
