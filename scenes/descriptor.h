// What is known of a scene before its file is opened: a descriptor, NAME.toml.
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
  std::string counterpart;  ///< the built-in scene that stands in for a real one
  bool is_builtin = false;
  std::string file_name;  ///< name of a real scene's .glb, .gltf or .obj
  /// SHA-256 and size of the file that the descriptor was written for; empty and 0 if not stated.
  std::string sha256;
  std::uint64_t size_bytes = 0;
  std::string address;  ///< where this file can be downloaded; empty if nowhere
  SceneSource source;   ///< all but the file
};

/// Reads one descriptor. Throws Error with file:line:column for bad TOML, an unknown key, a wrong
/// type, a value out of range or what makes no sense.
Descriptor read_descriptor(const std::filesystem::path& file);

/// The same of the text of a descriptor that is to be written to `file`.
Descriptor descriptor_of_text(const std::filesystem::path& file, const std::string& text);

/// Whether the TOML file has a key that only descriptors have. Throws Error as read_descriptor does
/// for bad TOML.
bool is_descriptor(const std::filesystem::path& file);

/// Whether `file` is the one that the descriptor was written for, by its size and SHA-256. Throws
/// Error if it cannot be read.
bool is_described_file(const Descriptor& descriptor, const std::filesystem::path& file);

}  // namespace foveola::scenes
