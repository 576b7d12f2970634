#include <algorithm>
#include <limits>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "renderer/base/text/print.h"
#include "renderer/base/transformed.h"
#include "study/commands/command_line.h"
#include "study/commands/commands.h"
#include "study/replay/replay.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

struct ReplayArguments {
  std::string database;
  std::string participant;
  std::optional<std::size_t> trial;
  std::optional<int> attempt;
  std::string folder;
  std::string output;
  int threads = 0;
  bool json = false;
};

std::string verdict(const ReplayedAttempt& attempt, bool is_approximate) {
  if (attempt.frames == 0) {
    return "no frame was recorded";
  }
  if (attempt.hashes == 0) {
    return "no film was compared";
  }
  if (!attempt.first_difference) {
    return "bit-identical";
  }
  return fmt::format("{} from frame {} at the latest",
                     is_approximate ? "similar, but not bit-identical," : "differs",
                     *attempt.first_difference);
}

std::string line_of(const ReplayedAttempt& attempt, bool is_approximate) {
  return fmt::format(
      "trial {} ({}, {}{}), attempt {}: {} frames, {} samples: {}\n", attempt.trial,
      attempt.planned.scene, attempt.planned.method,
      attempt.planned.kind == TrialKind::test ? ""
                                              : fmt::format(", {}", name_of(attempt.planned.kind)),
      attempt.attempt, attempt.frames, attempt.samples, verdict(attempt, is_approximate));
}

nlohmann::json json_of(const ReplayedAttempt& attempt) {
  nlohmann::json json = {{"trial", attempt.trial},
                         {"attempt", attempt.attempt},
                         {"kind", name_of(attempt.planned.kind)},
                         {"scene", attempt.planned.scene},
                         {"method", attempt.planned.method},
                         {"frames", attempt.frames},
                         {"samples", attempt.samples},
                         {"films_compared", attempt.hashes},
                         {"first_difference", nullptr}};
  if (attempt.first_difference) {
    json["first_difference"] = *attempt.first_difference;
  }
  return json;
}

void print_json(const ReplayReport& report) {
  const nlohmann::json attempts(transformed(
      report.attempts, [&](const ReplayedAttempt& attempt) { return json_of(attempt); }));
  nlohmann::json json = {{"attempts", attempts}, {"approximate", report.approximate}};
  if (!report.difference.empty()) {
    json["difference"] = report.difference;
  }
  print_text("{}\n", json.dump(2));
}

void print_lines(const ReplayReport& report) {
  const bool is_approximate = !report.approximate.empty();
  if (is_approximate) {
    print_text("Approximate: {}.\n", report.approximate);
  }
  for (const ReplayedAttempt& attempt : report.attempts) {
    print_text("{}", line_of(attempt, is_approximate));
  }
}

/// A session's steps after its recorded answers depend on neither the program's build nor the
/// processor.
void require_same_events(const ReplayReport& report, const std::string& database) {
  if (!report.difference.empty()) {
    throw Error(database, report.difference, "check the record with foveola study verify");
  }
}

/// The same program on the same processor must show the same film.
void require_same_films(const ReplayReport& report, const std::string& database) {
  const auto differing = std::ranges::count_if(report.attempts, [](const ReplayedAttempt& attempt) {
    return attempt.first_difference.has_value();
  });
  if (differing > 0 && report.approximate.empty()) {
    throw Error(database,
                fmt::format("{} of {} replayed attempts differ from the recorded films", differing,
                            report.attempts.size()),
                "check the record with foveola study verify");
  }
}

void run_replay(const ReplayArguments& arguments, const SceneFinderBeside& find_scene,
                const std::stop_token& stop) {
  if (!arguments.output.empty()) {
    fs::create_directories(arguments.output);
  }
  const fs::path beside = fs::absolute(arguments.database).parent_path();
  const ReplayReport report =
      replay_session({.database = arguments.database,
                      .participant = arguments.participant,
                      .trial = arguments.trial,
                      .attempt = arguments.attempt,
                      .folder = arguments.folder.empty() ? beside : fs::path(arguments.folder),
                      .pictures = arguments.output,
                      .threads = arguments.threads},
                     find_scene, stop);
  if (arguments.json) {
    print_json(report);
  } else {
    print_lines(report);
  }
  require_same_events(report, arguments.database);
  require_same_films(report, arguments.database);
}

}  // namespace

void add_replay(CLI::App& study, const SceneFinderBeside& find_scene, const std::stop_token& stop) {
  const auto arguments = std::make_shared<ReplayArguments>();
  CLI::App* command = add_command(
      study, "replay",
      "Replay a recorded session, and compare its events and films with the recorded ones",
      "replay study.sqlite --participant P001 --trial 0 -o pictures");
  add_database(command, arguments->database);
  command->add_option("--participant", arguments->participant, "The participant's code")
      ->required();
  command->add_option("--trial", arguments->trial, "Only this trial, counted from 0 (default: all)")
      ->check(CLI::Range(0, std::numeric_limits<int>::max()));
  command
      ->add_option("--attempt", arguments->attempt,
                   "Only this attempt at each trial, counted from 1 (default: all)")
      ->check(CLI::Range(1, std::numeric_limits<int>::max()));
  command->add_option(
      "--folder", arguments->folder,
      "The folder of the files that the protocol names (default: the database's folder)");
  command->add_option("-o,--output", arguments->output,
                      "A folder for a picture of each attempt's last view");
  add_threads_option(*command, arguments->threads);
  add_json_option(*command, arguments->json);
  command->callback([arguments, find_scene, stop] { run_replay(*arguments, find_scene, stop); });
}

}  // namespace foveola::study
