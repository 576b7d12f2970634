// Whether a study's file is what Foveola makes of one: its schema, its size, its integrity.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace SQLite {
class Database;
}

namespace foveola::study {

/// Every table, view, index and trigger must be the known one: so a stranger's file cannot make a
/// query do anything else, and a file whose guards were removed is not trusted. Others may stand
/// beside: see foreign_objects(). Throws Error.
void require_schema(SQLite::Database& database, const std::filesystem::path& path);

/// The tables, views, indexes and triggers that the schema does not have, each as "trigger NAME on
/// TABLE". Those that SQLite makes for ANALYZE are left out.
std::vector<std::string> foreign_objects(SQLite::Database& study);

/// What SQLite's statistics hold that ANALYZE does not write; empty if nothing. They are tables
/// that anybody can write.
std::optional<std::string> statistics_fault(SQLite::Database& study);

/// Throws Error if a trigger or an index stands beside those of the schema: either could change or
/// refuse what is written.
void require_only_own_effects(SQLite::Database& study, const std::filesystem::path& path);

/// What is wrong with the size of the database's file; empty if nothing is. SQLite takes what is
/// missing of the last page for zeros, and does not see what is appended.
std::optional<std::string> size_fault(SQLite::Database& database);

/// What stands in bytes of the file that no table has, and which Foveola leaves zero: those that
/// the header reserves, and free pages. Empty if nothing does, or if a log lies beside it. What
/// stands between the rows of a page is not seen: SQLite leaves there what was.
std::optional<std::string> unused_bytes_fault(SQLite::Database& database);

/// Whether the file's header says that a write-ahead log belongs to it, as while a session runs.
bool is_written_with_log(SQLite::Database& study);

/// Throws Error, which names the file by `path`, if there is a size_fault().
void require_whole_pages(SQLite::Database& database, const std::filesystem::path& path);

/// What SQLite's quick check finds first; empty if the pages form the trees that they should, so
/// that reading them comes to an end.
std::optional<std::string> page_fault(SQLite::Database& database);

/// Throws Error if there is a page_fault().
void require_sound(SQLite::Database& database, const std::filesystem::path& path);

/// Throws Error if `database`, a copy that is to lie at `path`, is not whole: by SQLite's own
/// checks of integrity and foreign keys.
void require_intact(SQLite::Database& database, const std::filesystem::path& path);

}  // namespace foveola::study
