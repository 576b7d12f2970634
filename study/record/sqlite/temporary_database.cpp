#include "study/record/sqlite/temporary_database.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <random>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include "renderer/base/clock.h"
#include "renderer/base/error.h"
#include "renderer/base/files/file_access.h"
#include "renderer/base/files/files.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

Error cannot_be_made(const fs::path& path) {
  return {
      path.string(),
      fmt::format("cannot be made: {}", std::error_code(errno, std::generic_category()).message()),
      "choose another path"};
}

std::string prefix_of_temporaries(const fs::path& final_path) {
  return fmt::format(".{}.", final_path.filename().string());
}

constexpr const char* temporary_suffix = ".partial";

/// The name of the temporary that a file belongs to, itself or as SQLite's log or journal of it;
/// empty for a file of any other kind.
std::string temporary_of(const std::string& file_name) {
  constexpr std::size_t digits = 16;
  const std::size_t end = file_name.rfind(temporary_suffix);
  const std::size_t random = end - digits;
  const bool has_shape = file_name.starts_with('.') && end != std::string::npos && end > digits &&
                         file_name[random - 1] == '.' &&
                         file_name.find_first_not_of("0123456789abcdef", random) == end;
  return has_shape ? file_name.substr(0, end + std::strlen(temporary_suffix)) : "";
}

/// A descriptor with the lock of a temporary, which its program keeps; -1 if the file is not there,
/// or no lock is to be had. `waiting`: 0, or LOCK_NB not to wait for it.
int lock(const fs::path& temporary, int waiting) {
  const int descriptor = ::open(temporary.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (descriptor >= 0 && ::flock(descriptor, LOCK_EX | waiting) != 0) {
    ::close(descriptor);
    return -1;
  }
  return descriptor;
}

/// Removes what killed programs have left in a folder, on whatever machine they ran.
void remove_leftovers(const fs::path& folder) {
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    const std::string temporary = temporary_of(entry.path().filename().string());
    if (temporary.empty()) {
      continue;
    }
    const fs::path path = folder / temporary;
    const int descriptor = lock(path, LOCK_NB);
    if (descriptor >= 0 || !fs::exists(fs::symlink_status(path, ignored))) {
      fs::remove(entry.path(), ignored);
    }
    if (descriptor >= 0) {
      ::close(descriptor);
    }
  }
}

fs::path new_temporary(const fs::path& final_path) {
  std::random_device random;  // of the operating system
  return folder_of(final_path) / fmt::format("{}{:08x}{:08x}{}", prefix_of_temporaries(final_path),
                                             random(), random(), temporary_suffix);
}

}  // namespace

TemporaryDatabase::TemporaryDatabase(const fs::path& final_path) : final_path_(final_path) {
  remove_leftovers(folder_of(final_path));
  // Until it is locked, another program may take it for a leftover.
  while (true) {
    path_ = new_temporary(final_path);
    if (!make_new_file(path_, FileAccess::own)) {
      throw cannot_be_made(final_path);
    }
    lock_ = lock(path_, 0);
    if (fs::exists(path_)) {
      return;
    }
    ::close(lock_);
  }
}

TemporaryDatabase::~TemporaryDatabase() {
  remove();
  if (lock_ >= 0) {
    ::close(lock_);
  }
}

void TemporaryDatabase::replace_final() const {
  take_access(path_, final_path_);
  sync();
  if (::rename(path_.c_str(), final_path_.c_str()) != 0) {
    throw cannot_be_made(final_path_);
  }
  sync_to_disk(folder_of(final_path_));
}

bool TemporaryDatabase::take_free_name() const {
  sync();
  if (!rename_to_free(path_, final_path_)) {
    return false;
  }
  sync_to_disk(folder_of(final_path_));
  return true;
}

void TemporaryDatabase::sync() const { sync_to_disk(path_); }

void TemporaryDatabase::remove() const {
  std::error_code ignored;
  for (const char* suffix : {"", "-journal", "-wal", "-shm"}) {
    fs::remove(path_.string() + suffix, ignored);
  }
}

bool is_temporary_of(const fs::path& final_path, const std::string& file_name) {
  return file_name.starts_with(prefix_of_temporaries(final_path)) &&
         file_name.find(temporary_suffix) != std::string::npos;
}

bool is_temporary(const std::string& file_name) {
  return file_name.starts_with('.') && file_name.find(temporary_suffix) != std::string::npos;
}

bool rename_to_free(const fs::path& from, const fs::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) {
    return true;
  }
  if (errno != EEXIST) {
    throw cannot_be_made(to);
  }
  return false;
}

std::string date_in_file_name() {
  std::string date = utc_now();
  std::ranges::replace(date, ':', '-');  // some file systems have no names with a colon
  return date;
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

}  // namespace foveola::study
