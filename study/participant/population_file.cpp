#include "study/participant/population_file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <sstream>
#include <string_view>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "renderer/base/text/similar_word.h"
#include "renderer/base/toml/toml_file.h"
#include "renderer/base/toml/toml_reader.h"
#include "renderer/gaze/profiles.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

double& number_in(Population& people, double GazeHabits::* number) { return people.gaze.*number; }
double& number_in(Population& people, double DecisionHabits::* number) {
  return people.decision.*number;
}
double& number_in(Population& people, double RatingHabits::* number) {
  return people.rating.*number;
}
double& number_in(Population& people, double Background::* number) {
  return people.background.*number;
}
double& number_in(Population& people, double Vision::* number) { return people.vision.*number; }

/// A number's place in a file and in a Population, and its range.
struct Parameter {
  std::string_view table;
  std::string_view key;
  double minimum;
  double maximum;
  std::variant<double GazeHabits::*, double DecisionHabits::*, double RatingHabits::*,
               double Background::*, double Vision::*>
      member;
};

constexpr double tiny = 1e-6;

// In the order of Population's members.
constexpr auto parameters = std::to_array<Parameter>(
    {{"gaze", "shortest_fixation_s", 0.02, 10.0, &GazeHabits::shortest_fixation_s},
     {"gaze", "longest_fixation_s", 0.02, 10.0, &GazeHabits::longest_fixation_s},
     {"gaze", "saccade_latency_s", 0.0, 2.0, &GazeHabits::saccade_latency_s},
     {"gaze", "saccade_s", 0.001, 0.5, &GazeHabits::saccade_s},
     {"gaze", "saccade_s_per_deg", 0.0, 0.1, &GazeHabits::saccade_s_per_deg},
     {"gaze", "suppression_s", 0.0, 2.0, &GazeHabits::suppression_s},
     {"gaze", "examined_part", 0.0, 1.5, &GazeHabits::examined_part},
     {"gaze", "head_azimuth_deg", 0.0, 360.0, &GazeHabits::head_azimuth_deg},
     {"gaze", "head_elevation_deg", 0.0, 90.0, &GazeHabits::head_elevation_deg},
     {"gaze", "head_turn_s", 0.01, 10.0, &GazeHabits::head_turn_s},
     {"gaze", "head_turn_s_per_deg", 0.0, 0.1, &GazeHabits::head_turn_s_per_deg},
     {"gaze", "eye_in_head_deg", 0.0, 45.0, &GazeHabits::eye_in_head_deg},
     {"gaze", "fixations_per_head_turn", 1.0, 100.0, &GazeHabits::fixations_per_head_turn},

     {"decision", "outline_signal_to_noise", tiny, 1e6, &DecisionHabits::outline_signal_to_noise},
     {"decision", "material_jnd", tiny, 1e6, &DecisionHabits::material_jnd},
     {"decision", "integration_s", 0.0, 60.0, &DecisionHabits::integration_s},
     {"decision", "evidence_limit", 0.01, 100.0, &DecisionHabits::evidence_limit},
     {"decision", "glance_noise", 0.0, 10.0, &DecisionHabits::glance_noise},
     {"decision", "criterion_spread", 0.0, 10.0, &DecisionHabits::criterion_spread},
     {"decision", "drift_per_trial", 0.0, 1.0, &DecisionHabits::drift_per_trial},
     {"decision", "impatience_per_s", 0.0, 1e3, &DecisionHabits::impatience_per_s},
     {"decision", "reaction_mean_s", 0.0, 60.0, &DecisionHabits::reaction_mean_s},
     {"decision", "reaction_deviation_s", 0.0, 10.0, &DecisionHabits::reaction_deviation_s},
     {"decision", "reaction_tail_s", 0.0, 60.0, &DecisionHabits::reaction_tail_s},
     {"decision", "reaction_spread", 0.0, 10.0, &DecisionHabits::reaction_spread},
     {"decision", "lapse_part", 0.0, 1.0, &DecisionHabits::lapse_part},
     {"decision", "lapse_s", 0.0, 60.0, &DecisionHabits::lapse_s},
     {"decision", "early_part", 0.0, 1.0, &DecisionHabits::early_part},
     {"decision", "early_factor", 1.0, 1e6, &DecisionHabits::early_factor},
     // Below 1: a person who is always early would be retimed forever.
     {"decision", "early_noticed_part", 0.0, 0.9, &DecisionHabits::early_noticed_part},

     {"rating", "second_point_jnd", tiny, 1e6, &RatingHabits::second_point_jnd},
     {"rating", "step_factor", 1.01, 1e3, &RatingHabits::step_factor},
     {"rating", "pooling_exponent", 1.0, 100.0, &RatingHabits::pooling_exponent},
     {"rating", "bias_spread", 0.0, 10.0, &RatingHabits::bias_spread},
     {"rating", "noise_spread", 0.0, 10.0, &RatingHabits::noise_spread},

     {"background", "age_mean_years", 0.0, 150.0, &Background::age_mean_years},
     {"background", "age_deviation_years", 0.0, 100.0, &Background::age_deviation_years},
     {"background", "first_gender_part", 0.0, 1.0, &Background::first_gender_part},
     {"background", "scale_mean_part", 0.0, 1.0, &Background::scale_mean_part},
     {"background", "scale_deviation_part", 0.0, 1.0, &Background::scale_deviation_part},

     {"vision", "jnd_lab", 0.01, 100.0, &Vision::jnd_lab},
     {"vision", "decay_deg", 0.0, 10.0, &Vision::decay_deg},
     {"vision", "half_resolution_deg", 0.1, 100.0, &Vision::half_resolution_deg},
     {"vision", "chromatic_decay_factor", 0.0, 100.0, &Vision::chromatic_decay_factor},
     {"vision", "red_green_decades_per_deg", 0.0, 1.0, &Vision::red_green_decades_per_deg},
     {"vision", "recognition_line_pairs", 0.5, 100.0, &Vision::recognition_line_pairs},
     {"vision", "surround_factor", 1.0, 5.0, &Vision::surround_factor},
     {"vision", "material_cell_deg", 0.05, 10.0, &Vision::material_cell_deg},
     {"vision", "view_cell_deg", 0.25, 30.0, &Vision::view_cell_deg},
     {"vision", "scale_count", 1.0, 6.0, &Vision::scale_count},
     {"vision", "pooling_exponent", 1.0, 100.0, &Vision::pooling_exponent},
     {"vision", "object_patch_deg", 0.05, 90.0, &Vision::object_patch_deg},
     {"vision", "view_patch_deg", 0.25, 90.0, &Vision::view_patch_deg},
     {"vision", "looked_at_deg", 0.5, 45.0, &Vision::looked_at_deg}});

