#include "study/record/setup/study_head.h"

#include <algorithm>
#include <regex>
#include <sstream>

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/files/digest.h"
#include "study/record/log/hash_chain.h"
#include "study/record/schema.h"
#include "study/record/sqlite/database.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

bool is_tombstone(const SessionHead& head) {
  constexpr std::size_t sha256_digits = 64;
  return head.uuid.size() == sha256_digits;
}

bool has_tombstone(SQLite::Database& study, const std::string& uuid_sha256) {
  SQLite::Statement row(study, "SELECT 1 FROM forgotten WHERE uuid_sha256 = ?");
  row.bind(1, uuid_sha256);
  return row.executeStep();
}

/// Whether a tombstone is that of the session, which had as many events or more.
bool is_forgotten(SQLite::Database& study, const SessionHead& earlier) {
  SQLite::Statement row(study,
                        "SELECT 1 FROM forgotten WHERE uuid_sha256 = ?"
                        " AND (events > ? OR (events = ? AND last_hash = ?))");
  SQLite::bind(row, sha256(earlier.uuid), earlier.events, earlier.events, earlier.last_hash);
  return row.executeStep();
}

/// The hash of the session after so many events; empty if it has fewer.
std::string hash_after(SQLite::Database& study, std::int64_t session, std::int64_t events) {
  if (events == 0) {
    PreparedStatements statements(study);
    return hash_before_events(statements, session);
  }
  SQLite::Statement event(study, "SELECT hash FROM event WHERE session = ? AND sequence = ?");
  SQLite::bind(event, session, events);
  return event.executeStep() ? event.getColumn(0).getString() : "";
}

void compare(SQLite::Database& study, const SessionHead& earlier, HeadComparison& comparison) {
  const bool may_forget = schema_version_of(study) >= 5;
  if (is_tombstone(earlier)) {
    if (!may_forget || !has_tombstone(study, earlier.uuid)) {
      comparison.faults.push_back(
          fmt::format("{}, of a session that was forgotten, is missing", earlier.uuid));
    }
    return;
  }
  SQLite::Statement session(study, "SELECT id FROM session WHERE uuid = ?");
  session.bind(1, earlier.uuid);
  if (!session.executeStep()) {
    if (may_forget && is_forgotten(study, earlier)) {
      comparison.forgotten.push_back(fmt::format("session {} was forgotten", earlier.uuid));
    } else {
      comparison.faults.push_back(fmt::format("session {} is missing", earlier.uuid));
    }
    return;
  }
  const std::string hash = hash_after(study, session.getColumn(0).getInt64(), earlier.events);
  if (hash.empty()) {
    comparison.faults.push_back(
        fmt::format("session {} has no event {}", earlier.uuid, earlier.events));
  } else if (hash != earlier.last_hash) {
    comparison.faults.push_back(
        fmt::format("session {} is another up to event {}", earlier.uuid, earlier.events));
  }
}

}  // namespace

StudyHead study_head(SQLite::Database& study) {
  StudyHead head;
  PreparedStatements statements(study);
  SQLite::Statement rows(
      study,
      "SELECT uuid, id, coalesce(max(sequence), 0), coalesce(hash, '') FROM session"
      " LEFT JOIN event ON event.session = session.id GROUP BY id ORDER BY uuid");
  std::vector<std::string> hashes;
  while (rows.executeStep()) {
    const std::string last = rows.getColumn(3).getString();
    head.sessions.push_back(
        {.uuid = rows.getColumn(0).getString(),
         .events = rows.getColumn(2).getInt64(),
         .last_hash =
             last.empty() ? hash_before_events(statements, rows.getColumn(1).getInt64()) : last});
    hashes.push_back(head.sessions.back().last_hash);
  }
  if (schema_version_of(study) >= 5) {
    SQLite::Statement forgotten(
        study, "SELECT uuid_sha256, events, last_hash FROM forgotten ORDER BY uuid_sha256");
    while (forgotten.executeStep()) {
      head.forgotten.push_back({.uuid = forgotten.getColumn(0).getString(),
                                .events = forgotten.getColumn(1).getInt64(),
                                .last_hash = forgotten.getColumn(2).getString()});
      hashes.push_back(head.forgotten.back().last_hash);
    }
  }
  head.sha256 = sha256(fmt::format("{}", fmt::join(hashes, "\n")));
  return head;
}

StudyHead read_head(const fs::path& path) {
  StudyHead head;
  with_clear_errors(path, [&] {
    SQLite::Database study = open_study_to_read(path);
    head = study_head(study);
  });
  return head;
}

std::vector<SessionHead> heads_in(const std::string& text) {
  static const std::regex line_of_session(
      "([0-9a-f]{8}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{12}|[0-9a-f]{64})"
      "[^0-9a-f]{1,9}([0-9]{1,18})"
      "[^0-9a-f]{1,9}([0-9a-f]{64})");
  std::vector<SessionHead> heads;
  for (std::sregex_iterator found(text.begin(), text.end(), line_of_session), end; found != end;
       ++found) {
    heads.push_back(
        {.uuid = (*found)[1], .events = std::stoll((*found)[2]), .last_hash = (*found)[3]});
  }
  return heads;
}

std::optional<std::string> tombstone_fault(SQLite::Database& study) {
  if (schema_version_of(study) < 5) {
    return std::nullopt;
  }
  SQLite::Statement sessions(study, "SELECT uuid FROM session");
  while (sessions.executeStep()) {
    if (const std::string uuid = sessions.getColumn(0).getString();
        has_tombstone(study, sha256(uuid))) {
      return fmt::format("says that session {} was forgotten, which it has", uuid);
    }
  }
  SQLite::Statement odd(study,
                        "SELECT study_created_utc FROM forgotten"
                        " WHERE length(study_created_utc) <> length('2018-01-01T00:00:00.000Z')"
                        " OR study_created_utc GLOB '*[^0-9TZ:.-]*'");
  return odd.executeStep() ? std::optional("a session that was forgotten has the date " +
                                           odd.getColumn(0).getString())
                           : std::nullopt;
}

HeadComparison compare_with_head(const fs::path& path, const std::vector<SessionHead>& earlier) {
  HeadComparison comparison;
  with_clear_errors(path, [&] {
    SQLite::Database study = open_study_to_read(path);
    for (const SessionHead& session : earlier) {
      compare(study, session, comparison);
    }
  });
  return comparison;
}

}  // namespace foveola::study
