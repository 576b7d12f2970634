#include "study/record/sqlite/controller_lock.h"

#include <array>
#include <cerrno>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <pwd.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "renderer/base/build_info.h"
#include "renderer/base/clock.h"
#include "renderer/base/error.h"
#include "renderer/base/files/file_access.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

std::string user_name() {
  const passwd* entry = ::getpwuid(::getuid());
  return entry != nullptr ? entry->pw_name : fmt::format("{}", ::getuid());
}

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "an unknown host";
}

/// "foveola 0.1.0, process 4711 of anna on lab-3, since 2026-11-21T09:30:00.123Z"
std::string own_name() {
  return fmt::format("{} {}, process {} of {} on {}, since {}", program_invocation_short_name,
                     build_info().version, ::getpid(), user_name(), host_name(), utc_now());
}

/// What whoever holds the lock wrote; it may not have come to it yet.
std::string holder(int descriptor) {
  std::array<char, 512> text{};
  const ssize_t length = ::pread(descriptor, text.data(), text.size(), 0);
  return length > 0 ? std::string(text.data(), static_cast<std::size_t>(length))
                    : "another program";
}

fs::path lock_file(const fs::path& study) {
  return fs::weakly_canonical(study).string() + ".controller";
}

int open_lock_file(const fs::path& path) {
  make_new_file(path, FileAccess::own);
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (descriptor < 0) {
    throw Error(path.string(),
                fmt::format("cannot be opened: {}",
                            std::error_code(errno, std::generic_category()).message()),
                "check its permissions and its folder's");
  }
  return descriptor;
}

/// Whether the file at `path` is still the open one: whoever had it before may have removed it.
bool is_at(const fs::path& path, int descriptor) {
  struct stat open_file{};
  struct stat named_file{};
  return ::fstat(descriptor, &open_file) == 0 && ::stat(path.c_str(), &named_file) == 0 &&
         open_file.st_dev == named_file.st_dev && open_file.st_ino == named_file.st_ino;
}

/// The descriptor of the lock's file, which it holds.
int lock(const fs::path& path, const fs::path& study) {
  while (true) {
    const int descriptor = open_lock_file(path);
    if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
      const std::string other = holder(descriptor);
      ::close(descriptor);
      throw Error(study.string(), "is being written by " + other,
                  "let that end, or take another file");
    }
    if (is_at(path, descriptor)) {
      return descriptor;
    }
    ::close(descriptor);
  }
}

void write_name(int descriptor) {
  const std::string name = own_name();
  // If the disk is full, the lock holds all the same; only its name is missing.
  if (::ftruncate(descriptor, 0) == 0) {
    [[maybe_unused]] const ssize_t written = ::pwrite(descriptor, name.data(), name.size(), 0);
  }
}

}  // namespace

ControllerLock::ControllerLock(const fs::path& study)
    : path_(lock_file(study)), descriptor_(lock(path_, study)) {
  write_name(descriptor_);
}

ControllerLock::~ControllerLock() {
  std::error_code ignored;
  fs::remove(path_, ignored);
  ::close(descriptor_);
}

bool is_controlled(const fs::path& study) {
  const int descriptor =
      ::open(lock_file(study).c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (descriptor < 0) {
    return false;
  }
  const bool is_free = ::flock(descriptor, LOCK_SH | LOCK_NB) == 0;
  ::close(descriptor);
  return !is_free;
}

}  // namespace foveola::study
