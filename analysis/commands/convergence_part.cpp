#include "analysis/commands/convergence_part.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/build_info.h"
#include "renderer/base/digest.h"
#include "study/record/shown_scene.h"

namespace foveola::analysis {
namespace {

// The largest numbers that a part may have, beyond those of the options.
constexpr std::uint64_t most_pixels = 1 << 16;  ///< along a side
constexpr std::uint64_t most_each = 1 << 16;    ///< samples per pixel, repetitions, gazes, cores
constexpr std::uint64_t most_samples = std::uint64_t{1} << 53;

// --- Numbers that may not exist, which JSON has no number for ---

double number_in(const nlohmann::json& json) {
  return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

int count_in(const nlohmann::json& json, std::uint64_t most) {
  const std::uint64_t count = whole_number(json, most);
  if (count == 0) {
    throw std::out_of_range("none");
  }
  return static_cast<int>(count);
}

// --- Settings ---

nlohmann::json settings_json(const ConvergenceRun& run) {
  const ConvergencePlan& plan = run.plan;
  nlohmann::json json = {{"width", plan.size.x},
                         {"height", plan.size.y},
                         {"samples_per_pixel", plan.samples_per_pixel},
                         {"repetitions", plan.most_repetitions},
                         {"gazes", run.gazes},
                         {"fov_deg", plan.fov_deg},
                         {"view_size", plan.view_size},
                         {"max_depth", plan.max_depth},
                         {"reference_samples_per_pixel", plan.reference_samples_per_pixel},
                         {"reference_foveated_per_pixel", plan.reference_foveated_per_pixel},
                         {"scenes", run.scenes.size()},
                         {"configurations", nlohmann::json::array()},
                         {"methods", nlohmann::json::array()}};
  for (const Configuration& configuration : plan.configurations) {
    json["configurations"].push_back(configuration.name);
    json["methods"].push_back(configuration.method);
  }
  for (std::size_t i = 0; i < run.scenes.size(); ++i) {
    const SceneSource& source = run.scenes[i];
    const std::string scene = fmt::format("scene {}", i + 1);
    json[scene] = source.name;
    json["sha256 of " + scene] = sha256_of_file(source.file);
    json[scene + " is shown"] = study::shown_as(source);
  }
  return json;
}

ConvergencePlan plan_in(const nlohmann::json& json) {
  ConvergencePlan plan;
  plan.size = {count_in(json.at("width"), most_pixels), count_in(json.at("height"), most_pixels)};
  plan.samples_per_pixel = count_in(json.at("samples_per_pixel"), most_each);
  plan.most_repetitions = count_in(json.at("repetitions"), most_each);
  plan.least_repetitions = plan.most_repetitions;
  plan.fov_deg = json.at("fov_deg").get<double>();
  plan.view_size = count_in(json.at("view_size"), most_pixels);
  plan.max_depth = count_in(json.at("max_depth"), most_each);
  plan.reference_samples_per_pixel = count_in(json.at("reference_samples_per_pixel"), most_each);
  plan.reference_foveated_per_pixel = count_in(json.at("reference_foveated_per_pixel"), most_each);
  const auto names = json.at("configurations").get<std::vector<std::string>>();
  const auto methods = json.at("methods").get<std::vector<std::string>>();
  if (names.empty() || names.size() != methods.size()) {
    throw std::invalid_argument("no configurations");
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    plan.configurations.push_back({.name = names[i], .method = methods[i]});
  }
  return plan;
}

// --- Measurements ---

/// Without FLIP the row is shorter.
nlohmann::json json_of(const Score& score) {
  const RegionError& error = score.error;
  nlohmann::json row = {error.mse,         error.relative_mse, error.samples_per_pixel,
                        error.empty_share, error.pixels,       error.empty,
                        error.non_finite};
  if (score.flip) {
    row.push_back(*score.flip);
  }
  return row;
}

Score score_in(const nlohmann::json& row) {
  constexpr std::size_t with_flip = 8;
  std::size_t next = 0;
  const auto number = [&] { return number_in(row.at(next++)); };
  const auto pixels = [&] { return whole_number(row.at(next++), most_pixels * most_pixels); };
  Score score;
  score.error.mse = number();
  score.error.relative_mse = number();
  score.error.samples_per_pixel = number();
  score.error.empty_share = number();
  score.error.pixels = pixels();
  score.error.empty = pixels();
  score.error.non_finite = pixels();
  if (row.size() == with_flip) {
    score.flip = number();
  }
  return score;
}

nlohmann::json json_of(const RenderLog& log) {
  nlohmann::json checkpoints = nlohmann::json::array();
  for (const Checkpoint& checkpoint : log.checkpoints) {
    nlohmann::json scores = nlohmann::json::array();
    for (const Score& score : checkpoint.scores) {
      scores.push_back(json_of(score));
    }
    checkpoints.push_back({{"samples", checkpoint.samples},
                           {"seconds", checkpoint.seconds},
                           {"scores", std::move(scores)}});
  }
  return {{"dropped", log.dropped}, {"checkpoints", std::move(checkpoints)}};
}

/// Throws unless json is an array of so many elements, which are read by `read`.
template <typename Read>
auto list_in(const nlohmann::json& json, std::size_t size, const Read& read) {
  if (!json.is_array() || json.size() != size) {
    throw std::invalid_argument("of another length");
  }
  std::vector<decltype(read(json))> list;
  list.reserve(size);
  for (const nlohmann::json& element : json) {
    list.push_back(read(element));
  }
  return list;
}

RenderLog log_in(const nlohmann::json& json, const std::vector<std::uint64_t>& counts,
                 std::size_t regions) {
  RenderLog log{.dropped = whole_number(json.at("dropped"), most_samples), .checkpoints = {}};
  log.checkpoints =
      list_in(json.at("checkpoints"), counts.size(), [&](const nlohmann::json& checkpoint) {
        return Checkpoint{.samples = whole_number(checkpoint.at("samples"), most_samples),
                          .seconds = checkpoint.at("seconds").get<double>(),
                          .scores = list_in(checkpoint.at("scores"), regions, score_in)};
      });
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (log.checkpoints[i].samples != counts[i]) {
      throw std::invalid_argument("at other samples");
    }
  }
  return log;
}

nlohmann::json json_of(const MeasuredPart& part) {
  const GazeMeasurement& measurement = part.measurement;
  nlohmann::json predicted = nlohmann::json::array();
  for (const auto& row : measurement.predicted) {
    predicted.push_back(nlohmann::json::array());
    for (const std::optional<double>& speed_up : row) {
      predicted.back().push_back(speed_up ? nlohmann::json(*speed_up) : nlohmann::json());
    }
  }
  nlohmann::json repetitions = nlohmann::json::array();
  for (const Repetition& repetition : measurement.repetitions) {
    repetitions.push_back(nlohmann::json::array());
    for (const RenderLog& log : repetition) {
      repetitions.back().push_back(json_of(log));
    }
  }
  return {{"scene", measurement.scene},        {"scene_key", part.scene_key},
          {"gaze", measurement.gaze},          {"regions", measurement.regions},
          {"predicted", std::move(predicted)}, {"repetitions", std::move(repetitions)}};
}

MeasuredPart measured_in(const nlohmann::json& json, const ConvergencePlan& plan,
                         const ItemRange& repetitions) {
  GazeMeasurement measurement;
  measurement.scene = json.at("scene").get<std::string>();
  measurement.gaze = json.at("gaze").get<std::string>();
  measurement.regions = json.at("regions").get<std::vector<std::string>>();
  for (const Configuration& configuration : plan.configurations) {
    measurement.configurations.push_back(configuration.name);
  }
  const std::size_t configurations = plan.configurations.size();
  const std::size_t regions = measurement.regions.size();
  const auto speed_up = [](const nlohmann::json& value) {
    return value.is_null() ? std::nullopt : std::optional(value.get<double>());
  };
  measurement.predicted =
      list_in(json.at("predicted"), configurations,
              [&](const nlohmann::json& row) { return list_in(row, regions, speed_up); });
  const std::vector<std::uint64_t> counts = checkpoints(plan);
  const auto log = [&](const nlohmann::json& one) { return log_in(one, counts, regions); };
  measurement.repetitions = list_in(
      json.at("repetitions"), static_cast<std::size_t>(repetitions.size()),
      [&](const nlohmann::json& repetition) { return list_in(repetition, configurations, log); });
  return {.scene_key = json.at("scene_key").get<std::string>(),
          .measurement = std::move(measurement)};
}

// --- Machines ---

nlohmann::json this_machine_json(int threads) {
  const MachineInfo machine = machine_info();
  return {{"processor", machine.processor},
          {"cores", machine.cores},
          {"threads", Workers(threads).threads()}};
}

MeasuringMachine machine_in(const BenchPart& part) {
  const nlohmann::json& json = part.results.at("machine");
  return {.shard = text_of(part.shard),
          .processor = json.at("processor").get<std::string>(),
          .cores = static_cast<int>(whole_number(json.at("cores"), most_each)),
          .threads = static_cast<int>(whole_number(json.at("threads"), most_each)),
          .repetitions = {}};
}

// --- Merging ---

bool is_same_gaze(const MeasuredPart& a, const MeasuredPart& b) {
  return a.scene_key == b.scene_key && a.measurement.scene == b.measurement.scene &&
         a.measurement.gaze == b.measurement.gaze &&
         a.measurement.regions == b.measurement.regions &&
         a.measurement.predicted == b.measurement.predicted;
}

/// Takes the parts in their order.
class Merge {
 public:
  explicit Merge(const BenchPart& first) {
    read_part(first, [&](const BenchPart& part) {
      merged_.plan = plan_in(part.settings);
      scenes_ = whole_number(part.settings.at("scenes"), most_each);
      gazes_ = count_in(part.settings.at("gazes"), most_each);
      return true;
    });
  }

