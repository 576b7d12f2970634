#include "analysis/commands/commands.h"

#include <filesystem>
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "analysis/commands/power_command.h"
#include "analysis/dataset/wording.h"
#include "analysis/tables/table_formats.h"
#include "renderer/base/error.h"
#include "renderer/base/text/print.h"
#include "renderer/base/text/utf8.h"
#include "renderer/base/transformed.h"
#include "study/record/verify/verification_json.h"

namespace foveola::analysis {
namespace {

using json = nlohmann::ordered_json;

Table measures(const Dataset& set) {
  const ColumnsOf<Measure> columns = {
      {"id", "", "Id of the measure", &Measure::id},
      {"kind", "", "time, response or rating", &Measure::kind},
      {"unit", "", "Unit of the measure", &Measure::unit},
      {"text", "", "Question of the measure", path(&Measure::question, &study::Question::text)},
      {"scale", "", "Scale of the measure in words", study::scale_in_words}};
  return tabulate("measures", "measure", columns, set.measures);
}

/// Returns tables as JSON. Those of trials, answers and participants are in their files only.
json tables_of(const AnalysisOutput& output) {
  json tables = json::object();
  for (const Table& table : output.results) {
    if (!is_written_by_rows(table)) {
      tables[table.id] = json_of(table);
    }
  }
  return tables;
}

struct AnalyzeArguments {
  std::filesystem::path database;
  std::filesystem::path folder;
  bool json = false;
  AnalysisOptions options;
  PowerArguments power;
};

/// Returns the arguments of planning, including those shared with an analysis.
PowerArguments power_arguments(const AnalyzeArguments& arguments) {
  if (!arguments.folder.empty()) {
    throw UsageError("--output", "cannot be combined with --power, which writes no files",
                     "remove one of them");
  }
  PowerArguments power = arguments.power;
  power.pilot = arguments.database;
  power.json = arguments.json;
  power.r = arguments.options.fits_models;
  return power;
}

void run_analyze(const AnalyzeArguments& arguments, const std::stop_token& stop) {
  if (arguments.power.asked) {
    run_power(power_arguments(arguments), stop);
    return;
  }
  if (arguments.database.empty() || arguments.folder.empty()) {
    throw UsageError(arguments.database.empty() ? "STUDY" : "--output", "is required",
                     "see foveola analyze --help");
  }
  const AnalysisOutput output =
      analyze_study(arguments.database, arguments.folder, arguments.options);
  if (arguments.json) {
    print_text("{}\n", analysis_json(output));
    return;
  }
  print_text("{}\n", output.summary);
  for (const std::string& warning : output.warnings) {
    print_text("Note: {}\n", printable(warning));
  }
  print_text("Report: {}\n", output.report.string());
}

}  // namespace

// NOLINTNEXTLINE(performance-unnecessary-value-param): every module adds its commands alike.
void add_analysis_commands(CLI::App& app, std::stop_token stop) {
  const auto arguments = std::make_shared<AnalyzeArguments>();
  CLI::App* command =
      app.add_subcommand("analyze", "Write tables, figures and a report of a study");
  command->add_option("STUDY", arguments->database,
                      "The SQLite file of a study, written by study run or study simulate");
  command->add_option("-o,--output", arguments->folder,
                      "The folder to write the results to; made if its parent exists");
  command->add_flag("--json", arguments->json,
                    "Print the paths of the results and the main numbers as JSON");
  command->add_flag("--bids", arguments->options.writes_bids,
                    "Also write the behavioural data and the gaze in the BIDS layout, a folder per "
                    "participant");
  command->add_flag("--r", arguments->options.fits_models,
                    "Fit mixed, ordinal and Tobit models by R, and take the primary analyses from "
                    "them; seconds for times, up to a minute for each rating");
  command->add_flag("--unverified", arguments->options.unverified,
                    "Analyse a file even if it fails its verification; the "
                    "report then lists the faults");
  command->add_flag("--withdrawn", arguments->options.withdrawn,
                    "Also write the trials and answers of participants who withdrew to "
                    "trials_long.csv and answers_long.csv, with the status withdrawn; no result "
                    "uses them. Only with the consent of these participants");
  add_power_options(*command, arguments->power);
  command->footer(
      "Examples: foveola analyze study.sqlite -o results\n"
      "          foveola analyze --power --protocol koskela2018 --ratio 70 --spread 1.8");
  command->callback([arguments, stop] { run_analyze(*arguments, stop); });
}

std::string analysis_json(const AnalysisOutput& output) {
  const StudyTables& tables = output.tables;
  const std::string notice = data_notice(tables);
  const json files(transformed(
      output.files, [&](const std::filesystem::path& file) { return json(file.string()); }));
  const json result = {
      {"report", output.report.string()},
      {"files", files},
      {"warnings", output.warnings},
      {"protocol", tables.protocol_name},
      {"protocol_sha256", tables.protocol_sha256},
      {"participant_kind", tables.set.kind},
      {"data_notice", notice.empty() ? json(nullptr) : json(notice)},
      {"participants", tables.set.participants.size()},
      {"scenes", tables.set.scenes},
      {"methods", tables.set.methods},
      {"baseline", tables.set.methods.front()},
      {"measures", json_of(measures(tables.set))},
      {"tables", tables_of(output)},
      {"record", output.record ? study::verification_json(*output.record) : json(nullptr)},
      {"excluded", tables.set.exclusions.size()}};
  return result.dump(2, ' ', false, json::error_handler_t::replace);
}

}  // namespace foveola::analysis
