// Files: where the program finds its own, reading whole files, and replacing files in one step so
// that none is ever half-written.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace foveola {

/// The folder that holds protocols/, scenes/ and data/: $FOVEOLA_RESOURCES, else share/foveola
/// beside the installed program, else the source tree it was built from. Throws Error if none
/// exists.
std::filesystem::path resource_folder();

/// Where things that can be made again are kept: $XDG_CACHE_HOME/foveola, else ~/.cache/foveola.
std::filesystem::path cache_folder();

/// Where things that the user fetched are kept: $XDG_DATA_HOME/foveola, else
/// ~/.local/share/foveola.
std::filesystem::path data_folder();

/// The whole content of a regular file. Throws Error, naming the path, if it is missing, a folder,
/// unreadable or out of reach.
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

/// Throws Error unless a file at `path` could be written: its folder exists and is writable, and
/// it is no folder itself. For refusing a bad output before the work instead of after it.
void require_writable(const std::filesystem::path& path);

/// Calls `write` with the path of a temporary file beside `path`, which then takes the place of
/// `path` in one step. If `write` throws, nothing is left behind. The temporary name keeps the
/// extension of `path`. Throws Error if the folder does not exist or cannot be written.
void replace_file(const std::filesystem::path& path,
                  const std::function<void(const std::filesystem::path&)>& write);

/// replace_file with the bytes of `content`.
void write_file(const std::filesystem::path& path, std::string_view content);

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
