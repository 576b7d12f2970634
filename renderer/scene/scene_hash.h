// One SHA-256 over all files that a scene was loaded from.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace foveola {

/// SHA-256s by file path.
using FileHashes = std::map<std::filesystem::path, std::string>;

/// The scene file's own SHA-256 if it refers to no others. Else the SHA-256 of all files' digests,
/// one per line, the scene file's first and the others' in the order of their paths: the output of
/// `sha256sum FILE... | cut -c-64 | sha256sum`.
std::string scene_sha256(const std::string& scene_file_sha256, const FileHashes& referred);

}  // namespace foveola
