#include "analysis/publication/output_folder.h"

#include <cerrno>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "analysis/publication/file_manifest.h"
#include "renderer/base/digest.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace fs = std::filesystem;

namespace foveola::analysis {
namespace {

/// Throws Error for a file in the folder's place. Returns whether the folder is there already.
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

/// Held until it is closed. Throws Error if another program holds it.
int lock(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor >= 0 && ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    ::close(descriptor);
    throw Error(folder.string(), "is being written by another analysis",
                "let that end, or choose another folder with -o");
  }
  return descriptor;
}

/// What killed programs have left. The folder is locked.
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

/// A new folder in `folder`: the parent of that may belong to somebody else.
fs::path make_staging(const fs::path& folder) {
  std::string name = (folder / staging_name).string();
  if (::mkdtemp(name.data()) == nullptr) {
    throw Error(folder.string(), "cannot be written: " + std::generic_category().message(errno),
                "check its permissions or choose another with -o");
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
    fs::remove(folder_, ignored);  // unless there is something in it
  }
  ::close(lock_);
}

PublishedFiles StagedFolder::publish(const std::vector<fs::path>& files) {
  FileManifest current;
  for (const fs::path& file : files) {
    current.insert({file.lexically_relative(staging_), sha256_of_file(file)});
  }
  // Until all is done, the manifest names the former files and the new ones.
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
                  "check its permissions or choose another folder with -o");
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
