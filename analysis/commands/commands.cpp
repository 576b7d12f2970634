#include "analysis/commands/commands.h"

#include <filesystem>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "analysis/commands/analysis_json.h"
#include "analysis/publication/analyze_study.h"

namespace foveola::analysis {
namespace {

struct AnalyzeArguments {
  std::filesystem::path database;
  std::filesystem::path folder;
  bool json = false;
};

void run_analyze(const AnalyzeArguments& arguments) {
  const AnalysisOutput output = analyze_study(arguments.database, arguments.folder);
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

}  // namespace

// NOLINTNEXTLINE(performance-unnecessary-value-param): every room adds its commands alike.
void add_analysis_commands(CLI::App& app, std::stop_token /*stop*/) {
  const auto arguments = std::make_shared<AnalyzeArguments>();
  CLI::App* command =
      app.add_subcommand("analyze", "Tables, figures and a report from a study's file");
  command->add_option("STUDY", arguments->database, "A study's .sqlite file")->required();
  command
      ->add_option("-o,--output", arguments->folder,
                   "A folder for the results; made if its parent exists")
      ->required();
  command->add_flag("--json", arguments->json, "Print paths and main numbers as JSON");
  command->footer("Example: foveola analyze study.sqlite -o results");
  command->callback([arguments] { run_analyze(*arguments); });
}

}  // namespace foveola::analysis
