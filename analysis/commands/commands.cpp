#include "analysis/commands/commands.h"

#include <filesystem>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "analysis/commands/analysis_json.h"
#include "analysis/commands/power_tables.h"
#include "analysis/publication/analyze_study.h"
#include "renderer/base/error.h"
#include "study/record/study_records.h"

namespace foveola::analysis {
namespace {

struct AnalyzeArguments {
  std::filesystem::path database;
  std::filesystem::path folder;
  std::string protocol;
  bool json = false;
  AnalysisOptions options;
  bool power = false;
  PowerSettings planning;
};

/// The settings with the plan of the protocol or of the study that is named, if one is.
PowerSettings power_settings(const AnalyzeArguments& arguments) {
  if (!arguments.folder.empty()) {
    throw UsageError("--output", "has no use with --power, which writes nothing", "leave it out");
  }
  if (!arguments.database.empty()) {
    return planned_power(arguments.planning,
                         study::read_study(arguments.database).protocol.analysis);
  }
  if (!arguments.protocol.empty()) {
    return planned_power(arguments.planning,
                         study::load_protocol(study::find_protocol(arguments.protocol)).analysis);
  }
  return arguments.planning;
}

void run_power(const AnalyzeArguments& arguments) {
  const PowerSettings settings = power_settings(arguments);
  const PowerPlan plan = plan_power(settings);
  fmt::print("{}", arguments.json ? power_json(settings, plan) + "\n" : power_text(settings, plan));
}

void run_analyze(const AnalyzeArguments& arguments) {
  if (arguments.power) {
    run_power(arguments);
    return;
  }
  if (arguments.database.empty() || arguments.folder.empty()) {
    throw UsageError(arguments.database.empty() ? "STUDY" : "--output", "is missing",
                     "see foveola analyze --help");
  }
  const AnalysisOutput output =
      analyze_study(arguments.database, arguments.folder, arguments.options);
  if (arguments.json) {
    fmt::print("{}\n", analysis_json(output));
    return;
  }
  fmt::print("{}\n", output.summary);
  for (const std::string& warning : output.warnings) {
    fmt::print("Note: {}\n", warning);
  }
  fmt::print("Report: {}\n", output.report.string());
}

void add_planning(CLI::App& command, AnalyzeArguments& arguments) {
  PowerSettings& planning = arguments.planning;
  command.add_flag("--power", arguments.power,
                   "Plan a study instead of analysing one: the participants needed for a power, by "
                   "formula and by simulation");
  const auto add = [&](const char* name, auto& value, const char* help) {
    return command.add_option(name, value, help)->needs("--power")->capture_default_str();
  };
  CLI::Option* alpha = add("--alpha", planning.alpha, "Significance level of the two-sided test")
                           ->check(CLI::Range(1e-6, 0.5));
  command
      .add_option("--protocol", arguments.protocol,
                  "Plan by this protocol's level, planned comparisons (Holm) and participants; so "
                  "does STUDY by its own")
      ->needs("--power")
      ->excludes(alpha);
  add("--ratio", planning.ratio_percent,
      "Expected time with the method, in per cent of that with the baseline");
  add("--spread", planning.spread,
      "Factor, above 1, by which participants' own ratios vary: two thirds lie within it");
  add("--target", planning.power, "Power to reach")->check(CLI::Range(0.06, 0.9999));
  add("--participants", planning.participants,
      "Report the power with this many participants, instead of how many are needed")
      ->check(CLI::Range(2, 1'000'000));
  add("--studies", planning.studies, "Studies to simulate")->check(CLI::Range(1, 10'000'000));
  add("--seed", planning.seed, "Seed of the simulation");
}

}  // namespace

// NOLINTNEXTLINE(performance-unnecessary-value-param): every module adds its commands alike.
void add_analysis_commands(CLI::App& app, std::stop_token /*stop*/) {
  const auto arguments = std::make_shared<AnalyzeArguments>();
  CLI::App* command =
      app.add_subcommand("analyze", "Write tables, figures and a report of a study");
  command->add_option("STUDY", arguments->database,
                      "The study's .sqlite file, as study run and study simulate write it");
  command->add_option("-o,--output", arguments->folder,
                      "The folder to write the results to; made if its parent exists");
  command->add_flag("--json", arguments->json,
                    "Print the paths of the results and the main numbers as JSON");
  command->add_flag("--bids", arguments->options.bids,
                    "Also write the behavioural data and the gaze in the BIDS layout, a folder for "
                    "each participant");
  command->add_flag("--r", arguments->options.r,
                    "Fit mixed, ordinal and Tobit models by R, and take the primary analyses from "
                    "them; seconds for times, up to a minute for each rating");
  command->add_flag("--unverified", arguments->options.unverified,
                    "Analyse a file even if it was changed or damaged since it was written; the "
                    "report then says what is wrong with it");
  command->add_flag("--withdrawn", arguments->options.withdrawn,
                    "Also write the trials and answers of participants who withdrew to "
                    "trials_long.csv and answers_long.csv, with the status withdrawn; no result "
                    "uses them. Only where the participants agreed to that");
  add_planning(*command, *arguments);
  command->footer(
      "Examples: foveola analyze study.sqlite -o results\n"
      "          foveola analyze --power --protocol koskela2018 --ratio 70 --spread 1.8");
  command->callback([arguments] { run_analyze(*arguments); });
}

}  // namespace foveola::analysis
