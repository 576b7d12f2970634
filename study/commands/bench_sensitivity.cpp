#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "renderer/base/numbers/aligned_rows.h"
#include "renderer/base/text/print.h"
#include "renderer/base/transformed.h"
#include "renderer/commands/bench_facts.h"
#include "study/commands/command_line.h"
#include "study/commands/commands.h"
#include "study/participant/population_file.h"
#include "study/protocol/protocol.h"
#include "study/simulation/prediction_agreement.h"
#include "study/simulation/simulate_study.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

struct SensitivityArguments : SimulatedBenchArguments {
  double factor = 1.5;
  std::vector<std::string> numbers;
};

struct Outcome {
  std::string number;  ///< empty: the unchanged population
  double value = 0.0;
  std::vector<MethodMean> means;
};

/// Returns whether the unchanged population's pilots also serve one with another value of this
/// number.
bool shares_pilots(const std::string& number) {
  constexpr std::array of_eyes = {"vision.decay_deg", "vision.half_resolution_deg",
                                  "vision.chromatic_decay_factor",
                                  "vision.red_green_decades_per_deg", "vision.pooling_exponent"};
  return number.starts_with("decision.") || number.starts_with("gaze.") ||
         std::ranges::find(of_eyes, number) != of_eyes.end();
}

std::vector<StatedNumber> chosen_numbers(const SensitivityArguments& arguments,
                                         const People& people) {
  std::vector<StatedNumber> chosen;
  for (const StatedNumber& number : people.numbers) {
    const bool is_asked =
        std::ranges::find(arguments.numbers, number.name) != arguments.numbers.end();
    if (is_asked && number.value == 0.0) {
      throw Error(fmt::format("--number {}", number.name), "is 0, which no factor changes",
                  "simulate another value with study simulate --people FILE");
    }
    if (arguments.numbers.empty() ? number.value != 0.0 && shares_pilots(number.name) : is_asked) {
      chosen.push_back(number);
    }
  }
  for (const std::string& name : arguments.numbers) {
    if (std::ranges::none_of(chosen,
                             [&](const StatedNumber& number) { return number.name == name; })) {
      throw Error(fmt::format("--number {}", name), "is not a number in a population file",
                  "see the names in data/participants/adults.toml");
    }
  }
  return chosen;
}

std::vector<MethodMean> simulate(SimulatedBenchArguments arguments, const std::string& people,
                                 const fs::path& database, const SceneFinderBeside& find_scene,
                                 const std::stop_token& stop) {
  arguments.simulation.people = people;
  arguments.simulation.predicted = true;
  simulate_study(arguments, database, find_scene, stop);
  return method_means(read_study(database));
}

/// Simulates the unchanged population, and each number divided and multiplied by the factor, if
/// within its range.
std::vector<Outcome> simulate_all(const SensitivityArguments& arguments,
                                  const SceneFinderBeside& find_scene,
                                  const std::stop_token& stop) {
  const fs::path folder = arguments.folder;
  const People people = read_people("adults");
  const std::vector<StatedNumber> numbers = chosen_numbers(arguments, people);
  std::vector<Outcome> outcomes;
  outcomes.push_back(
      {.means = simulate(arguments, people.name, folder / "adults.sqlite", find_scene, stop)});
  for (const StatedNumber& number : numbers) {
    for (const double value : {number.value / arguments.factor, number.value * arguments.factor}) {
      if (stop.stop_requested()) {
        return outcomes;
      }
      const std::string name = fmt::format("{}-{:.6g}", number.name, value);
      const fs::path file = folder / (name + ".toml");
      try {
        write_file(file, toml_with_number(people, number.name, value));
        read_people(file.string());
      } catch (const Error& out_of_range) {
        print_text(stderr, "foveola: warning: left out: {}\n", out_of_range.what());
        continue;
      }
      outcomes.push_back({.number = number.name,
                          .value = value,
                          .means = simulate(arguments, file.string(), folder / (name + ".sqlite"),
                                            find_scene, stop)});
    }
  }
  return outcomes;
}

