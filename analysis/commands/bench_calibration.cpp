#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analysis/commands/commands.h"
#include "analysis/koskela2018/machine_speed.h"
#include "analysis/koskela2018/published_study.h"
#include "analysis/publication/exports/output_folder.h"
#include "analysis/publication/report/published_comparison_report.h"
#include "analysis/tables/table.h"
#include "analysis/tables/table_formats.h"
#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "renderer/base/numbers/aligned_rows.h"
#include "renderer/base/text/print.h"
#include "renderer/commands/bench_facts.h"
#include "study/commands/command_line.h"
#include "study/protocol/protocol.h"
#include "study/simulation/simulate_study.h"

namespace fs = std::filesystem;

namespace foveola::analysis {
namespace {

/// Results of a study on one machine.
struct TriedSpeed {
  std::vector<ComparedNumber> numbers;
  std::size_t baseline_trials_out_of_time = 0;
};

/// Predicted studies of the same people on machines of several speeds, each simulated once.
class TriedSpeeds {
 public:
  TriedSpeeds(const study::SimulatedBenchArguments& arguments, const SceneFinderBeside& find_scene,
              std::stop_token stop)
      : arguments_(arguments),
        find_scene_(find_scene),
        stop_(std::move(stop)),
        published_(read_published_study(resource_folder() / "data" / "koskela2018")) {}

  fs::path database(double samples_per_second) const {
    return fs::path(arguments_.folder) / fmt::format("{:.10g}.sqlite", samples_per_second);
  }

  /// Throws Error if stopped.
  const TriedSpeed& at(double samples_per_second) {
    const auto known = tried_.find(samples_per_second);
    return known != tried_.end()
               ? known->second
               : tried_.emplace(samples_per_second, simulate(samples_per_second)).first->second;
  }

 private:
  TriedSpeed simulate(double samples_per_second) const {
    const fs::path file = database(samples_per_second);
    study::SimulatedBenchArguments arguments = arguments_;
    arguments.simulation.samples_per_second = samples_per_second;
    arguments.simulation.predicted = true;
    study::simulate_study(arguments, file, find_scene_, stop_);
    if (stop_.stop_requested()) {
      throw Error("calibration", "was stopped before its end", "repeat the command to continue");
    }
    const study::StudyRecords records = study::read_study(file);
    TriedSpeed tried;
    tried.numbers = compare_with_published(records, tabulate_study(records), published_);
    for (std::size_t row = 0; row < records.trials.size(); ++row) {
      tried.baseline_trials_out_of_time += ran_out(records, row) ? 1 : 0;
    }
    return tried;
  }

  /// Returns whether a mark's time, in a trial with the baseline, is right-censored.
  static bool ran_out(const study::StudyRecords& records, std::size_t row) {
    const study::TrialRow& trial = records.trials[row];
    bool ran_out = false;
    for (std::size_t measure = 0; measure < records.measures.size(); ++measure) {
      ran_out |= records.value(row, measure).state == study::Value::State::right_censored;
    }
    return ran_out && trial.method == baseline && study::StudyRecords::is_result(trial);
  }

