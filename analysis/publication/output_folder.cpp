#include "analysis/publication/output_folder.h"

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

}  // namespace foveola::analysis
