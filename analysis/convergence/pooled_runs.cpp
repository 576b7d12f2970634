#include "analysis/convergence/pooled_runs.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "renderer/base/text/csv.h"

namespace fs = std::filesystem;

namespace foveola::analysis {
namespace {

using json = nlohmann::ordered_json;

json facts_of(const json& run) {
  json facts = json::object();
  for (const auto& [key, value] : run.items()) {
    if (!value.is_array() && key != "date" && key != "crops") {
      facts[key] = value;
    }
  }
  return facts;
}

template <typename Number>
Number number_in(const std::string& field) {
  Number number{};
  const char* const end = field.data() + field.size();
  const auto [stop, failure] = std::from_chars(field.data(), end, number);
  if (failure != std::errc() || stop != end) {
    throw std::invalid_argument("not a number");
  }
  return number;
}

double number_or_nan(const std::string& field) {
  return field.empty() ? std::numeric_limits<double>::quiet_NaN() : number_in<double>(field);
}

/// The names are those of a list, filled by the first of several equal sequences.
void expect_name(const std::string& name, std::size_t place, bool is_first,
                 std::vector<std::string>& names) {
  if (is_first && place == names.size()) {
    names.push_back(name);
  }
  if (names.at(place) != name) {
    throw std::invalid_argument("in another order");
  }
}

/// Adds a row of points.csv. Rows are in the order of scenes and gazes, seeds, configurations,
/// checkpoints and regions.
void add_row(const CsvRow& row, std::vector<GazeMeasurement>& measurements) {
  if (measurements.empty() || measurements.back().scene != row.at(0) ||
      measurements.back().gaze != row.at(1)) {
    GazeMeasurement& added = measurements.emplace_back();
    added.scene = row.at(0);
    added.gaze = row.at(1);
  }
  GazeMeasurement& measurement = measurements.back();
  const auto seed = number_in<std::uint32_t>(row.at(3));
  if (measurement.repetitions.empty() || measurement.repetitions.back().front().seed != seed) {
    measurement.repetitions.emplace_back();
  }
  Repetition& logs = measurement.repetitions.back();
  const bool is_first = measurement.repetitions.size() == 1;
  if (logs.empty() || measurement.configurations.at(logs.size() - 1) != row.at(2)) {
    logs.push_back({.seed = seed, .dropped = number_in<std::uint64_t>(row.at(16))});
    expect_name(row.at(2), logs.size() - 1, is_first, measurement.configurations);
  }
  std::vector<Checkpoint>& checkpoints = logs.back().checkpoints;
  const auto samples = number_in<std::uint64_t>(row.at(5));
  if (checkpoints.empty() || checkpoints.back().samples != samples) {
    checkpoints.push_back({.samples = samples, .seconds = number_in<double>(row.at(6))});
  }
  std::vector<Score>& scores = checkpoints.back().scores;
  expect_name(row.at(4), scores.size(), is_first && logs.size() == 1 && checkpoints.size() == 1,
              measurement.regions);
  Score score;
  score.error.samples_per_pixel = number_or_nan(row.at(7));
  score.error.mse = number_or_nan(row.at(8));
  score.error.relative_mse = number_or_nan(row.at(10));
  if (!row.at(11).empty()) {
    score.flip = number_in<double>(row.at(11));
  }
  score.error.pixels = number_in<std::size_t>(row.at(12));
  score.error.empty = number_in<std::size_t>(row.at(13));
  score.error.empty_share = number_or_nan(row.at(14));
  score.error.non_finite = number_in<std::size_t>(row.at(15));
  scores.push_back(score);
}

void require_whole(const GazeMeasurement& measurement) {
  const std::size_t checkpoints = measurement.repetitions.front().front().checkpoints.size();
  for (const Repetition& repetition : measurement.repetitions) {
    bool is_whole = repetition.size() == measurement.configurations.size();
    for (const RenderLog& log : repetition) {
      is_whole = is_whole && log.checkpoints.size() == checkpoints &&
                 std::ranges::all_of(log.checkpoints, [&](const Checkpoint& checkpoint) {
                   return checkpoint.scores.size() == measurement.regions.size();
                 });
    }
    if (!is_whole) {
      throw std::invalid_argument("rows are missing");
    }
  }
}

bool is_of(const json& row, const GazeMeasurement& measurement) {
  return row.at("scene") == measurement.scene && row.at("gaze") == measurement.gaze;
}

void add_facts(const json& run, GazeMeasurement& measurement) {
  for (const json& row : run.at("measured")) {
    if (is_of(row, measurement)) {
      measurement.scene_sha256 = row.at("scene_sha256").get<std::string>();
    }
  }
  const auto place = [](const std::vector<std::string>& names, const json& name) {
    return static_cast<std::size_t>(std::ranges::find(names, name.get<std::string>()) -
                                    names.begin());
  };
  measurement.predicted.assign(measurement.configurations.size(),
                               std::vector<std::optional<double>>(measurement.regions.size()));
  for (const json& row : run.at("speed_ups")) {
    if (is_of(row, measurement) && row.at("predicted").is_number()) {
      measurement.predicted.at(place(measurement.configurations, row.at("configuration")))
          .at(place(measurement.regions, row.at("region"))) = row.at("predicted").get<double>();
    }
  }
}

PooledRuns read_run(const fs::path& folder) {
  const std::string points = read_file(folder / "points.csv");
  const std::string text = read_file(folder / "convergence.json");
  PooledRuns read;
  try {
    const json run = json::parse(text);
    read.facts = facts_of(run);
    const std::vector<CsvRow> rows = parse_csv(points, (folder / "points.csv").string());
    for (std::size_t i = 1; i < rows.size(); ++i) {
      add_row(rows[i], read.measurements);
    }
    for (GazeMeasurement& measurement : read.measurements) {
      require_whole(measurement);
      add_facts(run, measurement);
    }
  } catch (const std::exception&) {
    throw Error(folder.string(), "does not contain a complete run of bench convergence",
                "name folders written by this version");
  }
  return read;
}

void require_same_facts(const fs::path& folder, const json& facts, const json& first) {
  const json difference = json::diff(first, facts);
  if (!difference.empty()) {
    const auto path = difference.front().at("path").get<std::string>();
    const json::json_pointer place(path);
    throw Error(folder.string(),
                fmt::format("cannot be pooled with the first run: {} is {}, not {}", path.substr(1),
                            facts.value(place, json()).dump(), first.value(place, json()).dump()),
                "pool runs that differ only in scenes or seeds");
  }
}

void add_measurement(const fs::path& folder, GazeMeasurement measurement,
                     std::vector<GazeMeasurement>& pooled) {
  const std::string name = fmt::format("{} at {}", measurement.scene, measurement.gaze);
  if (!pooled.empty() && (pooled.front().configurations != measurement.configurations ||
                          pooled.front().regions != measurement.regions)) {
    throw Error(folder.string(), "has other configurations or regions than the first run",
                "pool runs that differ only in scenes or seeds");
  }
  const auto same = std::ranges::find_if(pooled, [&](const GazeMeasurement& other) {
    return other.scene == measurement.scene && other.gaze == measurement.gaze;
  });
  if (same == pooled.end()) {
    pooled.push_back(std::move(measurement));
    return;
  }
  if (same->scene_sha256 != measurement.scene_sha256) {
    throw Error(folder.string(), fmt::format("has another scene named {}", name),
                "measure all runs with the same files");
  }
  for (Repetition& repetition : measurement.repetitions) {
    const std::uint32_t seed = repetition.front().seed;
    if (std::ranges::any_of(same->repetitions,
                            [&](const Repetition& other) { return other.front().seed == seed; })) {
      throw Error(folder.string(),
                  fmt::format("has renders of {} with seed {}, like an earlier run", name, seed),
                  "measure each run with its own --seed");
    }
    same->repetitions.push_back(std::move(repetition));
  }
}

}  // namespace

PooledRuns pool_runs(const std::vector<fs::path>& folders) {
  PooledRuns pooled;
  for (const fs::path& folder : folders) {
    PooledRuns run = read_run(folder);
    if (pooled.facts.is_null()) {
      pooled.facts = run.facts;
    }
    require_same_facts(folder, run.facts, pooled.facts);
    for (GazeMeasurement& measurement : run.measurements) {
      add_measurement(folder, std::move(measurement), pooled.measurements);
    }
  }
  return pooled;
}

}  // namespace foveola::analysis
