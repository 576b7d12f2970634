// Rollback journals beside a study's file, which SQLite would play into it.
#pragma once

#include <filesystem>

namespace foveola::study {

/// Whether there is one.
bool has_journal(const std::filesystem::path& study);

/// Whether there is one that SQLite would play back. A loss of power may leave an empty or
/// half-written one, which SQLite ignores.
bool has_playable_journal(const std::filesystem::path& study);

/// Throws Error for one that would change more than how the file keeps its log: that alone is what
/// Foveola writes under a journal, and what a loss of power can leave half done. To be called while
/// nothing has the file open.
void require_own_journal(const std::filesystem::path& study);

}  // namespace foveola::study
