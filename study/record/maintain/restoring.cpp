#include <algorithm>
#include <array>
#include <functional>
#include <map>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files/file_access.h"
#include "renderer/base/files/files.h"
#include "study/record/maintain/maintenance.h"
#include "study/record/sqlite/controller_lock.h"
#include "study/record/sqlite/database.h"
#include "study/record/sqlite/temporary_database.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

/// What SQLite keeps under a study's name; the study itself comes last.
constexpr std::array suffixes = {"-journal", "-wal", "-shm", ""};

bool is_sound(const fs::path& backup) {
  try {
    return verify_study(backup).faults.empty();
  } catch (const Error&) {
    return false;
  }
}

fs::path newest_sound_backup(const fs::path& study) {
  std::vector<fs::path> backups = backups_of(study);
  // They are named by their dates.
  std::ranges::sort(backups, std::greater(),
                    [](const fs::path& backup) { return backup.filename(); });
  const auto found = std::ranges::find_if(backups, is_sound);
  if (found == backups.end()) {
    throw Error(study.string(),
                fmt::format("has no sound backup in {}", backup_folder(study).string()),
                "name a copy by --from");
  }
  return *found;
}

void require_copy(const fs::path& copy, const fs::path& study) {
  std::error_code ignored;
  if (fs::equivalent(copy, study, ignored)) {
    throw Error(copy.string(), "is the study itself, not a copy", "name another file by --from");
  }
  require_sound_record(copy, "name another copy");
}

struct CountedSession {
  std::string participant;
  std::size_t events = 0;
};
using CountedSessions = std::map<std::string, CountedSession>;  // by UUID

CountedSessions counted_sessions(const fs::path& path) {
  CountedSessions sessions;
  SQLite::Database study = open_as_it_is(path);
  SQLite::Statement rows(study,
                         "SELECT uuid, participant,"
                         " (SELECT count(*) FROM event WHERE session = session.id) FROM session");
  while (rows.executeStep()) {
    sessions[rows.getColumn(0).getString()] = {
        .participant = rows.getColumn(1).getString(),
        .events = static_cast<std::size_t>(rows.getColumn(2).getInt64())};
  }
  return sessions;
}

/// Empty if a study that is damaged does not let it be counted.
std::optional<CountedSessions> readable_sessions(const fs::path& study) {
  try {
    return counted_sessions(study);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

std::vector<MissingEvents> missing_events(const CountedSessions& former,
                                          const CountedSessions& restored) {
  std::vector<MissingEvents> missing;
  for (const auto& [uuid, session] : former) {
    const auto found = restored.find(uuid);
    const std::size_t kept = found != restored.end() ? found->second.events : 0;
    if (kept < session.events) {
      missing.push_back({.participant = session.participant,
                         .missing = session.events - kept,
                         .events = session.events});
    }
  }
  std::ranges::sort(missing, {}, &MissingEvents::participant);
  return missing;
}

/// A name in the study's folder that is free with each suffix.
fs::path free_name_aside(const fs::path& study) {
  fs::path aside;
  do {
    aside = fmt::format("{}.damaged-{}", study.string(), date_in_file_name());
  } while (std::ranges::any_of(
      suffixes, [&](const char* suffix) { return fs::exists(aside.string() + suffix); }));
  return aside;
}

/// Moves what there is under the study's name; a log that stayed would be played into the copy.
void move_aside(const fs::path& study, Restored& restored) {
  const fs::path aside = free_name_aside(study);
  for (const char* suffix : suffixes) {
    const fs::path file = study.string() + suffix;
    if (fs::exists(fs::symlink_status(file))) {
      const fs::path moved = aside.string() + suffix;
      if (!rename_to_free(file, moved)) {
        throw Error(moved.string(), "was made by another program meanwhile", "try again");
      }
      restored.moved_aside.push_back(moved);
    }
  }
  sync_to_disk(folder_of(study));
}

Restored restore(const fs::path& study, const std::optional<fs::path>& chosen) {
  const ControllerLock lock(study);
  if (chosen) {
    require_copy(*chosen, study);
  }
  Restored restored{.copy = chosen ? *chosen : newest_sound_backup(study)};
  const bool is_there = fs::exists(study);
  const TemporaryDatabase temporary(study);
  with_clear_errors(restored.copy, [&] {
    SQLite::Database copy = open_as_it_is(restored.copy);
    copy_into(temporary, copy, study);
  });
  if (is_there) {
    if (const std::optional<CountedSessions> former = readable_sessions(study)) {
      restored.missing = missing_events(*former, counted_sessions(temporary.path()));
    }
  }
  take_access(temporary.path(), is_there ? study : restored.copy);
  move_aside(study, restored);
  if (!temporary.take_free_name()) {
    throw Error(study.string(), "was made by another program meanwhile",
                "move that away and try again");
  }
  return restored;
}

}  // namespace

Restored restore_study(const fs::path& path, const std::optional<fs::path>& copy) {
  require_writable(path);
  Restored restored;
  with_clear_errors(path, [&] { restored = restore(fs::weakly_canonical(path), copy); });
  return restored;
}

}  // namespace foveola::study
