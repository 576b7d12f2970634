#include "study/participant/population_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "renderer/base/similar_word.h"
#include "renderer/base/toml/toml_file.h"
#include "renderer/base/toml/toml_reader.h"
#include "renderer/gaze/profiles.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

/// The place of a number in a file and in a Population, and its range.
struct Parameter {
  std::string_view table;
  std::string_view key;
  double minimum;
  double maximum;
  double& (*in)(Population& population);
};

constexpr double tiny = 1e-6;

// The members' order is that of Population.
constexpr std::array parameters{
    Parameter{"gaze", "shortest_fixation_s", 0.02, 10.0,
              [](Population& p) -> double& { return p.gaze.shortest_fixation_s; }},
    Parameter{"gaze", "longest_fixation_s", 0.02, 10.0,
              [](Population& p) -> double& { return p.gaze.longest_fixation_s; }},
    Parameter{"gaze", "saccade_latency_s", 0.0, 2.0,
              [](Population& p) -> double& { return p.gaze.saccade_latency_s; }},
    Parameter{"gaze", "saccade_s", 0.001, 0.5,
              [](Population& p) -> double& { return p.gaze.saccade_s; }},
    Parameter{"gaze", "saccade_s_per_deg", 0.0, 0.1,
              [](Population& p) -> double& { return p.gaze.saccade_s_per_deg; }},
    Parameter{"gaze", "suppression_s", 0.0, 2.0,
              [](Population& p) -> double& { return p.gaze.suppression_s; }},
    Parameter{"gaze", "examined_part", 0.0, 1.5,
              [](Population& p) -> double& { return p.gaze.examined_part; }},
    Parameter{"gaze", "head_azimuth_deg", 0.0, 360.0,
              [](Population& p) -> double& { return p.gaze.head_azimuth_deg; }},
    Parameter{"gaze", "head_elevation_deg", 0.0, 90.0,
              [](Population& p) -> double& { return p.gaze.head_elevation_deg; }},
    Parameter{"gaze", "head_turn_s", 0.01, 10.0,
              [](Population& p) -> double& { return p.gaze.head_turn_s; }},
    Parameter{"gaze", "head_turn_s_per_deg", 0.0, 0.1,
              [](Population& p) -> double& { return p.gaze.head_turn_s_per_deg; }},
    Parameter{"gaze", "eye_in_head_deg", 0.0, 45.0,
              [](Population& p) -> double& { return p.gaze.eye_in_head_deg; }},
    Parameter{"gaze", "fixations_per_head_turn", 1.0, 100.0,
              [](Population& p) -> double& { return p.gaze.fixations_per_head_turn; }},

    Parameter{"decision", "outline_signal_to_noise", tiny, 1e6,
              [](Population& p) -> double& { return p.decision.outline_signal_to_noise; }},
    Parameter{"decision", "material_jnd", tiny, 1e6,
              [](Population& p) -> double& { return p.decision.material_jnd; }},
    Parameter{"decision", "integration_s", 0.0, 60.0,
              [](Population& p) -> double& { return p.decision.integration_s; }},
    Parameter{"decision", "evidence_limit", 0.01, 100.0,
              [](Population& p) -> double& { return p.decision.evidence_limit; }},
    Parameter{"decision", "glance_noise", 0.0, 10.0,
              [](Population& p) -> double& { return p.decision.glance_noise; }},
    Parameter{"decision", "criterion_spread", 0.0, 10.0,
              [](Population& p) -> double& { return p.decision.criterion_spread; }},
    Parameter{"decision", "drift_per_trial", 0.0, 1.0,
              [](Population& p) -> double& { return p.decision.drift_per_trial; }},
    Parameter{"decision", "impatience_per_s", 0.0, 1e3,
              [](Population& p) -> double& { return p.decision.impatience_per_s; }},
    Parameter{"decision", "reaction_mean_s", 0.0, 60.0,
              [](Population& p) -> double& { return p.decision.reaction_mean_s; }},
    Parameter{"decision", "reaction_deviation_s", 0.0, 10.0,
              [](Population& p) -> double& { return p.decision.reaction_deviation_s; }},
    Parameter{"decision", "reaction_tail_s", 0.0, 60.0,
              [](Population& p) -> double& { return p.decision.reaction_tail_s; }},
    Parameter{"decision", "reaction_spread", 0.0, 10.0,
              [](Population& p) -> double& { return p.decision.reaction_spread; }},
    Parameter{"decision", "lapse_part", 0.0, 1.0,
              [](Population& p) -> double& { return p.decision.lapse_part; }},
    Parameter{"decision", "lapse_s", 0.0, 60.0,
              [](Population& p) -> double& { return p.decision.lapse_s; }},
    Parameter{"decision", "early_part", 0.0, 1.0,
              [](Population& p) -> double& { return p.decision.early_part; }},
    Parameter{"decision", "early_factor", 1.0, 1e6,
              [](Population& p) -> double& { return p.decision.early_factor; }},
    // Below 1, or a person who is always early would be timed for ever.
    Parameter{"decision", "early_noticed_part", 0.0, 0.9,
              [](Population& p) -> double& { return p.decision.early_noticed_part; }},

    Parameter{"rating", "second_point_jnd", tiny, 1e6,
              [](Population& p) -> double& { return p.rating.second_point_jnd; }},
    Parameter{"rating", "step_factor", 1.01, 1e3,
              [](Population& p) -> double& { return p.rating.step_factor; }},
    Parameter{"rating", "pooling_exponent", 1.0, 100.0,
              [](Population& p) -> double& { return p.rating.pooling_exponent; }},
    Parameter{"rating", "bias_spread", 0.0, 10.0,
              [](Population& p) -> double& { return p.rating.bias_spread; }},
    Parameter{"rating", "noise_spread", 0.0, 10.0,
              [](Population& p) -> double& { return p.rating.noise_spread; }},

    Parameter{"background", "age_mean_years", 0.0, 150.0,
              [](Population& p) -> double& { return p.background.age_mean_years; }},
    Parameter{"background", "age_deviation_years", 0.0, 100.0,
              [](Population& p) -> double& { return p.background.age_deviation_years; }},
    Parameter{"background", "first_gender_part", 0.0, 1.0,
              [](Population& p) -> double& { return p.background.first_gender_part; }},
    Parameter{"background", "scale_mean_part", 0.0, 1.0,
              [](Population& p) -> double& { return p.background.scale_mean_part; }},
    Parameter{"background", "scale_deviation_part", 0.0, 1.0,
              [](Population& p) -> double& { return p.background.scale_deviation_part; }},

    Parameter{"vision", "jnd_lab", 0.01, 100.0,
              [](Population& p) -> double& { return p.vision.jnd_lab; }},
    Parameter{"vision", "decay_deg", 0.0, 10.0,
              [](Population& p) -> double& { return p.vision.decay_deg; }},
    Parameter{"vision", "half_resolution_deg", 0.1, 100.0,
              [](Population& p) -> double& { return p.vision.half_resolution_deg; }},
    Parameter{"vision", "chromatic_decay_factor", 0.0, 100.0,
              [](Population& p) -> double& { return p.vision.chromatic_decay_factor; }},
    Parameter{"vision", "red_green_decades_per_deg", 0.0, 1.0,
              [](Population& p) -> double& { return p.vision.red_green_decades_per_deg; }},
    Parameter{"vision", "recognition_line_pairs", 0.5, 100.0,
              [](Population& p) -> double& { return p.vision.recognition_line_pairs; }},
    Parameter{"vision", "surround_factor", 1.0, 5.0,
              [](Population& p) -> double& { return p.vision.surround_factor; }},
    Parameter{"vision", "material_cell_deg", 0.05, 10.0,
              [](Population& p) -> double& { return p.vision.material_cell_deg; }},
    Parameter{"vision", "view_cell_deg", 0.25, 30.0,
              [](Population& p) -> double& { return p.vision.view_cell_deg; }},
    Parameter{"vision", "scale_count", 1.0, 6.0,
              [](Population& p) -> double& { return p.vision.scale_count; }},
    Parameter{"vision", "pooling_exponent", 1.0, 100.0,
              [](Population& p) -> double& { return p.vision.pooling_exponent; }},
    Parameter{"vision", "object_patch_deg", 0.05, 90.0,
              [](Population& p) -> double& { return p.vision.object_patch_deg; }},
    Parameter{"vision", "view_patch_deg", 0.25, 90.0,
              [](Population& p) -> double& { return p.vision.view_patch_deg; }},
    Parameter{"vision", "looked_at_deg", 0.5, 45.0,
              [](Population& p) -> double& { return p.vision.looked_at_deg; }}};

