#include <algorithm>
#include <cctype>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "renderer/base/text/print.h"
#include "renderer/base/transformed.h"
#include "renderer/command_line/output_options.h"
#include "renderer/gaze/recordings.h"
#include "study/commands/command_line.h"
#include "study/commands/commands.h"
#include "study/record/maintain/maintenance.h"
#include "study/record/read/recorded_gaze.h"
#include "study/record/read/study_records.h"
#include "study/record/setup/study_head.h"
#include "study/record/sqlite/damage_remedy.h"
#include "study/record/verify/verification_json.h"
#include "study/tables/session_summary.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

struct RecordArguments {
  std::string database;
  std::vector<std::string> sources;
  std::vector<std::string> sites;
  std::string participant;
  int trial = 0;
  std::string output;
  std::string head;
  std::string folder;
  std::string copy;
  bool incomplete = false;
  bool yes = false;
  bool json = false;
};

nlohmann::json json_kind(const KindStatus& kind) {
  nlohmann::json rows = nlohmann::json::object();
  for (const auto& [row, count] : kind.design_rows) {
    rows[std::to_string(row)] = count;
  }
  return {{"sessions", kind.sessions},
          {"design_rows", rows},
          {"method_positions", kind.method_positions}};
}

std::string line_of(const SessionHead& session) {
  return fmt::format("{} {} {}", session.uuid, session.events, session.last_hash);
}

nlohmann::json json_amended(const std::vector<AmendedSession>& amended) {
  nlohmann::json list = nlohmann::json::array();
  for (const auto& [participant, amendment] : amended) {
    list.push_back({{"participant", participant},
                    {"protocol_sha256", amendment.sha256},
                    {"changed", amendment.changed}});
  }
  return list;
}

nlohmann::json json_programs(const std::vector<SessionPrograms>& sessions) {
  return transformed(program_uses(sessions), [&](const ProgramUse& use) {
    return nlohmann::json{{"program", use.program}, {"participants", use.participants}};
  });
}

nlohmann::json json_status(const StudyRecords& records, const StudyStatus& status) {
  const nlohmann::json sessions(transformed(records.sessions, [&](const SessionRow& session) {
    return nlohmann::json{
        {"participant", session.participant},
        {"kind", session.kind},
        {"state", session.state},
        {"design_row", session.design_row ? nlohmann::json(*session.design_row) : nlohmann::json()},
        {"reason", session.reason}};
  }));
  nlohmann::json kinds = nlohmann::json::object();
  for (const auto& [name, kind] : status.kinds) {
    kinds[name] = json_kind(kind);
  }
  return {{"protocol", records.protocol.name},
          {"title", records.protocol.title},
          {"protocol_sha256", records.protocol.sha256},
          {"scenes", records.scenes},
          {"methods", records.methods},
          {"sessions", sessions},
          {"programs", json_programs(records.programs)},
          {"amended", json_amended(records.amended)},
          {"kinds", kinds},
          {"trials_planned", records.trials.size()},
          {"trials_done", status.trials_done}};
}

nlohmann::json json_head(const StudyHead& head) {
  nlohmann::json sessions = nlohmann::json::array();
  for (const SessionHead& session : head.sessions) {
    // Printed at once, so that any form of the printout is a head.
    sessions.push_back(line_of(session));
  }
  const nlohmann::json forgotten(transformed(
      head.forgotten, [&](const SessionHead& tombstone) { return line_of(tombstone); }));
  return {{"sha256", head.sha256}, {"sessions", sessions}, {"forgotten", forgotten}};
}

/// Returns a head to print or copy elsewhere, for study verify --head.
std::string head_text(const StudyHead& head) {
  std::string text = fmt::format("head      {}\n", head.sha256);
  for (const SessionHead& session : head.sessions) {
    text += fmt::format("session   {}\n", line_of(session));
  }
  for (const SessionHead& tombstone : head.forgotten) {
    text += fmt::format("forgotten {}\n", line_of(tombstone));
  }
  return text;
}

void run_status(const RecordArguments& arguments) {
  const StudyRecords records = read_study(arguments.database);
  const StudyStatus status = status_of(records);
  const StudyHead head = read_head(arguments.database);
  if (arguments.json) {
    nlohmann::json json = json_status(records, status);
    json["head"] = json_head(head);
    print_text("{}\n", json.dump(2));
  } else {
    print_text("{}{}", status_table(records, status), head_text(head));
  }
}

void add_head_comparison(const RecordArguments& arguments, Verification& found) {
  constexpr std::size_t max_bytes = 16 << 20;
  constexpr const char* remedy = "name a file with the output of foveola study status";
  const std::vector<SessionHead> earlier = heads_in(read_file(arguments.head, max_bytes, remedy));
  if (earlier.empty()) {
    throw Error(arguments.head, "has no line of a session", remedy);
  }
  HeadComparison comparison = compare_with_head(arguments.database, earlier);
  for (std::string& fault : comparison.faults) {
    found.faults.push_back({"", std::move(fault)});
  }
  for (std::string& forgotten : comparison.forgotten) {
    found.warnings.push_back({"", std::move(forgotten)});
  }
}

