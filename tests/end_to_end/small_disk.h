// A disk of a few megabytes, which a test can fill.
#pragma once

#include <filesystem>
#include <string>

namespace foveola::test {

/// From the first call on this process and those that it starts see mounts of which no other knows.
/// Returns why that is not permitted here; empty if it is. Call it before there are threads.
std::string refusal_of_own_mounts();

/// A file system in memory at a folder, for a process with mounts of its own.
class SmallDisk {
 public:
  /// Makes the folder. Throws std::runtime_error if nothing can be mounted there.
  explicit SmallDisk(std::filesystem::path folder);
  ~SmallDisk();
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  const std::filesystem::path& folder() const { return folder_; }
  /// A file takes all the room that there is.
  void fill() const;
  /// The file is gone again.
  void make_room() const;

 private:
  std::filesystem::path filling() const { return folder_ / "filling"; }

  std::filesystem::path folder_;
};

}  // namespace foveola::test
