// Tests of permissions have to fail for root as well, who may do anything.
#pragma once

#include <filesystem>

#include <sys/fsuid.h>
#include <unistd.h>

namespace foveola::test {

/// While it lives, this thread opens and lists files as nobody would if it runs as root. Others run
/// without privileges anyway.
class Unprivileged {
 public:
  Unprivileged() {
    if (::geteuid() == 0) {
      ::setfsuid(nobody);
    }
  }
  ~Unprivileged() { ::setfsuid(::geteuid()); }
  Unprivileged(const Unprivileged&) = delete;
  Unprivileged& operator=(const Unprivileged&) = delete;

 private:
  static constexpr uid_t nobody = 65534;
};

/// A folder or file that nobody may open, list or look into, as long as this lives.
class Locked {
 public:
  explicit Locked(std::filesystem::path path) : path_(std::move(path)) {
    std::filesystem::permissions(path_, std::filesystem::perms::none);
  }
  ~Locked() {
    std::error_code ignored;
    std::filesystem::permissions(path_, std::filesystem::perms::owner_all, ignored);
  }
  Locked(const Locked&) = delete;
  Locked& operator=(const Locked&) = delete;

 private:
  std::filesystem::path path_;
};

/// A folder that everybody may list and nobody write into, as long as this lives.
class ReadOnly {
 public:
  explicit ReadOnly(std::filesystem::path path) : path_(std::move(path)) {
    using std::filesystem::perms;
    constexpr perms look = perms::owner_read | perms::group_read | perms::others_read;
    constexpr perms enter = perms::owner_exec | perms::group_exec | perms::others_exec;
    std::filesystem::permissions(path_, look | enter);
  }
  ~ReadOnly() {
    std::error_code ignored;
    std::filesystem::permissions(path_, std::filesystem::perms::owner_all, ignored);
  }
  ReadOnly(const ReadOnly&) = delete;
  ReadOnly& operator=(const ReadOnly&) = delete;

 private:
  std::filesystem::path path_;
};

/// What a new temporary folder is not: open to others.
inline void open_to_all(const std::filesystem::path& folder) {
  std::filesystem::permissions(folder, std::filesystem::perms::all);
}

}  // namespace foveola::test
