#include "analysis/publication/exports/output_folder.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include "renderer/base/error.h"
#include "renderer/base/files/digest.h"
#include "renderer/base/files/files.h"

namespace fs = std::filesystem;
namespace foveola::analysis {
namespace {

/// A file of the folder: its path in it, and the SHA-256 as written by an analysis. A path has both
/// digests while its file is replaced.
struct WrittenFile {
  std::filesystem::path path;
  std::string sha256;

  friend auto operator<=>(const WrittenFile&, const WrittenFile&) = default;
};

using FileManifest = std::set<WrittenFile>;

/// In the folder, with a line for each file as sha256sum(1) writes it.
constexpr const char* manifest_name = "manifest.sha256";

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

/// Returns whether `path` in the folder is of this type, and is reached by folders only, not links.
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

/// Returns whether the path no longer exists.
bool remove_if_unchanged(const fs::path& folder, const WrittenFile& file) {
  const fs::path path = folder / file.path;
  std::error_code failure;
  if (is_there_without_links(folder, file.path, fs::file_type::regular) &&
      sha256_of_file(path) == file.sha256 && !fs::remove(path, failure) && failure) {
    throw Error(path.string(),
                "belongs to an earlier analysis and cannot be removed: " + failure.message(),
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

/// Returns the folder's manifest; empty if it has none. Lines that no analysis writes are ignored,
/// such as paths out of the folder. Throws Error if it cannot be read.
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

/// Replaces the folder's manifest durably. It is written in `staging` first, a folder of the same
/// file system that the next analysis removes after a kill. Throws Error or filesystem_error if it
/// cannot be written.
void write_manifest(const fs::path& staging, const fs::path& folder, const FileManifest& manifest) {
  std::string text;
  for (const WrittenFile& file : manifest) {
    text += fmt::format("{}{}{}\n", file.sha256, before_path, file.path.generic_string());
  }
  write_file(staging / manifest_name, text);  // synced
  fs::rename(staging / manifest_name, folder / manifest_name);
  sync_to_disk(folder);
}

/// Removes the files of `former` that are not in `current`, and folders that become empty. A file
/// stays if its bytes have changed since, or if it is reached by a link. Returns the paths of the
/// files that stay. Throws Error if a file cannot be removed.
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

/// Returns whether the folder exists. Throws Error if it is a file.
bool is_there(const fs::path& folder) {
  std::error_code failure;
  if (fs::is_directory(folder, failure)) {
    return true;
  }
  if (fs::exists(folder, failure)) {
    throw Error(folder.string(), "is a file, not a folder", "choose another folder with -o");
  }
  return false;
}

constexpr std::string_view staging_name = ".unfinished-XXXXXX";

/// Locks the folder until the returned descriptor is closed. Throws Error if another program holds
/// it.
int lock(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor >= 0 && ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    ::close(descriptor);
    throw Error(folder.string(), "is being written by another analysis",
                "wait until it ends, or choose another folder with -o");
  }
  return descriptor;
}

void remove_former_staging(const fs::path& folder) {
  const std::string_view beginning = staging_name.substr(0, staging_name.find('X'));
  std::vector<fs::path> left;
  std::error_code ignored;
  for (fs::directory_iterator entry(folder, ignored); entry != fs::directory_iterator();
       entry.increment(ignored)) {
    const std::string name = entry->path().filename().string();
    if (name.size() == staging_name.size() && name.starts_with(beginning)) {
      left.push_back(entry->path());
    }
  }
  for (const fs::path& staging : left) {
    fs::remove_all(staging, ignored);
  }
}

/// Makes a new folder in `folder`, whose parent may belong to another user.
fs::path make_staging(const fs::path& folder) {
  std::string name = (folder / staging_name).string();
  if (::mkdtemp(name.data()) == nullptr) {
    throw Error(folder.string(), "cannot be written: " + std::generic_category().message(errno),
                "check the folder's permissions and free space, or choose another with -o");
  }
  return name;
}

}  // namespace

void check_output_folder(const fs::path& folder) {
  require_writable(is_there(folder) ? folder / "results" : folder);
}

void make_output_folder(const fs::path& folder) {
  std::error_code failure;
  if (!is_there(folder) && !fs::create_directory(folder, failure)) {
    throw Error(folder.string(), "cannot be made: " + failure.message(),
                "make its parent folder or choose another with -o");
  }
}

StagedFolder::StagedFolder(fs::path folder, bool is_new)
    : folder_(std::move(folder)), is_new_(is_new) {}

StagedFolder::StagedFolder(const fs::path& folder) : StagedFolder(folder, !is_there(folder)) {
  make_output_folder(folder_);
  lock_ = lock(folder_);
  remove_former_staging(folder_);
  staging_ = make_staging(folder_);
}

StagedFolder::~StagedFolder() {
  std::error_code ignored;
  fs::remove_all(staging_, ignored);
  if (is_new_) {
    fs::remove(folder_, ignored);  // unless it is not empty
  }
  ::close(lock_);
}

PublishedFiles StagedFolder::publish(const std::vector<fs::path>& files) {
  FileManifest current;
  for (const fs::path& file : files) {
    current.insert({file.lexically_relative(staging_), sha256_of_file(file)});
  }
  // Until everything is moved, the manifest names the former files and the new ones.
  const FileManifest former = read_manifest(folder_);
  FileManifest all = former;
  all.insert(current.begin(), current.end());
  write_manifest(staging_, folder_, all);
  PublishedFiles published{.files = {folder_ / manifest_name}};
  for (const fs::path& file : files) {
    const fs::path target = folder_ / file.lexically_relative(staging_);
    std::error_code failure;
    fs::create_directories(target.parent_path(), failure);
    fs::rename(file, target, failure);
    if (failure) {
      throw Error(target.string(), "cannot be written: " + failure.message(),
                  "check the folder's permissions and free space, or choose another with -o");
    }
    published.files.push_back(target);
  }
  for (const fs::path& path : remove_former_files(folder_, former, current)) {
    published.staying.push_back(folder_ / path);
  }
  sync_folders(folder_, all);
  write_manifest(staging_, folder_, current);
  return published;
}

}  // namespace foveola::analysis
