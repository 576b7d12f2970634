#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "renderer/base/numbers/aligned_rows.h"
#include "renderer/base/text/print.h"
#include "renderer/base/transformed.h"
#include "renderer/commands/bench_facts.h"
#include "study/commands/command_line.h"
#include "study/commands/commands.h"
#include "study/simulation/prediction_agreement.h"
#include "study/simulation/simulate_study.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

std::string text_of(const std::vector<MarkAgreement>& agreements) {
  std::vector<TextRow> rows = {
      {"mark", "method", "trials", "rendered s", "predicted s", "ratio", "rank correlation"}};
  for (const MarkAgreement& agreement : agreements) {
    rows.push_back({agreement.mark, agreement.method.empty() ? "all" : agreement.method,
                    fmt::format("{}", agreement.trials),
                    fmt::format("{:.2f}", agreement.rendered_median_s),
                    fmt::format("{:.2f}", agreement.predicted_median_s),
                    fmt::format("{:.3f}", agreement.median_ratio),
                    fmt::format("{:.3f}", agreement.rank_correlation)});
  }
  return aligned(rows);
}

nlohmann::json json_of(const std::vector<MarkAgreement>& agreements) {
  return transformed(agreements, [&](const MarkAgreement& agreement) {
    return nlohmann::json{{"mark", agreement.mark},
                          {"method", agreement.method.empty() ? "all" : agreement.method},
                          {"trials", agreement.trials},
                          {"rendered_median_s", agreement.rendered_median_s},
                          {"predicted_median_s", agreement.predicted_median_s},
                          {"median_ratio", agreement.median_ratio},
                          {"rank_correlation", agreement.rank_correlation}};
  });
}

void run_bench(SimulatedBenchArguments arguments, const SceneFinderBeside& find_scene,
               const std::stop_token& stop) {
  const fs::path folder = arguments.folder;
  if (!fs::is_directory(folder)) {
    throw Error(folder.string(), "is not a folder", "make the folder");
  }
  arguments.simulation.predicted = true;
  const SimulateReport predicted =
      simulate_study(arguments, folder / "predicted.sqlite", find_scene, stop);
  arguments.simulation.predicted = false;
  const SimulateReport rendered =
      simulate_study(arguments, folder / "rendered.sqlite", find_scene, stop);
  const std::vector<MarkAgreement> agreements = prediction_agreement(
      read_study(folder / "rendered.sqlite"), read_study(folder / "predicted.sqlite"));
  if (arguments.json) {
    nlohmann::ordered_json report = bench_facts();
    report.update({{"scale", arguments.simulation.scale},
                   {"seed", arguments.simulation.seed},
                   {"rendered_sessions_wall_seconds", measured_once(rendered.sessions_wall_s)},
                   {"predicted_sessions_wall_seconds", measured_once(predicted.sessions_wall_s)},
                   {"agreement", json_of(agreements)}});
    print_text("{}\n", report.dump(2));
  } else {
    print_text("{}", text_of(agreements));
  }
  if (stop.stop_requested()) {
    print_text("Stopped. To continue, repeat the command.\n");
  }
}

}  // namespace

void add_bench_prediction(CLI::App& bench, const SceneFinderBeside& find_scene,
                          std::stop_token stop) {
  const auto arguments = std::make_shared<SimulatedBenchArguments>();
  CLI::App* command =
      add_command(bench, "prediction",
                  "Simulate a study twice, rendered and predicted, and compare the times of marks",
                  "prediction demo --participants 2 --seed 1 -o bench");
  add_simulated_studies(
      command, *arguments,
      "The folder of both studies' files; studies that are there already are resumed");
  command->add_option("--scale", arguments->simulation.scale, "As in study simulate");
  add_effort_and_json(command, *arguments);
  command->callback([arguments, find_scene, stop] { run_bench(*arguments, find_scene, stop); });
}

}  // namespace foveola::study
