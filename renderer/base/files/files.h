// Files: the program's folders, reading whole files, and atomic replacement of files.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "renderer/base/files/file_access.h"

namespace foveola {

/// The folder that holds protocols/, scenes/ and data/: $FOVEOLA_RESOURCES, else share/foveola
/// where Foveola was installed, else the source tree it was built from. Throws Error if none
/// exists.
std::filesystem::path resource_folder();

/// The folder of reproducible files: $XDG_CACHE_HOME/foveola, else ~/.cache/foveola.
std::filesystem::path cache_folder();

/// The folder of downloaded files: $XDG_DATA_HOME/foveola, else ~/.local/share/foveola.
std::filesystem::path data_folder();

/// Returns the whole content of a regular file. Throws Error, naming the path, if it is missing, a
/// folder, a pipe or a device, unreadable or inaccessible.
std::string read_file(const std::filesystem::path& path);

/// Reads the file into `content`, whose memory is reused. Throws as above.
void read_file(const std::filesystem::path& path, std::string& content);

/// Returns the content of a file of at most `max_bytes`. Throws as above, and Error with `remedy`
/// for a larger one, after reading no more than that.
std::string read_file(const std::filesystem::path& path, std::size_t max_bytes,
                      const std::string& remedy);

/// Returns the extension of a file's name with its dot, ASCII letters in lower case.
std::string lower_case_extension(const std::filesystem::path& file);

/// Throws Error unless a file at `path`, or at the target of a symbolic link there, could be
/// written. Its folder must exist and be writable; it must not be a folder, pipe or device. Refuses
/// a bad output before the work instead of after it.
void require_writable(const std::filesystem::path& path);

/// Syncs a file's content, or a folder's names, to the disk before it returns. Throws Error if it
/// cannot.
void sync_to_disk(const std::filesystem::path& path);

/// A new file in the folder of the file that it is to replace, or of a symbolic link's target, with
/// the same extension. Its name is unique among processes on all machines. Removed at the end of
/// the scope. A killed program leaves a hidden file called ".partial", which is never read.
class TemporaryFile {
 public:
  /// Throws Error if the folder of `final_path` does not exist or cannot be written.
  explicit TemporaryFile(std::filesystem::path final_path,
                         FileAccess access = FileAccess::default_access);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::filesystem::path& path() const { return path_; }

  /// Replaces the final path in one step, keeping that file's access. The content is synced before,
  /// and the name when this returns: after a power loss either the former file or all of the new
  /// one is there. Throws Error if it cannot.
  void replace_final() const;

 private:
  std::filesystem::path final_path_;
  std::filesystem::path path_;
};

/// Calls `write` with the path of a TemporaryFile, which then takes the place of `path`. If `write`
/// throws, nothing is left behind. access: of a new file; an existing one keeps its own. Throws
/// Error if the folder does not exist or cannot be written.
void replace_file(const std::filesystem::path& path,
                  const std::function<void(const std::filesystem::path&)>& write,
                  FileAccess access = FileAccess::default_access);

/// replace_file with the bytes of `content`.
void write_file(const std::filesystem::path& path, std::string_view content,
                FileAccess access = FileAccess::default_access);

/// A new, empty folder among the system's temporary ones, removed with its content at the end of
/// the scope.
class ScratchFolder {
 public:
  /// Throws Error if it cannot be made.
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

}  // namespace foveola
