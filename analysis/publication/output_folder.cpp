#include "analysis/publication/output_folder.h"

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>
#include <utility>

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

/// A folder that is there is staged inside itself: its parent may belong to somebody else.
fs::path staging_of(const fs::path& folder) {
  const bool exists = is_there(folder);
  const fs::path normal = fs::absolute(folder).lexically_normal();
  const fs::path plain = normal.has_filename() ? normal : normal.parent_path();
  std::string name = ((exists ? plain : plain.parent_path()) / ".unfinished-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    const std::string why = std::generic_category().message(errno);
    throw exists ? Error(folder.string(), "cannot be written: " + why,
                         "check its permissions or choose another with -o")
                 : Error(folder.string(), "cannot be made: " + why,
                         "make its parent folder or choose another with -o");
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

StagedFolder::StagedFolder(fs::path folder)
    : folder_(std::move(folder)), staging_(staging_of(folder_)) {}

StagedFolder::~StagedFolder() {
  std::error_code ignored;
  fs::remove_all(staging_, ignored);
}

std::vector<fs::path> StagedFolder::publish(const std::vector<fs::path>& files) {
  make_output_folder(folder_);
  std::vector<fs::path> published;
  for (const fs::path& file : files) {
    const fs::path target = folder_ / file.lexically_relative(staging_);
    std::error_code failure;
    fs::create_directories(target.parent_path(), failure);
    fs::rename(file, target, failure);
    if (failure) {
      throw Error(target.string(), "cannot be written: " + failure.message(),
                  "check its permissions or choose another folder with -o");
    }
    published.push_back(target);
  }
  return published;
}

}  // namespace foveola::analysis
