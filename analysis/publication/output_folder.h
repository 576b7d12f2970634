// The folder that results are written to.
#pragma once

#include <filesystem>
#include <vector>

namespace foveola::analysis {

/// Throws Error unless make_output_folder and writing into the folder would succeed, so that a bad
/// output is refused before long work.
void check_output_folder(const std::filesystem::path& folder);

/// Makes the folder if its parent exists. Throws Error if it cannot be made or is a file.
void make_output_folder(const std::filesystem::path& folder);

/// Stages files for an output folder: they are written elsewhere on the same disk first, so that a
/// full disk or an error leaves the folder as it was, or absent.
class StagedFolder {
 public:
  /// Throws Error as make_output_folder does, or if nothing can be written into `folder`.
  explicit StagedFolder(std::filesystem::path folder);
  StagedFolder(const StagedFolder&) = delete;
  StagedFolder& operator=(const StagedFolder&) = delete;
  /// Removes files that were not published.
  ~StagedFolder();
  /// The folder to write the files into.
  const std::filesystem::path& path() const { return staging_; }
  /// Makes the output folder if it does not exist, moves these files of path() into it, in this
  /// order, and returns their new paths. Throws Error if the folder cannot be made or a file cannot
  /// be replaced.
  std::vector<std::filesystem::path> publish(const std::vector<std::filesystem::path>& files);

 private:
  std::filesystem::path folder_;
  std::filesystem::path staging_;
};

}  // namespace foveola::analysis
