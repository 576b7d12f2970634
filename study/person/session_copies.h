// What is made of a session once it has ended: a receipt of its consent, and copies of the study.
#pragma once

#include <filesystem>

#include "study/person/run_person.h"
#include "study/record/study_store.h"

namespace foveola::study {

/// Writes RunSettings::receipt, if one is asked for and consent was given. Throws Error.
void write_receipt(const RunSettings& settings, const StudyStore& store);

/// Returns the copy in RunSettings::backup_folder; empty if none is asked for. The session counts
/// with the copy or without: if it cannot be made, a warning says so, and the path is empty.
std::filesystem::path copy_if_asked(const StudyStore& store, const RunSettings& settings);

/// Returns a new backup of the study. Throws Error, which says that the session itself is safe, if
/// there can be none.
std::filesystem::path back_up(const StudyStore& store, const RunSettings& settings);

}  // namespace foveola::study
