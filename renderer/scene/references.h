// Resolves a scene file's references to other files. Scene files are untrusted: references stay
// inside the scene's folder. They may hold paths of another machine, or of another folder.
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
/// (RFC 3986) names, as by local_reference(). Without an exact match, a unique match in another
/// case (ASCII) counts, but not in folders that are symbolic links. Throws std::runtime_error with
/// the reason if `uri` has a scheme other than "file:", leads out of the folder through a symbolic
/// link, or names no regular file.
std::filesystem::path confined_file(const std::filesystem::path& folder, std::string_view uri);

/// The same file; nullopt if it does not exist.
std::optional<std::filesystem::path> confined_file_if_there(const std::filesystem::path& folder,
                                                            std::string_view uri);

/// Whether a decoded reference leads out of its file's folder: through "..", or as a path of
/// another machine (absolute, of a drive such as "C:\maps", or of the scheme "file:").
bool is_foreign_reference(std::string_view name);

/// The decoded reference `name` of a file in `subfolder` ("" or "sub/folder/"), seen from the
/// folder above. Paths of another machine stay as they are.
std::string reference_from(std::string_view subfolder, std::string_view name);

/// The path to search for the decoded reference `name` in its file's folder: normalised, with
/// slashes as separators. For a path that leads out, only its file name.
std::string local_reference(std::string_view name);

/// Warns if a reference that leads out of the folder and another become one file here.
class ForeignReferences {
 public:
  void add(std::string_view name, Warnings& warnings);

 private:
  std::map<std::string, std::string, std::less<>> name_by_local_;
};

}  // namespace foveola
