// Compares the displays, machines, trackers and programs of sessions.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace SQLite {
class Database;
}

namespace foveola::study {

/// What belongs together where a protocol asks for the same. Speeds, and whether refreshes were
/// measured, depend on the moment.
enum class SetupPart { display, machine, speed, refreshes, program, other };

/// A fact that two sessions have otherwise, in words.
struct SetupDifference {
  std::string name;
  SetupPart part = SetupPart::other;
  std::string before;
  std::string now;
};

/// Of the devices of two sessions, as SessionFacts::devices: what both of them say, and say
/// otherwise. Frame rates differ by more than 5 %, speeds by a factor of more than 2.
std::vector<SetupDifference> setup_differences(const std::string& before, const std::string& now);

/// The devices of a session: those that it began with, then those of each time it was continued.
struct SessionSetup {
  std::string participant;
  std::string kind;  ///< "human", "pilot" or "simulated"
  std::vector<std::string> devices;
};

/// Returns the devices of every session, in the order of their starts. Throws SQLite::Exception.
std::vector<SessionSetup> session_setups(SQLite::Database& study);

/// The same of a study's file. Throws Error.
std::vector<SessionSetup> read_session_setups(const std::filesystem::path& path);

/// A fact of several sessions' set-ups.
struct SetupSummary {
  std::string name;  ///< "pixels"
  SetupPart part = SetupPart::other;
  bool varies = false;  ///< between the sessions or within one
  std::string words;    ///< "640 x 480", or "640 x 480 in P1, P2; 1280 x 720 in P3" if it varies
};

/// Each fact but the program that any of these sessions recorded.
std::vector<SetupSummary> summarize_setups(const std::vector<SessionSetup>& sessions);

/// A line for each fact but the program that differs between these sessions or within one: "pixels:
/// 640 x 480 in P1, P2; 1280 x 720 in P3".
std::vector<std::string> varying_setup(const std::vector<SessionSetup>& sessions);

}  // namespace foveola::study
