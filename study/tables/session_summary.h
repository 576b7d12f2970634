// How far a study has come, and one session on a page, as plain aligned text.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "study/record/maintenance.h"
#include "study/record/study_records.h"

namespace foveola::study {

/// The programs that recorded it; trials with their times, ratings and what is to be said about
/// them; frames, gaze, validations, reactions and notes. As plain text. Throws Error if the file at
/// `path` is no study, or there is no such participant.
std::string session_summary(const std::filesystem::path& path, const std::string& participant);

/// How far the sessions of one kind have come: people's, pilots' and simulated ones are never
/// counted together.
struct KindStatus {
  std::map<std::string, int> sessions;  ///< by state
  /// How often each row of the design was taken, by sessions that are completed or not over.
  std::map<int, int> design_rows;
  /// [method][position within a scene]: how often, in completed sessions.
  std::map<std::string, std::vector<int>> method_positions;
};

struct StudyStatus {
  std::map<std::string, KindStatus> kinds;
  std::vector<SessionRow> unfinished;  ///< sessions that are not over
  std::vector<SessionRow> excluded;
  int trials_done = 0;  ///< with a rating
};
StudyStatus status_of(const StudyRecords& records);

std::string status_table(const StudyRecords& records, const StudyStatus& status);

/// What was counted, and each fault and gap on a line of its own.
std::string verification_table(const Verification& found);

}  // namespace foveola::study
