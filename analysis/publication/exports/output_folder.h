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

struct PublishedFiles {
  /// The manifest and the files, in their order.
  std::vector<std::filesystem::path> files;
  /// Files of an earlier analysis that this one does not write, and that stay: they were changed
  /// since, or a link leads to them.
  std::vector<std::filesystem::path> staying;
};

/// Stages files for an output folder: they are written into a hidden folder in it first, so that a
/// full disk or an error leaves the folder as it was, or absent. The folder is locked meanwhile,
/// and what a killed program staged there is removed.
class StagedFolder {
 public:
  /// Throws Error as make_output_folder does, or if nothing can be written into `folder`, or if
  /// another program stages files for it.
  explicit StagedFolder(const std::filesystem::path& folder);
  StagedFolder(const StagedFolder&) = delete;
  StagedFolder& operator=(const StagedFolder&) = delete;
  /// Removes files that were not published, and a new folder that nothing was published in.
  ~StagedFolder();
  /// The folder to write the files into.
  const std::filesystem::path& path() const { return staging_; }
  /// Moves these files of path() into the output folder, in this order, and removes what an earlier
  /// analysis wrote there and this one does not, by the folder's manifest, which then names these
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
