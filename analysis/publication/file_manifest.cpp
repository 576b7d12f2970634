#include "analysis/publication/file_manifest.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "renderer/base/digest.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace fs = std::filesystem;

namespace foveola::analysis {
namespace {

constexpr std::string_view before_path = "  ";
constexpr std::size_t digest_digits = 64;

bool stays_inside(const fs::path& path) {
  return path.is_relative() && path.has_filename() && path == path.lexically_normal() &&
         *path.begin() != "..";
}

std::optional<WrittenFile> file_in_line(std::string_view line) {
  constexpr std::string_view digits = "0123456789abcdef";
  const std::string_view digest = line.substr(0, digest_digits);
  if (digest.size() < digest_digits || digest.find_first_not_of(digits) != std::string_view::npos ||
      !line.substr(digest_digits).starts_with(before_path)) {
    return std::nullopt;
  }
  const fs::path path = line.substr(digest_digits + before_path.size());
  return stays_inside(path) ? std::optional(WrittenFile{path, std::string(digest)}) : std::nullopt;
}

/// Whether all that leads to `path` in the folder are folders, not links, and it is of this type.
bool is_there_without_links(const fs::path& folder, const fs::path& path, fs::file_type type) {
  std::error_code ignored;
  for (fs::path above = path.parent_path(); !above.empty(); above = above.parent_path()) {
    if (fs::symlink_status(folder / above, ignored).type() != fs::file_type::directory) {
      return false;
    }
  }
  return fs::symlink_status(folder / path, ignored).type() == type;
}

bool has_path(const FileManifest& manifest, const fs::path& path) {
  const auto found = manifest.lower_bound({path, ""});
  return found != manifest.end() && found->path == path;
}

/// Whether nothing stands at the path any more.
bool remove_if_unchanged(const fs::path& folder, const WrittenFile& file) {
  const fs::path path = folder / file.path;
  std::error_code failure;
  if (is_there_without_links(folder, file.path, fs::file_type::regular) &&
      sha256_of_file(path) == file.sha256 && !fs::remove(path, failure) && failure) {
    throw Error(path.string(),
                "is of an earlier analysis and cannot be removed: " + failure.message(),
                "check the permissions of its folder");
  }
  return !fs::exists(fs::symlink_status(path, failure));
}

void remove_empty_folders(const fs::path& folder, const fs::path& path) {
  std::error_code is_not_empty;
  for (fs::path above = path.parent_path(); !above.empty(); above = above.parent_path()) {
    if (is_there_without_links(folder, above, fs::file_type::directory)) {
      fs::remove(folder / above, is_not_empty);
    }
  }
}

}  // namespace

FileManifest read_manifest(const fs::path& folder) {
  FileManifest manifest;
  if (!fs::exists(folder / manifest_name)) {
    return manifest;
  }
  const std::string text = read_file(folder / manifest_name);
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    if (std::optional<WrittenFile> file = file_in_line(rest.substr(0, end))) {
      manifest.insert(*std::move(file));
    }
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return manifest;
}

void write_manifest(const fs::path& staging, const fs::path& folder, const FileManifest& manifest) {
  std::string text;
  for (const WrittenFile& file : manifest) {
    text += fmt::format("{}{}{}\n", file.sha256, before_path, file.path.generic_string());
  }
  write_file(staging / manifest_name, text);  // synced
  fs::rename(staging / manifest_name, folder / manifest_name);
  sync_to_disk(folder);
}

std::vector<fs::path> remove_former_files(const fs::path& folder, const FileManifest& former,
                                          const FileManifest& current) {
  std::set<fs::path> staying;
  for (const WrittenFile& file : former) {
    if (has_path(current, file.path)) {
      continue;
    }
    if (remove_if_unchanged(folder, file)) {
      staying.erase(file.path);
      remove_empty_folders(folder, file.path);
    } else {
      staying.insert(file.path);
    }
  }
  return {staying.begin(), staying.end()};
}

void sync_folders(const fs::path& folder, const FileManifest& manifest) {
  std::set<fs::path> folders = {folder};
  for (const WrittenFile& file : manifest) {
    for (fs::path above = file.path.parent_path(); !above.empty(); above = above.parent_path()) {
      folders.insert(folder / above);
    }
  }
  for (const fs::path& one : folders) {
    if (fs::is_directory(one)) {
      sync_to_disk(one);
    }
  }
}

}  // namespace foveola::analysis
