#include "study/record/temporary_database.h"

#include <cerrno>
#include <cstdio>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "renderer/base/error.h"
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

}  // namespace

TemporaryDatabase::TemporaryDatabase(const fs::path& final_path)
    : final_path_(final_path),
      path_(folder_of(final_path) / fmt::format("{}{}{}", prefix_of_temporaries(final_path),
                                                ::getpid(), temporary_suffix)) {
  remove();
}

TemporaryDatabase::~TemporaryDatabase() { remove(); }

void TemporaryDatabase::replace_final() const {
  sync();
  if (::rename(path_.c_str(), final_path_.c_str()) != 0) {
    throw cannot_be_made(final_path_);
  }
  sync_to_disk(folder_of(final_path_));
}

bool TemporaryDatabase::take_free_name() const {
  sync();
  if (::renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, final_path_.c_str(), RENAME_NOREPLACE) != 0) {
    if (errno == EEXIST) {
      return false;
    }
    throw cannot_be_made(final_path_);
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

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

}  // namespace foveola::study