void run_verify(const RecordArguments& arguments) {
  Verification found = verify_study(arguments.database);
  if (!arguments.head.empty()) {
    add_head_comparison(arguments, found);
  }
  if (arguments.json) {
    print_text("{}\n", verification_json(found).dump(2));
  } else {
    print_text("{}", verification_table(found));
  }
  if (!found.faults.empty()) {
    throw Error(arguments.database, "failed its verification: see the faults above", damage_remedy);
  }
}

void run_backup(const RecordArguments& arguments) {
  if (arguments.folder.empty()) {
    print_text("{}\n", back_up_study(arguments.database).string());
    return;
  }
  require_backup_target(arguments.folder, arguments.database);
  print_text("{}\n", back_up_study_to(arguments.folder, arguments.database).string());
}

void run_restore(const RecordArguments& arguments) {
  const Restored restored = restore_study(
      arguments.database,
      arguments.copy.empty() ? std::nullopt : std::optional<fs::path>(arguments.copy));
  print_text("{}: restored from {}\n", arguments.database, restored.copy.string());
  for (const fs::path& file : restored.moved_aside) {
    print_text("{}: the former file\n", file.string());
  }
  if (!restored.missing && !restored.moved_aside.empty()) {
    print_text("The copy may lack events: the former file cannot be read.\n");
  }
  for (const MissingEvents& session : restored.missing.value_or(std::vector<MissingEvents>{})) {
    print_text("missing in the copy: {} of {} events of {}\n", session.missing, session.events,
               session.participant);
  }
  if (restored.missing && restored.missing->empty()) {
    print_text("The copy has all events of the former file.\n");
  }
}

void require_sites(const RecordArguments& arguments) {
  if (!arguments.sites.empty() && arguments.sites.size() != arguments.sources.size()) {
    throw UsageError(
        "--site",
        fmt::format("names {} sites of {} files", arguments.sites.size(), arguments.sources.size()),
        "give --site once per file, in their order");
  }
  for (const std::string& site : arguments.sites) {
    const bool is_name = !site.empty() && std::ranges::all_of(site, [](unsigned char letter) {
      return std::isalnum(letter) != 0;
    });
    if (!is_name) {
      throw UsageError("--site", fmt::format("'{}' is not a site name", site),
                       "use letters and digits only");
    }
  }
}

void run_merge(const RecordArguments& arguments) {
  require_sites(arguments);
  const Merge merge =
      merge_studies({arguments.sources.begin(), arguments.sources.end()}, arguments.output,
                    {.sites = arguments.sites,
                     .missing = arguments.incomplete ? MissingParts::note : MissingParts::refuse});
  print_text("{}: {} sessions, {} of them in several files{}\n", arguments.output,
             merge.sessions_added, merge.known.size(),
             merge.known.empty() ? "" : fmt::format(": {}", fmt::join(merge.known, ", ")));
  if (!merge.missing.empty()) {
    print_text("missing, and noted in the file: {}\n", fmt::join(merge.missing, ", "));
  }
  if (merge.sessions_forgotten > 0) {
    print_text(
        "{} sessions are left out: their participants were forgotten in another of the files\n",
        merge.sessions_forgotten);
  }
}

void run_forget(const RecordArguments& arguments) {
  if (!arguments.yes) {
    throw UsageError(
        "--yes",
        fmt::format("is required to erase all data of participant {1} from {0} and its backups "
                    "permanently",
                    arguments.database, arguments.participant),
        "add --yes to confirm");
  }
  const Forgotten forgotten = forget_participant(arguments.database, arguments.participant);
  print_text("{}: participant {} was erased from {} files\n", arguments.database,
             arguments.participant, forgotten.files);
  print_text(
      "The disk may hold deleted data until it is overwritten, and so may its "
      "snapshots and other backups of this computer.\n");
  for (const std::string& mention : forgotten.mentions) {
    print_text(
        "{}: {} contains the code {} in a typed text, which stays because later hashes cover it\n",
        arguments.database, mention, arguments.participant);
  }
  for (const RemainingCopy& copy : forgotten.remaining) {
    print_text("{}: {}\n", copy.file.string(), copy.what);
  }
  if (!forgotten.remaining.empty()) {
    throw Error(arguments.database,
                fmt::format("{} files still hold data of {}, or cannot be read",
                            forgotten.remaining.size(), arguments.participant),
                "inspect the files above, remove those of this study, and repeat the command");
  }
}

