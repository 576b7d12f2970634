#include "study/commands/commands.h"

#include <limits>
#include <memory>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "renderer/base/progress.h"
#include "renderer/gaze/recorded_eye_tracker.h"
#include "study/commands/participant_code.h"
#include "study/commands/simulate_study.h"
#include "study/commands/tables.h"
#include "study/design/plan.h"
#include "study/protocol/protocol.h"
#include "study/record/recorded_gaze.h"
#include "study/record/study_records.h"

namespace foveola::study {
namespace {

/// The command lines of `study`, as typed.
struct StudyArguments {
  std::string protocol;
  std::string database;
  std::string participant;
  int trial = 0;
  std::string output;
  int participants = 0;
  std::uint64_t seed = 0;
  int threads = 0;
  bool json = false;
};

constexpr int most_participants = 100'000;
constexpr int most_threads = 1024;

using Arguments = std::shared_ptr<StudyArguments>;

CLI::App* add_command(CLI::App& study, const std::string& name, const std::string& purpose,
                      const std::string& example) {
  CLI::App* command = study.add_subcommand(name, purpose);
  command->footer("Example: foveola study " + example);
  return command;
}

void add_protocol(CLI::App* command, const Arguments& arguments) {
  command
      ->add_option("PROTOCOL", arguments->protocol,
                   "A .toml file, or the name of one that comes "
                   "with Foveola")
      ->required();
}

void add_participants_and_seed(CLI::App* command, const Arguments& arguments) {
  command->add_option("--participants", arguments->participants, "How many take part")
      ->check(CLI::Range(1, most_participants))
      ->required();
  command->add_option("--seed", arguments->seed, "Another seed gives other orders and people")
      ->capture_default_str();
}

void add_json(CLI::App* command, const Arguments& arguments) {
  command->add_flag("--json", arguments->json, "Print the result as JSON");
}

nlohmann::json json_profiles(const Protocol& protocol) {
  nlohmann::json names = nlohmann::json::object();
  for (const NamedProfile& profile : named_profiles(protocol)) {
    names[profile.device] = profile.name;
  }
  return names;
}

void run_check(const StudyArguments& arguments, const SceneFinder& find_scene) {
  const Protocol protocol = load_protocol(find_protocol(arguments.protocol));
  const std::vector<SceneSource> scenes = find_scenes(protocol, find_scene);
  if (arguments.json) {
    nlohmann::json names = nlohmann::json::array();
    for (const SceneEntry& scene : protocol.scenes) {
      names.push_back(scene.name);
    }
    nlohmann::json files = nlohmann::json::array();
    for (const MethodFile& file : protocol.method_files) {
      files.push_back({{"method", file.method}, {"file", file.file}, {"sha256", file.sha256}});
    }
    const nlohmann::json json = {
        {"protocol", protocol.path.string()},
        {"name", protocol.name},
        {"title", protocol.title},
        {"sha256", protocol.sha256},
        {"scenes", names},
        {"methods", protocol.methods},
        {"method_files", files},
        {"profiles", json_profiles(protocol)},
        {"trials_per_participant", scenes.size() * protocol.methods.size()},
        {"background_questions", protocol.background.size()}};
    fmt::print("{}\n", json.dump(2));
  } else {
    fmt::print("{}", protocol_table(protocol, scenes));
  }
}

nlohmann::json json_plan(int participant, const Plan& plan) {
  nlohmann::json trials = nlohmann::json::array();
  for (const PlannedTrial& trial : plan) {
    trials.push_back({{"scene", trial.scene}, {"method", trial.method}});
  }
  return {{"participant", participant_code(participant)}, {"trials", trials}};
}

void run_plan(const StudyArguments& arguments) {
  const Protocol protocol = load_protocol(find_protocol(arguments.protocol));
  std::vector<Plan> plans;
  for (int i = 0; i < arguments.participants; ++i) {
    plans.push_back(random_plan(protocol, arguments.seed, i));
  }
  if (arguments.json) {
    nlohmann::json list = nlohmann::json::array();
    for (int i = 0; i < arguments.participants; ++i) {
      list.push_back(json_plan(i, plans[i]));
    }
    fmt::print("{}\n", list.dump(2));
  } else {
    fmt::print("{}", plan_table(plans));
  }
}

nlohmann::json json_report(const StudyArguments& arguments, const SimulateReport& report) {
  return {{"database", arguments.database},
          {"seed", arguments.seed},
          {"sessions_completed", report.sessions_completed},
          {"sessions_refused", report.sessions_refused},
          {"trials", report.trials},
          {"wall_seconds", report.wall_s},
          {"simulated_seconds", report.simulated_s},
          {"samples", report.samples},
          {"non_finite", report.non_finite}};
}

void run_simulate(const StudyArguments& arguments, const SceneFinder& find_scene,
                  const std::stop_token& stop) {
  const SimulateReport report = simulate_study({.protocol = find_protocol(arguments.protocol),
                                                .database = arguments.database,
                                                .participants = arguments.participants,
                                                .seed = arguments.seed,
                                                .threads = arguments.threads},
                                               find_scene, stop);
  if (arguments.json) {
    fmt::print("{}\n", json_report(arguments, report).dump(2));
    return;
  }
  fmt::print("{}: {} of {} simulated sessions completed, {} trials in {} ({} of virtual time)\n",
             arguments.database, report.sessions_completed, arguments.participants, report.trials,
             human_duration(report.wall_s), human_duration(report.simulated_s));
  if (report.sessions_refused > 0) {
    fmt::print("{} refused: the tracker did not see the gaze well enough for the protocol\n",
               report.sessions_refused);
  }
}

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

void run_status(const StudyArguments& arguments) {
  const StudyRecords records = read_study(arguments.database);
  const StudyStatus status = status_of(records);
  if (arguments.json) {
    fmt::print("{}\n", json_status(records, status).dump(2));
  } else {
    fmt::print("{}", status_table(records, status));
  }
}

void run_gaze(const StudyArguments& arguments) {
  const std::vector<GazeSample> samples = replayable(read_gaze(
      arguments.database, arguments.participant, static_cast<std::size_t>(arguments.trial)));
  write_gaze_file(arguments.output, samples);
  fmt::print("{}: {} samples\n", arguments.output, samples.size());
}

void add_check(CLI::App& study, const SceneFinder& find_scene) {
  const auto arguments = std::make_shared<StudyArguments>();
  CLI::App* command =
      add_command(study, "check", "Whether a protocol and its scenes are sound", "check demo");
  add_protocol(command, arguments);
  add_json(command, arguments);
  command->callback([arguments, find_scene] { run_check(*arguments, find_scene); });
}

void add_plan(CLI::App& study) {
  const auto arguments = std::make_shared<StudyArguments>();
  CLI::App* command = add_command(study, "plan", "The order in which each participant sees things",
                                  "plan demo --participants 16 --seed 7");
  add_protocol(command, arguments);
  add_participants_and_seed(command, arguments);
  add_json(command, arguments);
  command->callback([arguments] { run_plan(*arguments); });
}

void add_simulate(CLI::App& study, const SceneFinder& find_scene, const std::stop_token& stop) {
  const auto arguments = std::make_shared<StudyArguments>();
  CLI::App* command = add_command(study, "simulate", "Run a study with simulated participants",
                                  "simulate demo --db study.sqlite --participants 4 --seed 7");
  add_protocol(command, arguments);
  command
      ->add_option("--db", arguments->database,
                   "The study's file; made, or added to if it is of the same protocol")
      ->required();
  add_participants_and_seed(command, arguments);
  command->add_option("--threads", arguments->threads, "0: every core")
      ->check(CLI::Range(0, most_threads))
      ->capture_default_str();
  add_json(command, arguments);
  command->callback([arguments, find_scene, stop] { run_simulate(*arguments, find_scene, stop); });
}

void add_status(CLI::App& study) {
  const auto arguments = std::make_shared<StudyArguments>();
  CLI::App* command =
      add_command(study, "status", "What a study's file holds", "status study.sqlite --json");
  command->add_option("DB", arguments->database, "The study's file")->required();
  add_json(command, arguments);
  command->callback([arguments] { run_status(*arguments); });
}

void add_gaze(CLI::App& study) {
  const auto arguments = std::make_shared<StudyArguments>();
  CLI::App* command = add_command(study, "gaze", "Where a participant looked, to be replayed",
                                  "gaze study.sqlite --participant P001 --trial 0 -o gaze.csv");
  command->add_option("DB", arguments->database, "The study's file")->required();
  command->add_option("--participant", arguments->participant, "The code")->required();
  command->add_option("--trial", arguments->trial, "0 is the first; its last attempt is taken")
      ->check(CLI::Range(0, std::numeric_limits<int>::max()))
      ->required();
  command->add_option("-o,--output", arguments->output, "A recording: comma-separated values")
      ->required();
  command->callback([arguments] { run_gaze(*arguments); });
}

}  // namespace

void add_study_commands(CLI::App& app, const SceneFinder& find_scene, std::stop_token stop) {
  CLI::App* study = app.add_subcommand("study", "Plan, run and look into user studies");
  study->require_subcommand(1);
  add_check(*study, find_scene);
  add_plan(*study);
  add_simulate(*study, find_scene, stop);
  add_status(*study);
  add_gaze(*study);
}

}  // namespace foveola::study
