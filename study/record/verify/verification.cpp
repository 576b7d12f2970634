#include <algorithm>
#include <iterator>
#include <optional>

#include <SQLiteCpp/Backup.h>
#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/error.h"
#include "renderer/base/files/digest.h"
#include "renderer/base/work/ordered_jobs.h"
#include "renderer/base/work/parallel.h"
#include "study/record/log/log_keeper.h"
#include "study/record/maintain/maintenance.h"
#include "study/record/schema.h"
#include "study/record/setup/session_programs.h"
#include "study/record/setup/session_setup.h"
#include "study/record/setup/simulated_part.h"
#include "study/record/setup/study_head.h"
#include "study/record/sqlite/controller_lock.h"
#include "study/record/sqlite/database.h"
#include "study/record/sqlite/database_checks.h"
#include "study/record/sqlite/journal_check.h"
#include "study/record/verify/session_check.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

/// A copy, since SQLite checks no CHECK constraints of files that it may not write. It has no name,
/// and goes to the disk only as far as it is larger than the cache.
SQLite::Database copy_to_verify(const fs::path& path) {
  SQLite::Database file = open_as_it_is(path);
  SQLite::Database copy("", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  copy.exec("PRAGMA cache_size = -65536");
  SQLite::Backup(copy, file).executeStep();
  return copy;
}

/// All that SQLite itself finds.
Verification check_integrity(const fs::path& path) {
  Verification found;
  SQLite::Database study = copy_to_verify(path);
  run_check(found, "", [&] {
    SQLite::Statement integrity(study, "PRAGMA integrity_check");
    while (integrity.executeStep()) {
      if (const std::string finding = integrity.getColumn(0).getString(); finding != "ok") {
        found.faults.push_back({"", finding});
      }
    }
  });
  SQLite::Statement foreign_keys(study, "PRAGMA foreign_key_check");
  while (foreign_keys.executeStep()) {
    found.faults.push_back({"", fmt::format("a row of {} refers to one of {} that is not there",
                                            foreign_keys.getColumn(0).getString(),
                                            foreign_keys.getColumn(2).getString())});
  }
  return found;
}

void check_schema(SQLite::Database& study, const fs::path& path, Verification& found) {
  require_schema(study, path);
  for (const std::string& object : foreign_objects(study)) {
    found.faults.push_back({"", fmt::format("has the {}, which is not Foveola's", object)});
  }
  for (const std::optional<std::string>& fault :
       {statistics_fault(study), part_fault(study), unused_bytes_fault(study)}) {
    if (fault) {
      found.faults.push_back({"", *fault});
    }
  }
  if (schema_version_of(study) < 5) {
    found.gaps.push_back({"",
                          "has schema 4: whether frames, gaze or films were exchanged, removed or "
                          "forged, and when the study was made, cannot be seen"});
  } else if (study
                 .execAndGet(
                     "SELECT (SELECT min(utc) FROM"
                     "  (SELECT study_created_utc AS utc FROM session UNION ALL"
                     "   SELECT study_created_utc FROM forgotten)) <> created_utc FROM study")
                 .getInt() != 0) {
    found.faults.push_back({"", "its date is not that of which its sessions tell"});
  }
  if (const std::optional<std::string> fault = tombstone_fault(study)) {
    found.faults.push_back({"", *fault});
  }
}

void check_texts(SQLite::Database& study, Verification& found) {
  SQLite::Statement texts(study,
                          "SELECT 'the protocol' AS what, protocol_text, protocol_sha256 FROM study"
                          " UNION ALL SELECT device || ' ' || name, toml, toml_sha256"
                          " FROM study_profile");
  while (texts.executeStep()) {
    if (sha256(texts.getColumn(1).getString()) != texts.getColumn(2).getString()) {
      found.faults.push_back(
          {"", texts.getColumn(0).getString() + " is not the one that its SHA-256 names"});
    }
  }
}

/// What another program would play into the file. Nothing may have the file open.
void check_journal(const fs::path& file, Verification& found) {
  try {
    require_own_journal(file);
  } catch (const Error& foreign) {
    found.warnings.push_back({"", foreign.what()});
  }
}

/// What a copy of the file alone would lack. A program that writes the study has such a log.
void check_log(SQLite::Database& study, const fs::path& file, Verification& found) {
  if (!has_log(file) && schema_version_of(study) >= 5 && is_written_with_log(study)) {
    found.warnings.push_back(
        {"", fmt::format("was written with a log, {}-wal, which is not beside it: a copy that was "
                         "made while a session ran lacks what the log held; copy both, or use "
                         "foveola study backup",
                         file.filename().string())});
  }
  if (has_log(file) && !is_controlled(file) && has_commits_in_log(study)) {
    found.warnings.push_back(
        {"", fmt::format("its log, {}-wal, holds commits that are not in the file yet: keep and "
                         "copy both together until a session has folded them in",
                         file.filename().string())});
  }
}

/// Times depend on the renderer.
void check_programs(SQLite::Database& study, Verification& found) {
  const std::vector<SessionPrograms> sessions = session_programs(study);
  for (const SessionPrograms& session : sessions) {
    if (session.programs.size() > 1) {
      found.warnings.push_back(
          {session.participant,
           fmt::format("the session is by {}", programs_in_words(session.programs))});
    }
  }
  if (const std::vector<ProgramUse> uses = program_uses(sessions); uses.size() > 1) {
    std::vector<std::string> words;
    std::ranges::transform(uses, std::back_inserter(words), use_in_words);
    found.warnings.push_back(
        {"", fmt::format("was recorded by several programs, between which times may differ: {}",
                         fmt::join(words, "; "))});
  }
}

/// People's: rehearsals are made with anything.
void check_setups(SQLite::Database& study, Verification& found) {
  std::vector<SessionSetup> sessions = session_setups(study);
  std::erase_if(sessions, [](const SessionSetup& session) { return session.kind != "human"; });
  for (const std::string& line : varying_setup(sessions)) {
    found.warnings.push_back({"", fmt::format("people had other equipment, {}", line)});
  }
}

/// A computer whose clock was wrong. Sessions in virtual time have no dates of their own.
void check_dates(SQLite::Database& study, Verification& found) {
  SQLite::Statement far(study,
                        "SELECT participant, date(started_utc) AS day, before, before_day FROM"
                        " (SELECT participant, started_utc, id,"
                        "   lag(participant) OVER begun AS before,"
                        "   date(lag(started_utc) OVER begun) AS before_day,"
                        "   julianday(started_utc) - julianday(lag(started_utc) OVER begun) AS days"
                        "  FROM session WHERE kind <> 'simulated' WINDOW begun AS (ORDER BY id))"
                        " WHERE abs(days) > 365 ORDER BY id");
  while (far.executeStep()) {
    found.warnings.push_back(
        {far.getColumn("participant").getString(),
         fmt::format("the session is dated {}, and the one before it, of {}, {}: more than a year "
                     "apart, so that a clock may have been wrong",
                     far.getColumn("day").getString(), far.getColumn("before").getString(),
                     far.getColumn("before_day").getString())});
  }
}

std::vector<SessionKey> session_keys(SQLite::Database& study) {
  std::vector<SessionKey> keys;
  SQLite::Statement sessions(study, "SELECT id, participant FROM session ORDER BY id");
  while (sessions.executeStep()) {
    keys.push_back({sessions.getColumn(0).getInt64(), sessions.getColumn(1).getString()});
  }
  return keys;
}

void append(Verification& all, const Verification& part) {
  const auto join = [](std::vector<RecordFault>& to, const std::vector<RecordFault>& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  all.sessions += part.sessions;
  all.events += part.events;
  all.chunks += part.chunks;
  join(all.faults, part.faults);
  join(all.gaps, part.gaps);
  join(all.warnings, part.warnings);
}

/// Checks `sessions` by a connection of its own.
Verification check_sessions_in(const fs::path& path, std::span<const SessionKey> sessions) {
  SQLite::Database study = open_as_it_is(path);
  // All is read as it was at one moment, whatever is written meanwhile.
  const SQLite::Transaction one_moment(study);
  PreparedStatements statements(study);
  return check_sessions(statements, sessions);
}

/// Appends what SQLite finds in the file or, if that is nothing, what is found in the sessions, in
/// their order. The file as a whole is checked beside the sessions, and each thread has some of
/// them at a time.
void check_file_and_sessions(const fs::path& path, const std::vector<SessionKey>& sessions,
                             Verification& found) {
  constexpr std::size_t max_at_once = 128;  // what they are before events is in memory
  const auto threads = static_cast<std::size_t>(usable_cores());
  const std::size_t at_once =
      std::clamp<std::size_t>((sessions.size() + threads - 1) / threads, 1, max_at_once);
  const std::size_t pieces = (sessions.size() + at_once - 1) / at_once;
  OrderedJobs<Verification> checks(1 + pieces, pieces + 1, [&](std::size_t index) {
    if (index == 0) {
      return check_integrity(path);
    }
    const std::size_t first = (index - 1) * at_once;
    return check_sessions_in(
        path, std::span(sessions).subspan(first, std::min(at_once, sessions.size() - first)));
  });
  checks.run(usable_cores(), [&](std::size_t index, const Verification& part) {
    append(found, part);
    return index > 0 || part.faults.empty();
  });
}

Verification verify(const fs::path& path) {
  require_study(path);
  const fs::path file = fs::canonical(path);
  Verification found;
  std::vector<SessionKey> sessions;
  if (!has_log(file)) {
    check_journal(file, found);
  }
  {
    SQLite::Database study = open_as_it_is(path);
    if (const std::optional<std::string> fault = size_fault(study)) {
      found.faults.push_back({"", *fault});
    }
    if (!found.faults.empty() || page_fault(study)) {
      append(found, check_integrity(path));
      return found;
    }
    check_log(study, file, found);
    check_schema(study, path, found);
    for (const auto check : {check_texts, check_programs, check_setups, check_dates}) {
      run_check(found, "", [&] { check(study, found); });
    }
    sessions = session_keys(study);
  }
  check_file_and_sessions(path, sessions, found);
  return found;
}

}  // namespace

Verification verify_study(const fs::path& path) {
  Verification found;
  with_clear_errors(path, [&] { found = verify(path); });
  return found;
}

void require_sound_record(const fs::path& path, const std::string& remedy) {
  const Verification found = verify_study(path);
  if (!found.faults.empty()) {
    const RecordFault& first = found.faults.front();
    throw Error(
        path.string(),
        (first.participant.empty() ? "" : "participant " + first.participant + ": ") + first.what,
        remedy);
  }
}

}  // namespace foveola::study
