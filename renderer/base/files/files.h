// Files: where the program finds its own, reading whole files, and replacing files in one step so
// that none is ever half-written.
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

/// Where things that can be made again are kept: $XDG_CACHE_HOME/foveola, else ~/.cache/foveola.
std::filesystem::path cache_folder();

/// Where things that the user fetched are kept: $XDG_DATA_HOME/foveola, else
/// ~/.local/share/foveola.
std::filesystem::path data_folder();

/// The whole content of a regular file. Throws Error, naming the path, if it is missing, a folder,
/// a pipe or a device, unreadable or out of reach.
std::string read_file(const std::filesystem::path& path);

/// The same, in place of what `content` held, whose memory is used again.
void read_file(const std::filesystem::path& path, std::string& content);

/// The same of a file of at most `most_bytes`. Throws Error with `remedy` for a larger one, of
/// which no more are read.
std::string read_file(const std::filesystem::path& path, std::size_t most_bytes,
                      const std::string& remedy);

/// The extension of a file's name with its dot, its ASCII letters in lower case: formats are told
/// apart by it.
std::string lower_case_extension(const std::filesystem::path& file);

/// Throws Error unless a file at `path`, or where a symbolic link there leads to, could be written:
/// its folder exists and is writable, and it is no folder, pipe or device itself. For refusing a
/// bad output before the work instead of after it.
void require_writable(const std::filesystem::path& path);

/// Syncs what was written to a file, or the names in a folder: they are on the disk when this
/// returns. Throws Error if they cannot be.
void sync_to_disk(const std::filesystem::path& path);

/// A new file that is to take the place of another, or of what a symbolic link there leads to, in
/// the same folder and with the same extension. No other process has its name, on whatever machine.
/// What is there goes at the end of the scope; what a killed program leaves there is hidden and
/// called ".partial", and is never looked for.
class TemporaryFile {
 public:
  /// Throws Error if the folder of `final_path` does not exist or cannot be written.
  explicit TemporaryFile(std::filesystem::path final_path, FileAccess access = FileAccess::usual);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::filesystem::path& path() const { return path_; }

  /// Takes the final path's place in one step, and whoever could read that can read this. What was
  /// written is on the disk before, and under its name when this returns, so that losing power
  /// leaves the former file or all of the new one. Throws Error if it cannot.
  void replace_final() const;

 private:
  std::filesystem::path final_path_;
  std::filesystem::path path_;
};

/// Calls `write` with the path of a TemporaryFile, which then takes the place of `path`. If `write`
/// throws, nothing is left behind. access: of a new file; one that is there keeps its own. Throws
/// Error if the folder does not exist or cannot be written.
void replace_file(const std::filesystem::path& path,
                  const std::function<void(const std::filesystem::path&)>& write,
                  FileAccess access = FileAccess::usual);

/// replace_file with the bytes of `content`.
void write_file(const std::filesystem::path& path, std::string_view content,
                FileAccess access = FileAccess::usual);

/// A new, empty folder among the system's temporary ones. It goes, with all that is in it, at the
/// end of the scope.
class ScratchFolder {
 public:
  /// Throws Error if none can be made.
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

}  // namespace foveola
