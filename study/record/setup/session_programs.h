// Which programs recorded a study's sessions. Times depend on the renderer, so a session that
// another program goes on with says so in its log, and reports name every program.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace SQLite {
class Database;
}

namespace foveola::study {

struct KnownSession;
struct LoggedEvent;

/// The note of a session that `now` goes on with instead of `before`; both by program_name().
std::string note_of_program(const std::string& now, const std::string& before);

/// The program that such a note says goes on; empty if it is another note.
std::optional<std::string> program_in_note(const std::string& note);

/// By program_name(), in the order of time: the one that began the session with these events, then
/// each that went on with it instead of the one before.
std::vector<std::string> programs_of(const KnownSession& session,
                                     const std::vector<LoggedEvent>& events);

/// Whether `program`, by program_name(), is of this version, whatever it was built with.
bool is_of_this_version(const std::string& program);

/// Throws Error at `place` if another version began one of the sessions: pictures, and so times,
/// may differ between versions.
void require_same_version(const std::string& place, const std::vector<KnownSession>& sessions,
                          const std::string& remedy);

/// The programs that recorded a session, as programs_of().
struct SessionPrograms {
  std::string participant;
  std::vector<std::string> programs;
};

/// Of all sessions, in the order in which they were begun. Throws what SQLite throws.
std::vector<SessionPrograms> session_programs(SQLite::Database& study);

/// A program, and those whose sessions it recorded wholly or in part.
struct ProgramUse {
  std::string program;
  std::vector<std::string> participants;
};

/// Each program of the sessions once, in the order in which they were first used.
std::vector<ProgramUse> program_uses(const std::vector<SessionPrograms>& sessions);

/// "A in 2 sessions".
std::string use_in_words(const ProgramUse& use);

/// "A, then B, then A".
std::string programs_in_words(const std::vector<std::string>& programs);

}  // namespace foveola::study
