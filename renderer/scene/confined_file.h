// Keeps the references of a scene file inside the scene's own folder: scene files are untrusted.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

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

}  // namespace foveola
