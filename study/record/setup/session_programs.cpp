#include "study/record/setup/session_programs.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <variant>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/build_info.h"
#include "renderer/base/error.h"
#include "study/record/write/session_rows.h"
#include "study/record/write/study_store.h"

namespace foveola::study {
namespace {

constexpr std::string_view before_program = "goes on with ";
constexpr std::string_view before_other_program = " instead of ";
constexpr std::string_view name_of_ours = "Foveola ";

/// The programs that notes name, by the session's row, in the order of time.
std::map<std::int64_t, std::vector<std::string>> programs_in_notes(SQLite::Database& study) {
  std::map<std::int64_t, std::vector<std::string>> programs;
  SQLite::Statement notes(study,
                          "SELECT session, text FROM note WHERE text GLOB ?"
                          " ORDER BY session, sequence");
  notes.bind(1, fmt::format("{}{}*", before_program, name_of_ours));
  while (notes.executeStep()) {
    if (std::optional<std::string> program = program_in_note(notes.getColumn(1).getString())) {
      programs[notes.getColumn(0).getInt64()].push_back(std::move(*program));
    }
  }
  return programs;
}

}  // namespace

std::string note_of_program(const std::string& now, const std::string& before) {
  return fmt::format("{}{}{}{}", before_program, now, before_other_program, before);
}

std::optional<std::string> program_in_note(const std::string& note) {
  const std::size_t end = note.find(before_other_program);
  if (!note.starts_with(before_program) || end == std::string::npos) {
    return std::nullopt;
  }
  std::string program = note.substr(before_program.size(), end - before_program.size());
  return program.starts_with(name_of_ours) ? std::optional(std::move(program)) : std::nullopt;
}

std::vector<std::string> programs_of(const KnownSession& session,
                                     const std::vector<LoggedEvent>& events) {
  std::vector<std::string> programs = {program_name(session.build)};
  for (const LoggedEvent& logged : events) {
    if (const auto* note = std::get_if<NoteWritten>(&logged.event)) {
      if (std::optional<std::string> program = program_in_note(note->text)) {
        programs.push_back(std::move(*program));
      }
    }
  }
  return programs;
}

bool is_of_this_version(const std::string& program) {
  return program.starts_with(fmt::format("{}{} ", name_of_ours, build_info().version));
}

void require_same_version(const std::string& place, const std::vector<KnownSession>& sessions,
                          const std::string& remedy) {
  const std::string now = build_info().version;
  const auto other = std::ranges::find_if(
      sessions, [&](const KnownSession& session) { return session.build.version != now; });
  if (other != sessions.end()) {
    throw Error(place,
                fmt::format("has sessions by Foveola {}, and this is {}, whose pictures differ",
                            other->build.version, now),
                remedy);
  }
}

std::vector<SessionPrograms> session_programs(SQLite::Database& study) {
  const std::map<std::int64_t, std::vector<std::string>> later = programs_in_notes(study);
  std::vector<SessionPrograms> sessions;
  SQLite::Statement rows(study, "SELECT * FROM session ORDER BY id");
  while (rows.executeStep()) {
    SessionPrograms session{.participant = rows.getColumn("participant").getString(),
                            .programs = {program_name(build_of(rows))}};
    if (const auto notes = later.find(rows.getColumn("id").getInt64()); notes != later.end()) {
      session.programs.insert(session.programs.end(), notes->second.begin(), notes->second.end());
    }
    sessions.push_back(std::move(session));
  }
  return sessions;
}

std::vector<ProgramUse> program_uses(const std::vector<SessionPrograms>& sessions) {
  std::vector<ProgramUse> uses;
  for (const SessionPrograms& session : sessions) {
    for (const std::string& program : session.programs) {
      const auto known = std::ranges::find(uses, program, &ProgramUse::program);
      if (known == uses.end()) {
        uses.push_back({.program = program, .participants = {session.participant}});
      } else if (known->participants.back() != session.participant) {
        known->participants.push_back(session.participant);
      }
    }
  }
  return uses;
}

std::string use_in_words(const ProgramUse& use) {
  const std::size_t sessions = use.participants.size();
  return fmt::format("{} in {} session{}", use.program, sessions, sessions == 1 ? "" : "s");
}

std::string programs_in_words(const std::vector<std::string>& programs) {
  return fmt::format("{}", fmt::join(programs, ", then "));
}

}  // namespace foveola::study
