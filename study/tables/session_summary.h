// Summarises a study's progress, and single sessions, as aligned plain text.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "study/record/maintain/maintenance.h"
#include "study/record/read/study_records.h"

namespace foveola::study {

/// Summarises a session: its programs; trials with times, ratings and remarks; frames, gaze,
/// validations, reactions and notes. Throws Error if the file at `path` is not a study, or has no
/// such participant.
std::string session_summary(const std::filesystem::path& path, const std::string& participant);

/// Progress of the sessions of one kind: people's, pilots' and simulated ones are counted
/// separately.
struct KindStatus {
  std::map<std::string, int> sessions;  ///< by state
  /// Number of uses of each design row, by sessions that are completed or not over.
  std::map<int, int> design_rows;
  /// [method][position within a scene]: counts in completed sessions.
  std::map<std::string, std::vector<int>> method_positions;
};

struct StudyStatus {
  std::map<std::string, KindStatus> kinds;
  std::vector<SessionRow> unfinished;  ///< sessions that are not over
  std::vector<SessionRow> excluded;
  int trials_done = 0;  ///< rated trials
};
StudyStatus status_of(const StudyRecords& records);

std::string status_table(const StudyRecords& records, const StudyStatus& status);

/// Returns the counts, and a line per fault and gap.
std::string verification_table(const Verification& found);

}  // namespace foveola::study
