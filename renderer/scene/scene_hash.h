// One SHA-256 for all the files that a scene was loaded from.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace foveola {

/// SHA-256s by the path of the file.
using FileHashes = std::map<std::filesystem::path, std::string>;

/// The scene file's own SHA-256 where it refers to no others. Else that of the text of all of them,
/// a line each, the scene file's first and the others' in the order of their paths, which is what
/// `sha256sum FILE... | cut -c-64 | sha256sum` prints.
std::string scene_sha256(const std::string& scene_file_sha256, const FileHashes& referred);

}  // namespace foveola
