// Whether a process holds locks on a file, as the kernel tells it.
#pragma once

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>

#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/types.h>

namespace foveola::test {

/// Whether the process holds a POSIX lock on the file, by which SQLite elsewhere sees that it is in
/// use. proc(5) describes /proc/locks.
inline bool is_locked_by(pid_t process, const std::filesystem::path& path) {
  struct stat status{};
  if (::stat(path.c_str(), &status) != 0) {
    return false;
  }
  const std::regex lock(
      fmt::format(" POSIX .* {} [0-9a-f]+:[0-9a-f]+:{} ", process, status.st_ino));
  std::ifstream locks("/proc/locks");
  for (std::string line; std::getline(locks, line);) {
    if (std::regex_search(line, lock)) {
      return true;
    }
  }
  return false;
}

}  // namespace foveola::test
