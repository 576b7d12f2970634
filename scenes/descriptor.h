// Reads a scene's descriptor, NAME.toml: what is known of a scene before its model file is read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "renderer/base/scene_source.h"

namespace foveola::scenes {

struct Descriptor {
  std::string name;            ///< the name of its file, without .toml
  std::filesystem::path path;  ///< the descriptor
  std::string author;          ///< may be empty
  std::string licence;         ///< may be empty
  std::string origin;          ///< web page of a real scene; may be empty
  std::string counterpart;     ///< built-in scene in place of a real one; may be empty
  bool is_builtin = false;
  std::string file_name;  ///< name of a real scene's .glb, .gltf or .obj
  /// SHA-256 and size of the file that the descriptor was written for; empty and 0 if not stated.
  std::string sha256;
  std::uint64_t size_bytes = 0;
  std::string address;  ///< URL of the scene's file; may be empty
  SceneSource source;   ///< everything but the file
};

/// Reads one descriptor. Throws Error with file:line:column for bad TOML, an unknown key, a wrong
/// type, or a value that is out of range or contradicts others.
Descriptor read_descriptor(const std::filesystem::path& file);

/// Parses the text of a descriptor; `file` names it in errors and gives its name and folder. Throws
/// as read_descriptor.
Descriptor parse_descriptor(const std::filesystem::path& file, const std::string& text);

/// Returns whether the TOML file has a key that only descriptors have. Throws Error as
/// read_descriptor does for bad TOML.
bool is_descriptor(const std::filesystem::path& file);

/// Returns whether the size and SHA-256 of `file` match the descriptor. One that it does not state
/// matches. Throws Error if the file cannot be read.
bool is_described_file(const Descriptor& descriptor, const std::filesystem::path& file);

}  // namespace foveola::scenes
