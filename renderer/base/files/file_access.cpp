#include "renderer/base/files/file_access.h"

#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include "renderer/base/text/print.h"

namespace fs = std::filesystem;

namespace foveola {
namespace {

constexpr const char* access_list = "system.posix_acl_access";

bool is_shared_by_a_group(const fs::path& folder) {
  struct stat status{};
  return ::stat(folder.empty() ? "." : folder.c_str(), &status) == 0 &&
         (status.st_mode & S_ISGID) != 0;
}

void warn(const fs::path& path, const char* what, const char* program) {
  print_text(stderr,
             "foveola: warning: {}: its {} could not be given to the new file ({}); use {}\n",
             path.string(), what, std::generic_category().message(errno), program);
}

/// Empty if there is none, or if the file system does not support them.
std::string access_list_of(const fs::path& path) {
  const ssize_t size = ::getxattr(path.c_str(), access_list, nullptr, 0);
  if (size <= 0) {
    return {};
  }
  std::string list(static_cast<std::size_t>(size), '\0');
  return ::getxattr(path.c_str(), access_list, list.data(), list.size()) == size ? list
                                                                                 : std::string();
}

struct GuardedOutput {
  std::string option;
  fs::path path;
  dev_t device;
  ino_t inode;
};

std::vector<GuardedOutput>& guarded_outputs() {
  static std::vector<GuardedOutput> outputs;
  return outputs;
}

}  // namespace

bool make_new_file(const fs::path& path, FileAccess access) {
  constexpr mode_t all = 0666;
  constexpr mode_t own = 0600;
  constexpr mode_t group = 0660;
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC,
                                access == FileAccess::default_access ? all : own);
  if (descriptor < 0) {
    return false;
  }
  if (access == FileAccess::own && is_shared_by_a_group(path.parent_path())) {
    ::fchmod(descriptor, group);
  }
  ::close(descriptor);
  return true;
}

void take_access(const fs::path& path, const fs::path& like) {
  struct stat wanted{};
  struct stat given{};
  if (::lstat(like.c_str(), &wanted) != 0 || !S_ISREG(wanted.st_mode) ||
      ::lstat(path.c_str(), &given) != 0) {
    return;
  }
  constexpr auto keep = static_cast<uid_t>(-1);
  if (wanted.st_gid != given.st_gid && ::lchown(path.c_str(), keep, wanted.st_gid) != 0) {
    warn(like, "group", "chgrp");
  }
  if (wanted.st_uid != given.st_uid && ::lchown(path.c_str(), wanted.st_uid, keep) != 0) {
    warn(like, "owner", "chown");
  }
  constexpr mode_t permissions = 07777;
  if (::chmod(path.c_str(), wanted.st_mode & permissions) != 0) {
    warn(like, "mode", "chmod");
  }
  if (const std::string list = access_list_of(like);
      !list.empty() && ::setxattr(path.c_str(), access_list, list.data(), list.size(), 0) != 0) {
    warn(like, "access list", "setfacl");
  }
}

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

void guard_output(const std::string& option, const fs::path& path) {
  // Open until the program ends, so that no other file gets the inode once this one is replaced.
  const int descriptor = ::open(path.c_str(), O_PATH | O_CLOEXEC);
  if (descriptor < 0) {
    return;
  }
  struct stat status{};
  if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) {
    ::close(descriptor);
    return;
  }
  guarded_outputs().push_back(
      {.option = option, .path = path, .device = status.st_dev, .inode = status.st_ino});
}

void require_no_output(const fs::path& input) {
  struct stat status{};
  if (guarded_outputs().empty() || ::stat(input.c_str(), &status) != 0) {
    return;
  }
  for (const GuardedOutput& output : guarded_outputs()) {
    if (output.device == status.st_dev && output.inode == status.st_ino) {
      throw OutputIsInput(output.option,
                          fmt::format("{} is read by the command, too", output.path.string()),
                          "name another file");
    }
  }
}

}  // namespace foveola
