// What a study's file says, read from outside while its program runs or after.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace foveola::test {

using Rows = std::vector<std::string>;

/// The rows of a query, their columns as texts joined by "|"; NULL is "-". Empty if the file is not
/// there yet, or cannot be read at this moment.
std::optional<Rows> rows_of(const std::filesystem::path& database, const std::string& sql);

/// The same of a file that is not being written. Throws std::runtime_error if it cannot be read.
Rows all_rows_of(const std::filesystem::path& database, const std::string& sql);
/// The only row; empty if there is none.
std::string value_of(const std::filesystem::path& database, const std::string& sql);

/// What happened so far, with the participant whom it happened to.
Rows log_of(const std::filesystem::path& database);

int count_events(const std::filesystem::path& database);

/// Everything that a study is made for, to the last bit: of each trial only its last attempt.
Rows results_of(const std::filesystem::path& database);

}  // namespace foveola::test
