// A cache of reproducible files that programs on several machines may read and fill at once.
// Truncated files and flipped bits are detected.
//
// Beside each file lies its digest: NAME.sha256, one line in sha256sum's format. The digest is
// written first, so that a reader of the file finds it too. Both are renamed into place. If the two
// disagree, after a crash or another writer, the file counts as missing.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace foveola {

/// Makes a cache's folder and its parents, if missing. Throws Error if it cannot.
void make_cache_folder(const std::filesystem::path& folder);

/// Returns whether `file` exists, is readable and matches its digest. Reads all of it.
bool is_cached(const std::filesystem::path& file);

/// Returns the content of `file`; nullopt if it is missing, unreadable or does not match its
/// digest.
std::optional<std::string> read_from_cache(const std::filesystem::path& file);

/// Calls `write` with a temporary path and stores the result as `file` (see replace_file). An
/// existing file with the same content stays, since others may be reading it. Throws Error if it
/// cannot be written.
void store_file(const std::filesystem::path& file,
                const std::function<void(const std::filesystem::path&)>& write);

/// store_file with the bytes of `content`.
void store_content(const std::filesystem::path& file, std::string_view content);

}  // namespace foveola