fs::path people_folder() { return resource_folder() / "data" / "participants"; }

fs::path people_file(const std::string& name_or_path) {
  if (is_profile_path(name_or_path)) {
    return name_or_path;
  }
  const std::vector<std::string> names = people_names();
  if (std::find(names.begin(), names.end(), name_or_path) == names.end()) {
    throw Error(
        fmt::format("people '{}'", name_or_path), "are not known",
        did_you_mean(name_or_path, names,
                     fmt::format("choose one of {}, or give a path", fmt::join(names, ", "))));
  }
  return people_folder() / (name_or_path + ".toml");
}

std::string name_of(const Parameter& parameter) {
  return fmt::format("{}.{}", parameter.table, parameter.key);
}

/// { value = 0.2, source = "assumed" }
StatedNumber read_number(TomlReader& table, const Parameter& parameter) {
  StatedNumber number{.name = name_of(parameter)};
  table.require(parameter.key);
  TomlReader inner = table.table(parameter.key);
  inner.require("value");
  inner.read("value", number.value, parameter.minimum, parameter.maximum);
  number.source = inner.require_text("source");
  inner.reject_unknown_keys();
  return number;
}

/// Reads the numbers of one table, whose parameters follow one another.
void read_table(TomlReader& file, std::string_view name, People& people) {
  file.require(name);
  TomlReader table = file.table(name);
  for (const Parameter& parameter : parameters) {
    if (parameter.table == name) {
      people.numbers.push_back(read_number(table, parameter));
      parameter.in(people.population) = people.numbers.back().value;
    }
  }
  table.reject_unknown_keys();
  const GazeHabits& gaze = people.population.gaze;
  if (name == "gaze" && gaze.shortest_fixation_s > gaze.longest_fixation_s) {
    table.fail(table.source("longest_fixation_s"),
               "the longest fixation is shorter than the shortest", "exchange them");
  }
}

}  // namespace

