// One program at a time writes to a study.
#pragma once

#include <filesystem>

namespace foveola::study {

/// Holds a study for as long as it lives: a lock on the file STUDY.controller beside it, which says
/// who holds it. The lock ends with its program, however that ends.
class ControllerLock {
 public:
  /// Throws Error, which names the other program, its process, host and user and when it began, if
  /// there is one; or if the file cannot be made.
  explicit ControllerLock(const std::filesystem::path& study);
  ~ControllerLock();
  ControllerLock(const ControllerLock&) = delete;
  ControllerLock& operator=(const ControllerLock&) = delete;

 private:
  std::filesystem::path path_;
  int descriptor_;
};

/// Whether a program holds the study now.
bool is_controlled(const std::filesystem::path& study);

}  // namespace foveola::study