  const study::SimulatedBenchArguments& arguments_;
  const SceneFinderBeside& find_scene_;
  std::stop_token stop_;
  PublishedStudy published_;
  std::map<double, TriedSpeed> tried_;
};

struct NamedSpeed {
  std::string cells;
  MachineSpeed speed;
};

std::string text_of(const NamedSpeed& named) {
  const MachineSpeed& speed = named.speed;
  return fmt::format(
      "{:<14}{:>10.0f} samples per second{}\n", named.cells, speed.samples_per_second,
      speed.interval ? fmt::format(" [{:.0f}, {:.0f}]", speed.interval->low, speed.interval->high)
                     : "");
}

std::string text_of(const std::vector<ComparedNumber>& cells) {
  std::vector<TextRow> rows = {
      {"scene", "own scene", "mark", "published s (SD)", "simulated s (SD)", "ratio"}};
  for (const ComparedNumber& cell : cells) {
    rows.push_back(
        {cell.row, cell.own_row, cell.mark,
         fmt::format("{:.1f} ({:.1f})", cell.published.value, cell.published_deviation.value_or(0)),
         fmt::format("{:.1f} ({:.1f})", cell.study->value, cell.study_deviation.value_or(0)),
         fmt::format("{:.2f}", *times_published(cell))});
  }
  return aligned(rows);
}

Table speeds_table(const std::vector<NamedSpeed>& speeds) {
  using S = NamedSpeed;
  const auto interval = path(&S::speed, &MachineSpeed::interval);
  const ColumnsOf<S> columns = {{"name", "", "Cells that the speed was fitted to", &S::cells},
                                {"value", "", "Fitted speed in samples per second",
                                 path(&S::speed, &MachineSpeed::samples_per_second)},
                                {"low", "", "Lower 95 % confidence limit of value, over scenes",
                                 path(interval, &Interval::low)},
                                {"high", "", "Upper 95 % confidence limit of value, over scenes",
                                 path(interval, &Interval::high)}};
  return tabulate("samples_per_second", "fit", columns, speeds);
}

Table cells_table(const std::vector<ComparedNumber>& cells) {
  using N = ComparedNumber;
  const ColumnsOf<N> columns = {
      {"scene", "", "Name of the published scene", &N::row},
      {"own_scene", "", "Name of the study's scene in its place", &N::own_row},
      {"mark", "", "Id of the mark", &N::mark},
      {"published_s", "s", "Published mean", path(&N::published, &Estimate::value)},
      {"simulated_s", "s", "Simulated mean", path(&N::study, &Estimate::value)}};
  return tabulate("cells", "published time with OD", columns, cells);
}

std::vector<NamedSpeed> fit_speeds(TriedSpeeds& speeds, double first) {
  const CompareAtSpeed compare = [&](double speed) { return speeds.at(speed).numbers; };
  const MachineSpeed both = fit_machine_speed(compare, first);
  return {{"both marks", both},
          {"outline alone", fit_machine_speed(compare, both.samples_per_second, "outline")},
          {"material alone", fit_machine_speed(compare, both.samples_per_second, "material")}};
}

void run(const study::SimulatedBenchArguments& arguments, const SceneFinderBeside& find_scene,
         const std::stop_token& stop) {
  check_output_folder(arguments.folder);
  const study::Protocol protocol = study::load_protocol(study::find_protocol(arguments.protocol));
  make_output_folder(arguments.folder);
  TriedSpeeds speeds(arguments, find_scene, stop);
  const std::vector<NamedSpeed> fitted = fit_speeds(speeds, protocol.machine.samples_per_second);
  const double speed = fitted.front().speed.samples_per_second;
  const TriedSpeed& tried = speeds.at(speed);
  const std::vector<ComparedNumber> cells = baseline_cells(tried.numbers, "");
  const std::string report = report_published_comparison(speeds.database(speed), arguments.folder);
  if (arguments.json) {
    nlohmann::ordered_json json = bench_facts();
    json.update({{"participants", arguments.simulation.participants},
                 {"seed", arguments.simulation.seed},
                 {"scale", arguments.simulation.scale},
                 {"participant_kind", "simulated"},
                 {"baseline_trials_out_of_time", tried.baseline_trials_out_of_time},
                 {"samples_per_second", json_of(speeds_table(fitted))},
                 {"cells", json_of(cells_table(cells))}});
    print_text("{}\n", json.dump(2));
    return;
  }
  print_text(
      "{} predicted participants. Machine speeds at which OD takes as long as published, in the "
      "geometric mean of Table 2's cells; in brackets, 95 % confidence intervals over scenes:\n",
      arguments.simulation.participants);
  for (const NamedSpeed& named : fitted) {
    print_text("  {}", text_of(named));
  }
  print_text("OD, which was fitted, with {:.0f} samples per second:\n{}", speed, text_of(cells));
  if (tried.baseline_trials_out_of_time > 0) {
    print_text("In {} trials with OD a time is right-censored; these times are not in the means.\n",
               tried.baseline_trials_out_of_time);
  }
  print_text("The same study beside the published one; VP and FV were not fitted:\n{}", report);
}

}  // namespace

// NOLINTNEXTLINE(performance-unnecessary-value-param): every module adds its commands alike.
void add_bench_calibration(CLI::App& bench, const SceneFinderBeside& find_scene,
                           std::stop_token stop) {
  const auto arguments = std::make_shared<study::SimulatedBenchArguments>();
  CLI::App* command = study::add_command(
      bench, "calibration",
      "Find the machine's speed at which OD takes as long as in the published study",
      "calibration koskela2018 --participants 200 --scale 36 -o calibration");
  study::add_simulated_studies(
      command, *arguments,
      "A folder for the simulated studies, each named by its samples per second, and for the "
      "last one's comparison with the published study; made if its parent exists. Existing studies "
      "are resumed");
  command->add_option("--people", arguments->simulation.people, "As in study simulate");
  command->add_option("--scale", arguments->simulation.scale, "As in study simulate");
  study::add_effort_and_json(command, *arguments);
  command->callback([arguments, find_scene, stop] { run(*arguments, find_scene, stop); });
}

}  // namespace foveola::analysis