  void add(const BenchPart& part) {
    MeasuringMachine machine = read_part(part, machine_in);
    for (const auto& [gaze, measured] : gazes_of(part)) {
      machine.repetitions.push_back(
          fmt::format("{} to {} of {} at {}", gaze.repetitions.begin, gaze.repetitions.end - 1,
                      measured.measurement.scene, measured.measurement.gaze));
      if (gaze.repetitions.begin == 0) {
        gathered_.push_back(measured);
        continue;
      }
      MeasuredPart& last = gathered_.back();
      if (!is_same_gaze(last, measured)) {
        throw Error(part.file.string(),
                    fmt::format("has measured another scene as {} than the part before it",
                                measured.measurement.scene),
                    "measure both with the same files");
      }
      const std::vector<Repetition>& repetitions = measured.measurement.repetitions;
      last.measurement.repetitions.insert(last.measurement.repetitions.end(), repetitions.begin(),
                                          repetitions.end());
    }
    merged_.machines.push_back(std::move(machine));
  }

  MergedConvergence result() {
    for (MeasuredPart& gathered : gathered_) {
      merged_.measurements.push_back(std::move(gathered.measurement));
    }
    return std::move(merged_);
  }

 private:
  std::vector<std::pair<GazePart, MeasuredPart>> gazes_of(const BenchPart& part) const {
    const std::vector<GazePart> planned =
        gaze_parts(part.shard, scenes_, gazes_, merged_.plan.most_repetitions);
    return read_part(part, [&](const BenchPart& read) {
      auto next = planned.begin();
      return list_in(read.results.at("measured"), planned.size(), [&](const nlohmann::json& json) {
        const GazePart& gaze = *next++;
        return std::pair(gaze, measured_in(json, merged_.plan, gaze.repetitions));
      });
    });
  }

  MergedConvergence merged_;
  std::size_t scenes_ = 0;
  int gazes_ = 0;
  std::vector<MeasuredPart> gathered_;
};

}  // namespace

BenchPart convergence_part(const ConvergenceRun& run, const Shard& shard,
                           const std::vector<MeasuredPart>& measured) {
  nlohmann::json list = nlohmann::json::array();
  for (const MeasuredPart& part : measured) {
    list.push_back(json_of(part));
  }
  return {.command = convergence_command,
          .shard = shard,
          .settings = settings_json(run),
          .results = {{"machine", this_machine_json(run.threads)}, {"measured", std::move(list)}},
          .file = {}};
}

MergedConvergence merged_convergence(const std::vector<BenchPart>& parts) {
  Merge merge(parts.front());
  for (const BenchPart& part : parts) {
    merge.add(part);
  }
  return merge.result();
}

}  // namespace foveola::analysis
