#include "study/commands/record_commands.h"

#include <limits>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/gaze/recorded_eye_tracker.h"
#include "study/commands/command_line.h"
#include "study/commands/record_tables.h"
#include "study/record/recorded_gaze.h"
#include "study/record/study_records.h"

namespace foveola::study {
namespace {

struct Arguments {
  std::string database;
  std::string participant;
  int trial = 0;
  std::string output;
  bool json = false;
};

nlohmann::json json_status(const StudyRecords& records, const StudyStatus& status) {
  nlohmann::json sessions = nlohmann::json::array();
  for (const SessionRow& session : records.sessions) {
    sessions.push_back(
        {{"participant", session.participant}, {"kind", session.kind}, {"state", session.state}});
  }
  return {{"protocol", records.protocol_name},
          {"title", records.protocol_title},
          {"protocol_sha256", records.protocol_sha256},
          {"scenes", records.scenes},
          {"methods", records.methods},
          {"sessions", sessions},
          {"trials_planned", records.trials.size()},
          {"trials_done", status.trials_done}};
}

void run_status(const Arguments& arguments) {
  const StudyRecords records = read_study(arguments.database);
  const StudyStatus status = status_of(records);
  if (arguments.json) {
    fmt::print("{}\n", json_status(records, status).dump(2));
  } else {
    fmt::print("{}", status_table(records, status));
  }
}

void run_gaze(const Arguments& arguments) {
  const std::vector<GazeSample> samples = replayable(read_gaze(
      arguments.database, arguments.participant, static_cast<std::size_t>(arguments.trial)));
  write_gaze_file(arguments.output, samples);
  fmt::print("{}: {} samples\n", arguments.output, samples.size());
}

}  // namespace

void add_status(CLI::App& study) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      add_command(study, "status", "What a study's file holds", "status study.sqlite --json");
  add_database(command, arguments->database);
  add_json(command, arguments->json);
  command->callback([arguments] { run_status(*arguments); });
}

void add_gaze(CLI::App& study) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = add_command(study, "gaze", "Where a participant looked, to be replayed",
                                  "gaze study.sqlite --participant P001 --trial 0 -o gaze.csv");
  add_database(command, arguments->database);
  command->add_option("--participant", arguments->participant, "The code")->required();
  command->add_option("--trial", arguments->trial, "0 is the first; its last attempt is taken")
      ->check(CLI::Range(0, std::numeric_limits<int>::max()))
      ->required();
  command->add_option("-o,--output", arguments->output, "A recording: comma-separated values")
      ->required();
  command->callback([arguments] { run_gaze(*arguments); });
}

}  // namespace foveola::study
