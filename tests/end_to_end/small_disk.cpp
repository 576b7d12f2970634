#include "tests/end_to_end/small_disk.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sched.h>
#include <sys/mount.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace foveola::test {
namespace {

/// Room for a study of some trials and its backups.
constexpr const char* size_option = "size=64m";

std::string failure_of(const char* what) { return fmt::format("{}: {}", what, strerror(errno)); }

/// The user stays who they are; whoever may not mount needs that to be root of their own users.
void map_own_user(uid_t user, gid_t group) {
  std::ofstream("/proc/self/setgroups") << "deny";
  std::ofstream("/proc/self/uid_map") << fmt::format("{0} {0} 1", user);
  std::ofstream("/proc/self/gid_map") << fmt::format("{0} {0} 1", group);
}

std::string begin_own_mounts() {
  const uid_t user = ::geteuid();
  const gid_t group = ::getegid();
  if (::unshare(CLONE_NEWNS) != 0) {
    if (::unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) {
      return failure_of("this process may not have mounts of its own");
    }
    map_own_user(user, group);
  }
  if (::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0) {
    return failure_of("its mounts cannot be kept from others");
  }
  return "";
}

}  // namespace

std::string refusal_of_own_mounts() {
  static const std::string refusal = begin_own_mounts();
  return refusal;
}

SmallDisk::SmallDisk(fs::path folder) : folder_(std::move(folder)) {
  fs::create_directory(folder_);
  if (::mount("tmpfs", folder_.c_str(), "tmpfs", 0, size_option) != 0) {
    throw std::runtime_error(failure_of("no disk"));
  }
}

SmallDisk::~SmallDisk() { ::umount2(folder_.c_str(), MNT_DETACH); }

void SmallDisk::fill() const {
  constexpr std::array<char, 65536> bytes{};
  const int file = ::open(filling().c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  while (::write(file, bytes.data(), bytes.size()) > 0) {
  }
  const bool is_full = errno == ENOSPC;
  ::close(file);
  if (!is_full) {
    throw std::runtime_error("the disk does not become full");
  }
}

void SmallDisk::make_room() const { fs::remove(filling()); }

}  // namespace foveola::test
