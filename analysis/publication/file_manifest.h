// The list of the files that an analysis wrote into its folder, by which the next one removes those
// that it no longer writes.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace foveola::analysis {

/// A file of the folder, by its path in it, and the SHA-256 of what an analysis wrote there. While
/// files are replaced, a path stands with both digests.
struct WrittenFile {
  std::filesystem::path path;
  std::string sha256;

  friend auto operator<=>(const WrittenFile&, const WrittenFile&) = default;
};
using FileManifest = std::set<WrittenFile>;

/// In the folder, with a line for each file as sha256sum(1) writes it.
inline constexpr const char* manifest_name = "manifest.sha256";

/// The folder's manifest; empty if it has none. Lines that no analysis writes are left out, such as
/// those of paths that lead out of the folder. Throws Error if it cannot be read.
FileManifest read_manifest(const std::filesystem::path& folder);

/// Replaces the folder's manifest durably. It is written in `staging` first, a folder of the same
/// file system that the next analysis removes after a kill. Throws Error or filesystem_error if it
/// cannot be written.
void write_manifest(const std::filesystem::path& staging, const std::filesystem::path& folder,
                    const FileManifest& manifest);

/// Removes the files of `former` that `current` has not, and folders that become empty by that. A
/// file stays if its bytes are not those that were written, or if a link leads to it. Returns the
/// paths of the files that stay. Throws Error if a file cannot be removed.
std::vector<std::filesystem::path> remove_former_files(const std::filesystem::path& folder,
                                                       const FileManifest& former,
                                                       const FileManifest& current);

/// Syncs the folder and those in it that hold files of the manifest, as far as they are there.
void sync_folders(const std::filesystem::path& folder, const FileManifest& manifest);

}  // namespace foveola::analysis
