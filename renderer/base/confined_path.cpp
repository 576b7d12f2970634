#include "renderer/base/confined_path.h"

#include <algorithm>
#include <stdexcept>

namespace foveola {
namespace fs = std::filesystem;
namespace {

bool lies_inside(const fs::path& file, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first ==
         folder.end();
}

}  // namespace

fs::path confined_path(const fs::path& folder, const fs::path& relative) {
  if (relative.empty() || relative.native().find('\0') != std::string::npos) {
    throw std::runtime_error("not the name of a file");
  }
  if (relative.is_absolute()) {
    throw std::runtime_error("an absolute path");
  }
  if (std::find(relative.begin(), relative.end(), "..") != relative.end()) {
    throw std::runtime_error("a path that leads out of the folder");
  }
  std::error_code failure;
  const fs::path home = fs::canonical(folder, failure);
  const fs::path file = fs::canonical(home / relative, failure);
  if (failure) {
    throw std::runtime_error("a file that does not exist");
  }
  if (!lies_inside(file, home)) {
    throw std::runtime_error("a symbolic link that leads out of the folder");
  }
  if (!fs::is_regular_file(file, failure)) {
    throw std::runtime_error("not a regular file");
  }
  return file;
}

}  // namespace foveola