fs::path people_folder() { return resource_folder() / "data" / "participants"; }

fs::path people_file(const std::string& name_or_path) {
  if (is_profile_path(name_or_path)) {
    return name_or_path;
  }
  const std::vector<std::string> names = people_names();
  if (std::ranges::find(names, name_or_path) == names.end()) {
    throw Error(
        fmt::format("people '{}'", name_or_path), "is not a known population",
        did_you_mean(name_or_path, names,
                     fmt::format("choose one of {}, or give a path", fmt::join(names, ", "))));
  }
  return people_folder() / (name_or_path + ".toml");
}

std::string name_of(const Parameter& parameter) {
  return fmt::format("{}.{}", parameter.table, parameter.key);
}

/// Reads { value = 0.2, source = "assumed" }.
StatedNumber read_number(TomlReader& table, const Parameter& parameter) {
  StatedNumber number{.name = name_of(parameter)};
  TomlReader inner = table.table(required(parameter.key));
  inner.read(required("value"), number.value, parameter.minimum, parameter.maximum);
  number.source = inner.require_text("source");
  inner.reject_unknown_keys();
  return number;
}

/// Reads the numbers of one table, whose parameters are adjacent.
void read_table(TomlReader& file, std::string_view name, People& people) {
  TomlReader table = file.table(required(name));
  for (const Parameter& parameter : parameters) {
    if (parameter.table == name) {
      people.numbers.push_back(read_number(table, parameter));
      std::visit(
          [&](auto member) { number_in(people.population, member) = people.numbers.back().value; },
          parameter.member);
    }
  }
  table.reject_unknown_keys();
  const GazeHabits& gaze = people.population.gaze;
  if (name == "gaze" && gaze.shortest_fixation_s > gaze.longest_fixation_s) {
    table.fail(table.source("longest_fixation_s"),
               "the maximum fixation is shorter than the minimum", "exchange them");
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
  const auto* const parameter = std::ranges::find_if(
      parameters, [&](const Parameter& candidate) { return name_of(candidate) == name; });
  if (parameter == parameters.end()) {
    throw Error(fmt::format("parameter '{}'", name), "is not a number of a population",
                "see the names in data/participants/adults.toml");
  }
  if (!(value >= parameter->minimum && value <= parameter->maximum)) {
    throw Error(
        fmt::format("parameter '{}'", name), fmt::format("is not within its range: {}", value),
        fmt::format("choose a value from {} to {}", parameter->minimum, parameter->maximum));
  }
  toml::table content{{"title", fmt::format("{}, {} {}", people.title, name, value)}};
  for (const Parameter& stated_one : parameters) {
    const auto stated = std::ranges::find(people.numbers, name_of(stated_one), &StatedNumber::name);
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
