#include "study/record/temporary_database.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <random>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "renderer/base/clock.h"
#include "renderer/base/error.h"
#include "renderer/base/file_access.h"
#include "renderer/base/files.h"

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

/// The process whose temporary has this name, as new_temporary() gives it; 0 for any other name.
pid_t process_of(const std::string& file_name) {
  const std::size_t end = file_name.rfind(temporary_suffix);
  const std::size_t point = end == std::string::npos ? end : file_name.rfind('.', end - 1);
  if (!file_name.starts_with('.') || point == std::string::npos) {
    return 0;
  }
  pid_t process = 0;
  const char* const past = file_name.data() + end;
  const auto [dash, failure] = std::from_chars(file_name.data() + point + 1, past, process);
  constexpr std::ptrdiff_t dash_and_digits = 17;
  return failure == std::errc() && *dash == '-' && past - dash == dash_and_digits ? process : 0;
}

/// Removes what killed programs of this machine have left in a folder.
void remove_leftovers(const fs::path& folder) {
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    const pid_t process = process_of(entry.path().filename().string());
    if (process > 0 && ::kill(process, 0) != 0 && errno == ESRCH) {
      fs::remove(entry.path(), ignored);
    }
  }
}

fs::path new_temporary(const fs::path& final_path) {
  std::random_device random;  // of the operating system
  return folder_of(final_path) / fmt::format("{}{}-{:08x}{:08x}{}",
                                             prefix_of_temporaries(final_path), ::getpid(),
                                             random(), random(), temporary_suffix);
}

}  // namespace

TemporaryDatabase::TemporaryDatabase(const fs::path& final_path)
    : final_path_(final_path), path_(new_temporary(final_path)) {
  remove_leftovers(folder_of(final_path));
  if (!make_new_file(path_, FileAccess::own)) {
    throw cannot_be_made(final_path);
  }
}

TemporaryDatabase::~TemporaryDatabase() { remove(); }

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
