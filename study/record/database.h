// Study files as SQLite databases: making, opening and checking them, and SQLite's faults in the
// user's words.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>

#include "study/protocol/protocol.h"

namespace SQLite {
class Database;
}

namespace foveola::study {

/// Runs `work` and turns what SQLite throws into Error about the file at `path`.
void with_clear_errors(const std::filesystem::path& path, const std::function<void()>& work);

/// The study at `path`, checked, to read only. Nothing beside it is made, even in a folder that
/// cannot be written. Throws Error or what SQLite throws if it is missing, no study, damaged or of
/// another schema.
SQLite::Database open_study_to_read(const std::filesystem::path& path);

/// Makes the study of `protocol` at `path` in one step: it is there whole or not at all. A file
/// that another program puts there at the same time stays.
void create_study(const std::filesystem::path& path, const Protocol& protocol);

/// The study at `path`, which exists and was checked, to write: a commit is on the disk when it
/// returns.
SQLite::Database open_study_to_write(const std::filesystem::path& path);

}  // namespace foveola::study