People read_people(const std::string& name_or_path) {
  const fs::path file = people_file(name_or_path);
  People people{.name = file.stem().string(), .toml = read_toml_file(file)};
  const toml::table content =
      parse_toml(file.string(), people.toml,
                 fmt::format("see {}", (people_folder() / "adults.toml").string()));
  TomlReader reader(file.string(), content, "");
  people.title = reader.require_text("title");
  for (const std::string_view table : {"gaze", "decision", "rating", "background", "vision"}) {
    read_table(reader, table, people);
  }
  reader.reject_unknown_keys();
  return people;
}

std::vector<std::string> people_names() { return toml_names_in(people_folder()); }

std::string toml_with_number(const People& people, const std::string& name, double value) {
  const auto* const parameter =
      std::find_if(parameters.begin(), parameters.end(),
                   [&](const Parameter& candidate) { return name_of(candidate) == name; });
  if (parameter == parameters.end()) {
    throw Error(fmt::format("parameter '{}'", name), "is not one of a population",
                "see the names in data/participants/adults.toml");
  }
  if (!(value >= parameter->minimum && value <= parameter->maximum)) {
    throw Error(fmt::format("parameter '{}'", name), fmt::format("cannot be {}", value),
                fmt::format("choose one from {} to {}", parameter->minimum, parameter->maximum));
  }
  toml::table content{{"title", fmt::format("{}, {} {}", people.title, name, value)}};
  for (const Parameter& stated_one : parameters) {
    const auto stated = std::find_if(
        people.numbers.begin(), people.numbers.end(),
        [&](const StatedNumber& number) { return number.name == name_of(stated_one); });
    toml::table number{{"value", stated->value}, {"source", stated->source}};
    if (&stated_one == parameter) {
      number =
          toml::table{{"value", value}, {"source", fmt::format("changed from {}", stated->value)}};
    }
    content.insert(stated_one.table, toml::table{});
    content[stated_one.table].as_table()->insert(stated_one.key, std::move(number));
  }
  std::ostringstream text;
  text << content << "\n";
  return text.str();
}

}  // namespace foveola::study
