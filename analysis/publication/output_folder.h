// The folder that results go to.
#pragma once

#include <filesystem>
#include <vector>

namespace foveola::analysis {

/// Throws Error unless make_output_folder and writing into the folder would succeed: for refusing a
/// bad output before long work.
void check_output_folder(const std::filesystem::path& folder);

/// Makes the folder if its parent exists. Throws Error if it cannot be made or is a file.
void make_output_folder(const std::filesystem::path& folder);

/// Files on their way into an output folder: they are written elsewhere on the same disk first, so
/// that a full disk or an error leaves the folder as it was, or not there.
class StagedFolder {
 public:
  /// Throws Error as make_output_folder does, or if nothing can be written into `folder`.
  explicit StagedFolder(std::filesystem::path folder);
  StagedFolder(const StagedFolder&) = delete;
  StagedFolder& operator=(const StagedFolder&) = delete;
  ~StagedFolder();  ///< removes what was not published

  const std::filesystem::path& path() const { return staging_; }  ///< where to write

  /// Makes the folder if it is not there, moves these files of path() into it, in this order, and
  /// returns where they are now. Throws Error if the folder cannot be made or a file be replaced.
  std::vector<std::filesystem::path> publish(const std::vector<std::filesystem::path>& files);

 private:
  std::filesystem::path folder_;
  std::filesystem::path staging_;
};

}  // namespace foveola::analysis
