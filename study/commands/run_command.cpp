#include <algorithm>
#include <cctype>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "renderer/base/text/print.h"
#include "renderer/command_line/output_options.h"
#include "renderer/commands/arguments.h"
#include "renderer/commands/gaze_filter_option.h"
#include "renderer/commands/headset_option.h"
#include "study/commands/command_line.h"
#include "study/commands/commands.h"
#include "study/console/line_console.h"
#include "study/person/run_person.h"
#include "study/tables/session_summary.h"

namespace foveola::study {
namespace {

constexpr int monitor_limit = 100;
constexpr int row_limit = 1'000'000;
constexpr std::size_t longest_code = 32;

struct RunArguments {
  RunSettings settings;  ///< all except the options below
  std::string protocol;
  std::string database;
  bool is_pilot = false;
  std::optional<std::string> gaze_filter;
  std::string window = "1280x720";
  bool full_screen = false;
  int monitor = 0;
  bool takes_amendment = false;
  std::string screens;
  std::string receipt;
  std::string backup_folder;
};

void require_code(const std::string& code) {
  const bool is_code =
      !code.empty() && code.size() <= longest_code &&
      std::ranges::all_of(code, [](unsigned char character) {
        return std::isalnum(character) != 0 || character == '-' || character == '_';
      });
  if (!is_code) {
    throw UsageError(
        "--participant", fmt::format("'{}' is not a code", code),
        fmt::format("write up to {} letters, digits, - and _, but never a name", longest_code));
  }
}

/// Sessions that count use the protocol's filter, the same for all of them.
std::optional<GazeFilterSettings> gaze_filter_of(const RunArguments& arguments) {
  if (!arguments.gaze_filter) {
    return std::nullopt;
  }
  if (!arguments.is_pilot) {
    throw UsageError(
        "--gaze-filter",
        "cannot be set for a session that counts, which uses its protocol's filter",
        "write the filter into the protocol's [tracker.filter], or rehearse with --pilot");
  }
  return parse_gaze_filter(*arguments.gaze_filter);
}

void run_run(const RunArguments& arguments, const SceneFinderBeside& find_scene,
             const std::stop_token& stop) {
  require_code(arguments.settings.participant);
  RunSettings settings = arguments.settings;
  settings.protocol = find_protocol(arguments.protocol);
  settings.database = arguments.database;
  settings.kind = arguments.is_pilot ? SessionKind::pilot : SessionKind::human;
  settings.gaze_filter = gaze_filter_of(arguments);
  settings.window = parse_size("--window", arguments.window);
  settings.other_protocol =
      arguments.takes_amendment ? OtherProtocol::take_as_amendment : OtherProtocol::refuse;
  if (arguments.full_screen) {
    settings.monitor = arguments.monitor;
  }
  if (!arguments.screens.empty()) {
    settings.screens = arguments.screens;
    std::filesystem::create_directories(arguments.screens);
  }
  if (!arguments.receipt.empty()) {
    require_writable(arguments.receipt);
    if (std::filesystem::exists(arguments.receipt) && !arguments.settings.resumes) {
      throw Error(arguments.receipt, "exists already", "name another file for this receipt");
    }
    settings.receipt = arguments.receipt;
  }
  if (!arguments.backup_folder.empty()) {
    require_backup_target(arguments.backup_folder, arguments.database);
    settings.backup_folder = arguments.backup_folder;
  }
  const RunReport report = run_person(settings, find_scene, stop);
  if (arguments.settings.json) {
    print_text("{}\n", json_line("end", {{"participant", arguments.settings.participant},
                                         {"phase", name_of(report.phase)},
                                         {"backup", report.backup.string()},
                                         {"copy", report.copy.string()}}));
    return;
  }
  if (!report.is_blind || report.phase != Phase::interrupted) {
    print_text("{}", session_summary(arguments.database, arguments.settings.participant));
  }
  print_text("{}: {} {}; backup {}{}\n", arguments.database, arguments.settings.participant,
             name_of(report.phase), report.backup.string(),
             report.copy.empty() ? "" : fmt::format("; copy {}", report.copy.string()));
  if (report.phase == Phase::interrupted) {
    print_text("To continue, repeat the command with --resume.\n");
  }
}

}  // namespace

void add_run(CLI::App& study, const SceneFinderBeside& find_scene, const std::stop_token& stop) {
  const auto arguments = std::make_shared<RunArguments>();
  CLI::App* command =
      add_command(study, "run", "Run one person's session in a window, from consent to debrief",
                  "run koskela2018 --db study.sqlite --participant P07 --headset");
  add_protocol(command, arguments->protocol);
  command
      ->add_option("--db", arguments->database,
                   "The study's database file: a new file, or a study of the same protocol")
      ->required();
  command
      ->add_option("--participant", arguments->settings.participant,
                   "The participant's code (letters, digits, - and _), never a name")
      ->required();
  command->add_flag(
      "--pilot", arguments->is_pilot,
      "A rehearsal: its session is kept apart and not analysed, and a scene is reloaded "
      "when its file changes");
  command->add_option(
      "--display", arguments->settings.display,
      "The display's profile: a name or a file (default: the protocol's, or desktop)");
  command->add_option("--tracker", arguments->settings.tracker,
                      "The eye tracker's profile: a name or a file; pointer uses the mouse in "
                      "place of an eye (default: the "
                      "protocol's, or pointer)");
  add_headset_option(*command, arguments->settings.display, arguments->settings.tracker);
  command->add_option("--gaze-filter", arguments->gaze_filter,
                      std::string("The filter of a pilot's gaze (default: "
                                  "the protocol's): ") +
                          gaze_filter_notation);
  command->add_option("--window", arguments->window, "The window's size, WIDTHxHEIGHT");
  CLI::Option* full_screen = command->add_flag("--full-screen", arguments->full_screen,
                                               "Fill a monitor instead of a window");
  command->add_option("--monitor", arguments->monitor, "The monitor to fill, counted from 0")
      ->check(CLI::Range(0, monitor_limit))
      ->needs(full_screen);
  command->add_option("--seed", arguments->settings.seed,
                      "The seed of orders and noise (default: drawn at random, and recorded)");
  command
      ->add_option("--first-row", arguments->settings.first_row,
                   "The row of the design of the file's first participant, so that sites "
                   "begin with different rows; later participants get the next ones (default: 0)")
      ->check(CLI::Range(0, row_limit));
  add_threads_option(*command, arguments->settings.threads);
  CLI::Option* resume = command->add_flag("--resume", arguments->settings.resumes,
                                          "Resume this participant's unfinished session");
  command
      ->add_flag("--undo-end", arguments->settings.undo_end,
                 "Undo the withdrawal or exclusion that ended it, and resume")
      ->needs(resume);
  command->add_flag(
      "--despite-changes", arguments->settings.accept_changes,
      "Accept another program, scene, display, machine or tracker than those of the session "
      "or of the study's other sessions; the session's record notes it");
  command->add_flag("--amended-protocol", arguments->takes_amendment,
                    "Accept a protocol whose texts or time-outs have changed since the study "
                    "began; the session's "
                    "record notes it");
  command->add_flag("--blind", arguments->settings.is_blind,
                    "Hide the methods from the experimenter until the session is over; the "
                    "session's record notes it");
  mark_output(
      command->add_option("--screens", arguments->screens,
                          "A folder for a picture of every page that the participant comes to"));
  mark_output(command->add_option(
      "--receipt", arguments->receipt,
      "A file for a receipt of the participant's consents, with their texts and times, "
      "to take along"));
  mark_output(command->add_option("--backup-to", arguments->backup_folder,
                                  "A folder, preferably on another disk, for a copy of the study "
                                  "after the session, in addition to the backup"));
  command->add_flag("--json", arguments->settings.json,
                    "The experimenter's console for machines: a JSON object per line, with the "
                    "session's status every second");
  command->callback([arguments, find_scene, stop] { run_run(*arguments, find_scene, stop); });
}

}  // namespace foveola::study
