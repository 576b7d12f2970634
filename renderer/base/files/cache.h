// Files that can be made again, in a folder that programs on several machines may read and fill at
// once: what was cut off, or has a bit that flipped, is told from what is whole.
//
// Beside each file lies another, of its name and ".sha256", with a line as sha256sum writes and
// checks it. That is written first, so that whoever finds a file finds its digest too. Both are
// renamed into place; whatever comes between them, of a writer that dies or of others, the two
// agree or the file counts as missing.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace foveola {

/// Makes a cache's folder and those above it, if need be. Throws Error if it cannot.
void make_cache_folder(const std::filesystem::path& folder);

/// Whether `file` is there, as it was kept. Reads all of it.
bool is_kept(const std::filesystem::path& file);

/// The content of `file`, if it is there as it was kept.
std::optional<std::string> kept_content(const std::filesystem::path& file);

/// Keeps as `file` what `write` writes to the path that it is called with (see replace_file). Where
/// the same is there already, that stays: others may be reading it. Throws Error if it cannot be
/// written.
void keep_file(const std::filesystem::path& file,
               const std::function<void(const std::filesystem::path&)>& write);

/// keep_file with the bytes of `content`.
void keep_content(const std::filesystem::path& file, std::string_view content);

}  // namespace foveola
