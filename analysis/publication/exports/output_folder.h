// Writes results into a folder, atomically as far as a file system allows.
#pragma once

#include <filesystem>
#include <vector>

namespace foveola::analysis {

/// Throws Error unless make_output_folder and writing into the folder would succeed. Call it before
/// long work.
void check_output_folder(const std::filesystem::path& folder);

/// Makes the folder if its parent exists. Throws Error if it cannot be made or is a file.
void make_output_folder(const std::filesystem::path& folder);

struct PublishedFiles {
  /// The manifest and the files, in their order.
  std::vector<std::filesystem::path> files;
  /// Files of an earlier analysis that this one does not write but leaves: they were changed since,
  /// or are reached by a link.
  std::vector<std::filesystem::path> staying;
};

/// Stages files for an output folder. They are first written into a hidden folder in it, so that a
/// full disk or an error leaves the folder as it was, or absent. The folder is locked meanwhile,
/// and staged files of killed programs are removed.
class StagedFolder {
 public:
  /// Throws Error as make_output_folder does, or if `folder` cannot be written, or if another
  /// program stages files for it.
  explicit StagedFolder(const std::filesystem::path& folder);
  StagedFolder(const StagedFolder&) = delete;
  StagedFolder& operator=(const StagedFolder&) = delete;
  /// Removes unpublished files, and a new folder in which nothing was published.
  ~StagedFolder();
  const std::filesystem::path& path() const { return staging_; }
  /// Moves these files of path() into the output folder, in this order. Removes files of an earlier
  /// analysis that this one does not write, by the folder's manifest, which then names the new
  /// files. After a kill in between, the next call removes the rest. Throws Error if a file cannot
  /// be replaced or removed.
  PublishedFiles publish(const std::vector<std::filesystem::path>& files);

 private:
  /// Stages nothing yet.
  StagedFolder(std::filesystem::path folder, bool is_new);

  std::filesystem::path folder_;
  bool is_new_;
  int lock_ = -1;
  std::filesystem::path staging_;
};

}  // namespace foveola::analysis
