// Reads a scene's descriptor, NAME.toml: the facts that are known before its file is opened.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "renderer/base/scene_source.h"

namespace foveola::scenes {

struct Descriptor {
  std::string name;            ///< the name of its file, without .toml
  std::filesystem::path path;  ///< this file
  std::string author;          ///< may be empty, as the next three
  std::string licence;
  std::string origin;       ///< the page of a real scene
  std::string counterpart;  ///< the built-in scene that replaces a real one
  bool is_builtin = false;
  std::string file_name;  ///< name of a real scene's .glb, .gltf or .obj
  /// SHA-256 and size of the file that the descriptor was written for; empty and 0 if not stated.
  std::string sha256;
  std::uint64_t size_bytes = 0;
  std::string address;  ///< URL of this file; may be empty
  SceneSource source;   ///< everything but the file
};

/// Reads one descriptor. Throws Error with file:line:column for bad TOML, an unknown key, a wrong
/// type, or a value that is out of range or contradicts others.
Descriptor read_descriptor(const std::filesystem::path& file);

/// As above, for the text of a descriptor to be written to `file`.
Descriptor descriptor_of_text(const std::filesystem::path& file, const std::string& text);

/// Returns whether the TOML file has a key that only descriptors have. Throws Error as
/// read_descriptor does for bad TOML.
bool is_descriptor(const std::filesystem::path& file);

/// Returns whether `file` is the one that the descriptor was written for, by its size and SHA-256.
/// Throws Error if it cannot be read.
bool is_described_file(const Descriptor& descriptor, const std::filesystem::path& file);

}  // namespace foveola::scenes
