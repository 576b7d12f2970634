// Writes the files of an ended session: the receipt of its consent, and copies of the study.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "study/person/run_person.h"
#include "study/record/write/study_store.h"

namespace foveola::study {

/// Returns a participant's receipt: the texts they consented to, when, and how to withdraw the
/// data. Plain text with each consent of a session's log; empty if the log has none. It has the
/// participant's code and no name. begun_with: the text of the protocol that the
/// study was begun with. Throws Error if a protocol's text is not TOML.
std::optional<std::string> consent_receipt(const std::string& begun_with,
                                           const std::string& participant,
                                           const std::vector<LoggedEvent>& events);

/// Writes RunSettings::receipt if it is set and consent was given. Throws Error.
void write_receipt(const RunSettings& settings, const StudyStore& store);

/// Returns the copy in RunSettings::backup_folder; empty if that is not set or the copy fails. A
/// failure is only a warning, as the session is valid without the copy.
std::filesystem::path copy_if_asked(const StudyStore& store, const RunSettings& settings);

/// Returns a new backup of the study. Throws Error, which says that the session itself is safe, if
/// the backup fails.
std::filesystem::path back_up(const StudyStore& store, const RunSettings& settings);

}  // namespace foveola::study
