#include <memory>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "renderer/base/text/print.h"
#include "renderer/base/work/work_scope.h"
#include "renderer/command_line/output_options.h"
#include "study/commands/command_line.h"
#include "study/commands/commands.h"
#include "study/participant/injected_effects/injected_effect.h"
#include "study/protocol/protocol.h"
#include "study/simulation/prepare_study.h"
#include "study/simulation/simulate_study.h"

namespace foveola::study {
namespace {

struct SimulateArguments {
  SimulateSettings settings{.warns = true};  ///< all except the options below
  std::string protocol;
  std::string database;
  std::string shard;   ///< empty: all participants
  std::string report;  ///< folder; empty: none
  bool prepare = false;
  bool json = false;
};

nlohmann::json json_report(const SimulateArguments& arguments, const SimulateReport& report) {
  return {{"database", arguments.database},
          {"seed", arguments.settings.seed},
          {"shard", arguments.shard.empty() ? nlohmann::json() : nlohmann::json(arguments.shard)},
          {"sessions_before", report.sessions_before},
          {"sessions_completed", report.sessions_completed},
          {"sessions_refused", report.sessions_refused},
          {"sessions_withdrawn", report.sessions_withdrawn},
          {"scale", arguments.settings.scale},
          {"predicted", arguments.settings.predicted},
          {"real_time", arguments.settings.real_time},
          {"injected", arguments.settings.injected},
          {"trials", report.trials},
          {"wall_seconds", report.wall_s},
          {"sessions_wall_seconds", report.sessions_wall_s},
          {"simulated_seconds", report.simulated_s},
          {"samples", report.samples},
          {"non_finite", report.non_finite}};
}

SimulateSettings settings_of(const SimulateArguments& arguments) {
  SimulateSettings settings = arguments.settings;
  settings.protocol = find_protocol(arguments.protocol);
  settings.database = arguments.database;
  if (!arguments.shard.empty()) {
    settings.shard = parse_shard("--shard", arguments.shard);
  }
  return settings;
}

/// Throws UsageError for options of sessions, of which there are none.
void require_only_preparing(const SimulateArguments& arguments) {
  if (!arguments.database.empty()) {
    throw UsageError("--db",
                     "cannot be combined with --prepare, which makes no study; remove one of them");
  }
  if (!arguments.report.empty()) {
    throw UsageError("--report",
                     "cannot be combined with --prepare, which makes no study; remove one of them");
  }
  if (arguments.settings.resume) {
    throw UsageError(
        "--resume", "is not needed: --prepare always renders only missing images; remove --resume");
  }
}

nlohmann::json json_report(const SimulateArguments& arguments, const PrepareReport& report) {
  return {{"prepared", arguments.settings.predicted ? "pilots" : "references"},
          {"seed", arguments.settings.seed},
          {"shard", arguments.shard.empty() ? nlohmann::json() : nlohmann::json(arguments.shard)},
          {"scale", arguments.settings.scale},
          {"items", report.items},
          {"rendered", report.rendered},
          {"stopped", report.stopped},
          {"wall_seconds", report.wall_s}};
}

std::string text_of(const SimulateArguments& arguments, const PrepareReport& report) {
  if (!report.simulates_viewing) {
    return "Nothing to prepare: participants with an injected effect do not look at pictures\n";
  }
  if (report.stopped) {
    return "Stopped. Finished items are kept. To continue, repeat the command.\n";
  }
  return fmt::format("{} of {} {} rendered in {}{}\n", report.rendered, report.items,
                     arguments.settings.predicted ? "pilots" : "references",
                     human_duration(report.wall_s),
                     report.rendered < report.items ? "; the others were in the cache" : "");
}

void run_prepare(const SimulateArguments& arguments, const SceneFinderBeside& find_scene,
                 const std::stop_token& stop) {
  require_only_preparing(arguments);
  const PrepareReport report = prepare_study(settings_of(arguments), find_scene, stop);
  if (arguments.json) {
    print_text("{}\n", json_report(arguments, report).dump(2));
  } else {
    print_text("{}", text_of(arguments, report));
  }
}

void run_simulate(const SimulateArguments& arguments, const SceneFinderBeside& find_scene,
                  const SimulationReporter& reporter, const std::stop_token& stop) {
  if (arguments.database.empty()) {
    throw UsageError("--db", "is required except with --prepare; name the study's file");
  }
  if (!arguments.report.empty()) {
    if (!arguments.shard.empty()) {
      throw UsageError("--report", "cannot be combined with --shard; remove one of them");
    }
    reporter.check(arguments.report);
  }
  const SimulateSettings settings = settings_of(arguments);
  const SimulateReport report = simulate_study(settings, find_scene, stop);
  const bool is_reported = !arguments.report.empty() && !stop.stop_requested();
  const std::string about_report =
      is_reported ? reporter.write(arguments.database, arguments.report) : "";
  if (arguments.json) {
    print_text("{}\n", json_report(arguments, report).dump(2));
    return;
  }
  print_text("{}: {} of {} simulated sessions completed, {} trials in {} ({} of {} time)\n",
             arguments.database, report.sessions_completed, settings.participants_in_file(),
             report.trials, human_duration(report.wall_s), human_duration(report.simulated_s),
             arguments.settings.real_time ? "real" : "virtual");
  if (report.sessions_before > 0) {
    print_text("{} sessions were finished before\n", report.sessions_before);
  }
  if (report.sessions_refused > 0) {
    print_text("{} refused, since the gaze was not tracked well enough for the protocol\n",
               report.sessions_refused);
  }
  if (report.sessions_withdrawn > 0) {
    print_text("{} participants withdrew\n", report.sessions_withdrawn);
  }
  if (stop.stop_requested()) {
    print_text("Stopped. To continue, repeat the command with --resume.\n");
  }
  print_text("{}", about_report);
}

}  // namespace

void add_simulate(CLI::App& study, const SceneFinderBeside& find_scene,
                  const SimulationReporter& reporter, const std::stop_token& stop) {
  const auto arguments = std::make_shared<SimulateArguments>();
  CLI::App* command = add_command(study, "simulate", "Run a study with simulated participants",
                                  "simulate demo --db study.sqlite --participants 4 --seed 7");
  add_protocol(command, arguments->protocol);
  command->add_option("--db", arguments->database,
                      "The study's database file: a new file, or a study of the "
                      "same protocol (required, except with --prepare)");
  add_participants_and_seed(command, arguments->settings.participants, arguments->settings.seed);
  add_threads_option(*command, arguments->settings.threads);
  command->add_option(
      "--shard", arguments->shard,
      "Simulate only the Kth of N parts of the participants, as K/N, in a file of its own: "
      "foveola study merge makes one study of all of them, as if they had been "
      "simulated together");
  command
      ->add_option("--jobs", arguments->settings.jobs,
                   "The number of concurrent sessions; with more than one, a session is written to "
                   "the disk at its end")
      ->check(CLI::Range(1, max_jobs));
  command->add_option(
      "--scale", arguments->settings.scale,
      "Divide the pixels and the samples per second by this, for speed: a pixel's noise at "
      "any second is unchanged");
  command->add_option("--samples-per-second", arguments->settings.samples_per_second,
                      "The machine's speed at full size, instead of the protocol's");
  command->add_flag("--predicted", arguments->settings.predicted,
                    "Instead of every frame, render only pilots of each object, and predict "
                    "from them what participants see: a thousand times faster");
  command->add_flag(
      "--real-time", arguments->settings.real_time,
      "Show the sessions in a real window, as for people: at this machine's speed, which --scale "
      "does not change");
  command->add_option(
      "--people", arguments->settings.people,
      "The simulated population: a name in data/participants, or a file of your own (default: "
      "adults)");
  command->add_option("--inject", arguments->settings.injected, injected_effect_help);
  mark_output(command->add_option(
      "--report", arguments->report,
      "A folder for every published number beside the study's, with differences and "
      "intervals"));
  command->add_flag("--resume", arguments->settings.resume,
                    "Resume the same command after it was stopped or killed");
  command->add_flag("--prepare", arguments->prepare,
                    "Simulate nobody, but render what the caches lack: the references, or "
                    "the pilots of --predicted. With --shard, the Kth part of these, so that many "
                    "machines fill a cache that they share");
  add_json_option(*command, arguments->json);
  command->callback([arguments, find_scene, reporter, stop] {
    if (arguments->prepare) {
      run_prepare(*arguments, find_scene, stop);
    } else {
      run_simulate(*arguments, find_scene, reporter, stop);
    }
  });
}

}  // namespace foveola::study
