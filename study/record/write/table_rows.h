// Rows of any table, copied from one study to another or compared with those of another.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace SQLite {
class Database;
class Statement;
}  // namespace SQLite

namespace foveola::study {

/// SQL that stands for a column's own value, by the column's name: {"state", "'created'"}.
using Replacements = std::map<std::string, std::string>;

/// The tables of the study itself, each behind those that it refers to, as are the others.
inline constexpr std::array study_tables = {
    "study",         "study_scene", "study_method", "study_method_file",
    "study_profile", "study_mark",  "study_rating"};

/// The tables of what a session set out to do; as in those below, the column session says whose.
inline constexpr std::array plan_tables = {"session_scene", "planned_trial", "planned_step"};

/// The log of a session's events.
inline constexpr std::array log_tables = {"event"};

/// What follows from its log and its plan: tables in schema 4, views since.
inline constexpr std::array tables_before_5 = {
    "gaze_run", "gaze_target", "questionnaire_answer", "reaction", "attempt", "mark", "rating"};

/// The tables of what was measured meanwhile.
inline constexpr std::array measured_tables = {"frame_chunk", "gaze_chunk", "film_hash"};

/// The names of a table's columns in their order. Throws what SQLite throws.
std::vector<std::string> columns_of(SQLite::Database& database, const std::string& table);

/// Appends the rows of `source`'s table for which `condition`, in SQL, holds to that of `target`.
/// Throws what SQLite throws.
void copy_rows(SQLite::Database& source, SQLite::Database& target, const std::string& table,
               const std::string& condition = "true", const Replacements& replacements = {});

/// The rows that the statement gives from here on, each as bytes that are the same for the same
/// values of the same types, in the order of these bytes: what was written in whatever order
/// compares equal. `ignored` columns count for nothing. Throws what SQLite throws.
std::vector<std::string> sorted_rows(SQLite::Statement& rows,
                                     const std::set<std::string>& ignored = {});

/// A digest of a table's sorted_rows for which `condition`, in SQL, holds.
std::string digest_of_rows(SQLite::Database& database, const std::string& table,
                           const std::string& condition = "true",
                           const std::set<std::string>& ignored = {});

/// "session = 3"
std::string is_of_session(std::int64_t session);

}  // namespace foveola::study
