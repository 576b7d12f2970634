// References of a scene file to others. They are kept inside the scene's own folder, since scene
// files are untrusted, and may be written for another machine, whose paths mean nothing here.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "renderer/scene/warnings.h"

namespace foveola {

/// `uri` with each percent sign and two hexadecimal digits replaced by the byte that they name (RFC
/// 3986, section 2.1).
std::string percent_decoded(std::string_view uri);

/// The regular file inside `folder` (or a folder of it) that the percent-encoded reference `uri`
/// (RFC 3986) names, as local_reference() has it. Throws std::runtime_error that says why if it has
/// a scheme other than "file:", contains "..", leads out of the folder through a symbolic link, or
/// is not a regular file.
std::filesystem::path confined_file(const std::filesystem::path& folder, std::string_view uri);

/// The same file, or nothing if `uri` stays in the folder and names a file that does not exist.
std::optional<std::filesystem::path> confined_file_if_there(const std::filesystem::path& folder,
                                                            std::string_view uri);

/// Whether a decoded reference is a path of another machine: absolute, of a drive ("C:\maps"), or
/// of the scheme "file:".
bool is_foreign_reference(std::string_view name);

/// What the decoded reference `name` is looked for as, in the folder of the file that has it: with
/// slashes between folders, and of a path of another machine the name of its file alone.
std::string local_reference(std::string_view name);

/// Warns where files of two folders of another machine have one name, and so become one here.
class ForeignReferences {
 public:
  void add(std::string_view name, Warnings& warnings);

 private:
  std::map<std::string, std::string, std::less<>> foreign_by_local_;
};

}  // namespace foveola
