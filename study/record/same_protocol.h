// Whether a study is gone on with by the protocol that it was begun with.
#pragma once

#include <filesystem>

#include "study/protocol/protocol.h"

namespace SQLite {
class Database;
}

namespace foveola::study {

/// Throws Error, about the study at `path`, if it was begun with another protocol, other files of
/// its methods, or other profiles or ready questionnaires: all by their hashes.
void require_same_protocol(SQLite::Database& database, const std::filesystem::path& path,
                           const Protocol& protocol);

}  // namespace foveola::study
