// Study files as SQLite databases: making, opening and copying them, and SQLite's faults in the
// user's words.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "renderer/base/clock.h"
#include "study/protocol/protocol.h"

namespace SQLite {
class Database;
}

namespace foveola::study {

class TemporaryDatabase;

/// Lets SQLite keep no counts of its memory, which nobody reads: they lie behind one lock, for
/// which threads with a database each would wait. Of the whole program, and before it opens any.
void keep_no_memory_counts();

/// Runs `work` and turns what SQLite throws into Error about the file at `path`.
void with_clear_errors(const std::filesystem::path& path, const std::function<void()>& work);

/// Runs `work`, which reads one file and writes another that is to lie at `target`. Turns what
/// SQLite throws of a full disk into Error about the target; all else it throws passes.
void with_named_target(const std::filesystem::path& target, const std::function<void()>& work);

/// Reads of the file at `path` only what kind of file it is. Throws Error or what SQLite throws if
/// it is missing, no study, of another schema, or if it has a second name (hard link).
void require_study(const std::filesystem::path& path);

/// Whether a write-ahead log lies beside the file at `path`, by its own name.
bool has_log(const std::filesystem::path& path);

/// Folds the log of a connection that open_study_to_write() opened into the file, which then has
/// none, and stays as it is where another connection holds that up.
void end_log(SQLite::Database& database);

/// The file at `path`, which exists, unchecked, to read only. Nothing beside it is made, even in a
/// folder that cannot be written, and no journal that lies beside it is played into it. Throws
/// Error or what SQLite throws.
SQLite::Database open_as_it_is(const std::filesystem::path& path);

/// The study at `path`, checked, to read only; nothing is made either. Throws Error or what SQLite
/// throws if it is missing, no study, damaged or of a schema that this program does not know.
SQLite::Database open_study_to_read(const std::filesystem::path& path);

/// Makes the study of `protocol` at `path` in one step: it is there whole or not at all. A file
/// that another program puts there at the same time stays. created_utc: when that is.
void create_study(const std::filesystem::path& path, const Protocol& protocol,
                  const std::string& created_utc = utc_now());

/// Throws Error if the file at `path`, which exists, must not be written.
void require_writable_file(const std::filesystem::path& path);

/// The study at `path`, which exists and was checked, to write: a commit is on the disk when it
/// returns.
SQLite::Database open_study_to_write(const std::filesystem::path& path);

/// Leaves the database at `path` as one self-contained file, so that another can take its place.
/// Throws Error if another program reads or writes it.
void fold_in_log(const std::filesystem::path& path);

/// Copies `database` to `path` in one step and checks the copy; a file that is there is replaced.
/// Throws Error, about `path` if its disk is full, or what SQLite throws.
void copy_checked(SQLite::Database& database, const std::filesystem::path& path);

/// Copies `database` into a new file that has not its final path yet, and checks the copy. Throws
/// Error, which names `path`, or what SQLite throws.
void copy_into(const TemporaryDatabase& temporary, SQLite::Database& database,
               const std::filesystem::path& path);

}  // namespace foveola::study