void run_gaze(const RecordArguments& arguments) {
  const std::vector<GazeSample> samples = replayable(read_gaze(
      arguments.database, arguments.participant, static_cast<std::size_t>(arguments.trial)));
  write_gaze_file(arguments.output, samples);
  print_text("{}: {} samples\n", arguments.output, samples.size());
}

}  // namespace

void add_status(CLI::App& study) {
  const auto arguments = std::make_shared<RecordArguments>();
  CLI::App* command =
      add_command(study, "status", "List the sessions of a study's file and their progress",
                  "status study.sqlite --json");
  add_database(command, arguments->database);
  add_json_option(*command, arguments->json);
  command->callback([arguments] { run_status(*arguments); });
}

void add_verify(CLI::App& study) {
  const auto arguments = std::make_shared<RecordArguments>();
  CLI::App* command = add_command(
      study, "verify", "Check that a study's file is complete, and unchanged since it was written",
      "verify study.sqlite");
  add_database(command, arguments->database);
  command->add_option(
      "--head", arguments->head,
      "A file with an earlier output of study status: the study must continue from it");
  add_json_option(*command, arguments->json);
  command->callback([arguments] { run_verify(*arguments); });
}

void add_backup(CLI::App& study) {
  const auto arguments = std::make_shared<RecordArguments>();
  CLI::App* command =
      add_command(study, "backup",
                  "Copy a study's file into the folder of backups beside it, and check the copy",
                  "backup study.sqlite --to /media/backups");
  add_database(command, arguments->database);
  mark_output(command->add_option("--to", arguments->folder,
                                  "A folder, best on another disk, that gets the copy instead"));
  command->callback([arguments] { run_backup(*arguments); });
}

void add_restore(CLI::App& study) {
  const auto arguments = std::make_shared<RecordArguments>();
  CLI::App* command = add_command(
      study, "restore",
      "Replace a damaged or missing study's file by a copy; the damaged file is renamed",
      "restore study.sqlite --from /media/backups/study.sqlite");
  add_database(command, arguments->database);
  command->add_option("--from", arguments->copy,
                      "The copy (default: the newest undamaged backup beside the study)");
  command->callback([arguments] { run_restore(*arguments); });
}

void add_merge(CLI::App& study) {
  const auto arguments = std::make_shared<RecordArguments>();
  CLI::App* command = add_command(study, "merge", "Merge the files of several sites into one study",
                                  "merge helsinki.sqlite tampere.sqlite -o study.sqlite");
  command
      ->add_option("DB", arguments->sources,
                   "The sites' database files, all of the same protocol; a session that several of "
                   "them hold is taken once and named, or refused if its copies differ")
      ->required()
      ->expected(1, -1);
  command
      ->add_option("--site", arguments->sites,
                   "A site's name, once for each file in their order: participants then are "
                   "SITE-CODE, so that sites may have the same codes")
      ->allow_extra_args(false);
  command->add_option("-o,--output", arguments->output, "The merged study, a new file")->required();
  command->add_flag(
      "--incomplete", arguments->incomplete,
      "Merge shards although others are missing; the merged file records that it is incomplete");
  command->callback([arguments] { run_merge(*arguments); });
}

void add_forget(CLI::App& study) {
  const auto arguments = std::make_shared<RecordArguments>();
  CLI::App* command = add_command(
      study, "forget",
      "Erase a participant, for example one who withdrew, from a study's file and its backups",
      "forget study.sqlite P007 --yes");
  add_database(command, arguments->database);
  command->add_option("CODE", arguments->participant, "The participant's code")->required();
  command->add_flag("--yes", arguments->yes, "Confirm the erasure, which cannot be undone");
  command->callback([arguments] { run_forget(*arguments); });
}

void add_summary(CLI::App& study) {
  const auto arguments = std::make_shared<RecordArguments>();
  CLI::App* command =
      add_command(study, "summary", "Summarise one session: trials, times, frames, gaze and notes",
                  "summary study.sqlite --participant P001");
  add_database(command, arguments->database);
  command->add_option("--participant", arguments->participant, "The participant's code")
      ->required();
  command->callback([arguments] {
    print_text("{}", session_summary(arguments->database, arguments->participant));
  });
}

void add_gaze(CLI::App& study) {
  const auto arguments = std::make_shared<RecordArguments>();
  CLI::App* command = add_command(
      study, "gaze", "Export the gaze of one trial as a recording that other commands can replay",
      "gaze study.sqlite --participant P001 --trial 0 -o gaze.csv");
  add_database(command, arguments->database);
  command->add_option("--participant", arguments->participant, "The participant's code")
      ->required();
  command
      ->add_option("--trial", arguments->trial,
                   "The trial, counted from 0; its last attempt is exported")
      ->check(CLI::Range(0, std::numeric_limits<int>::max()))
      ->required();
  command
      ->add_option("-o,--output", arguments->output,
                   "The recording, a file of comma-separated values")
      ->required();
  command->callback([arguments] { run_gaze(*arguments); });
}

}  // namespace foveola::study