std::string text_of(const std::vector<Outcome>& outcomes) {
  TextRow head = {"number", "value"};
  std::string mark;
  for (const MethodMean& mean : outcomes.front().means) {
    if (mean.mark != mark) {
      head.push_back(mean.mark + " s");
      mark = mean.mark;
    }
    head.push_back(mean.method + " %");
  }
  std::vector<TextRow> rows = {head};
  for (const Outcome& outcome : outcomes) {
    rows.push_back(outcome.number.empty()
                       ? TextRow{"as they are", ""}
                       : TextRow{outcome.number, fmt::format("{:.4g}", outcome.value)});
    mark.clear();
    for (const MethodMean& mean : outcome.means) {
      if (mean.mark != mark) {
        rows.back().push_back(fmt::format("{:.2f}", mean.baseline_s));
        mark = mean.mark;
      }
      rows.back().push_back(fmt::format("{:.1f}", mean.percent));
    }
  }
  return aligned(rows);
}

nlohmann::json json_of(const std::vector<Outcome>& outcomes) {
  nlohmann::json list = nlohmann::json::array();
  for (const Outcome& outcome : outcomes) {
    const nlohmann::json means(transformed(outcome.means, [&](const MethodMean& mean) {
      return nlohmann::json{{"mark", mean.mark},
                            {"method", mean.method},
                            {"pairs", mean.pairs},
                            {"baseline_s", mean.baseline_s},
                            {"percent", mean.percent}};
    }));
    list.push_back(
        {{"name", outcome.number.empty() ? "as they are"
                                         : fmt::format("{} {:.4g}", outcome.number, outcome.value)},
         {"number", outcome.number},
         {"value", outcome.value},
         {"means", means}});
  }
  return list;
}

void run_bench(const SensitivityArguments& arguments, const SceneFinderBeside& find_scene,
               const std::stop_token& stop) {
  if (!fs::is_directory(arguments.folder)) {
    throw Error(arguments.folder, "is not a folder", "make the folder");
  }
  const fs::path protocol = find_protocol(arguments.protocol);
  if (load_protocol(protocol).methods.size() < 2) {
    throw Error(protocol.string(), "has a single method", "choose one that compares methods");
  }
  const std::vector<Outcome> outcomes = simulate_all(arguments, find_scene, stop);
  if (arguments.json) {
    nlohmann::ordered_json report = bench_facts();
    report.update({{"simulated", true},
                   {"scale", arguments.simulation.scale},
                   {"seed", arguments.simulation.seed},
                   {"participants", arguments.simulation.participants},
                   {"outcomes", json_of(outcomes)}});
    print_text("{}\n", report.dump(2));
  } else {
    print_text(
        "Simulated participants. Geometric means; the baseline's in seconds, others in per "
        "cent of it.\n{}",
        text_of(outcomes));
  }
  if (stop.stop_requested()) {
    print_text(stderr, "Stopped. To continue, repeat the command.\n");
  }
}

}  // namespace

void add_bench_sensitivity(CLI::App& bench, const SceneFinderBeside& find_scene,
                           std::stop_token stop) {
  const auto arguments = std::make_shared<SensitivityArguments>();
  CLI::App* command =
      add_command(bench, "sensitivity",
                  "Simulate a predicted study repeatedly, each time with one number of its "
                  "population changed",
                  "sensitivity koskela2018 --scale 36 --participants 100 --seed 1 -o bench");
  add_simulated_studies(
      command, *arguments,
      "The folder of the populations' and studies' files; studies that are there already are "
      "resumed");
  command->add_option("--scale", arguments->simulation.scale, "As in study simulate");
  command
      ->add_option("--factor", arguments->factor,
                   "Each number is divided by this, and multiplied by it")
      ->check(CLI::Range(1.001, 1000.0));
  command->add_option(
      "--number", arguments->numbers,
      "Vary only these numbers, such as decision.material_jnd (default: all without need of "
      "pilots of their own)");
  add_effort_and_json(command, *arguments);
  command->callback([arguments, find_scene, stop] { run_bench(*arguments, find_scene, stop); });
}

}  // namespace foveola::study
