// Resolves a scene file's references to other files. Scene files are untrusted: references stay
// inside the scene's folder. They may hold paths of another machine.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "renderer/scene/warnings.h"

namespace foveola {

/// `uri` with percent-encoded bytes decoded (RFC 3986, section 2.1).
std::string percent_decoded(std::string_view uri);

/// The regular file inside `folder` (or a folder of it) that the percent-encoded reference `uri`
/// (RFC 3986) names, as by local_reference(). Throws std::runtime_error with the reason if it has a
/// scheme other than "file:", contains "..", leads out of the folder through a symbolic link, or is
/// not a regular file.
std::filesystem::path confined_file(const std::filesystem::path& folder, std::string_view uri);

/// The same file; nullopt if `uri` stays in the folder and names a file that does not exist.
std::optional<std::filesystem::path> confined_file_if_there(const std::filesystem::path& folder,
                                                            std::string_view uri);

/// Whether a decoded reference is a path of another machine: absolute, of a drive ("C:\maps"), or
/// of the scheme "file:".
bool is_foreign_reference(std::string_view name);

/// The path to search for the decoded reference `name` in its file's folder: with slashes as
/// separators. For a path of another machine, only its file name.
std::string local_reference(std::string_view name);

/// Warns if files of two folders of another machine have one name, and so become one here.
class ForeignReferences {
 public:
  void add(std::string_view name, Warnings& warnings);

 private:
  std::map<std::string, std::string, std::less<>> foreign_by_local_;
};

}  // namespace foveola
