// Studies of an older schema, brought to this one.
#pragma once

#include <filesystem>

namespace SQLite {
class Database;
}

namespace foveola::study {

/// Writes what `older`, a study of schema 3, says into `target`, which is empty. Its events are
/// gone through again by the machine of today, so that tables and hashes are as if they had been
/// recorded now; each session says what it was migrated from. Throws Error for events that cannot
/// have happened so, and what SQLite throws.
void bring_to_this_schema(SQLite::Database& older, SQLite::Database& target);

/// Where the copy of a study of that schema is kept when it is migrated: STUDY.schema-3.sqlite.
std::filesystem::path copy_of_schema(const std::filesystem::path& study, int schema);

/// Copies the study at `path`, which nobody else writes to, beside itself, and puts the migrated
/// one in its place, in one step. Throws Error or what SQLite throws.
void migrate_study(const std::filesystem::path& path);

}  // namespace foveola::study
