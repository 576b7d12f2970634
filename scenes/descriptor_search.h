// Finds descriptors: the user's own, and those that come with Foveola.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scenes/descriptor.h"

namespace foveola::scenes {

/// Returns whether `text` may name a scene, not a path: it has no '/' and does not begin with a
/// dot.
bool is_scene_name(const std::string& text);

/// Returns the descriptor `name` among the program's own; empty if there is none. Throws Error if
/// it is bad.
std::optional<Descriptor> find_descriptor(const std::string& name);

/// Returns the descriptor `name` among the user's, in fetched_folder(); empty if there is none.
/// Throws Error if it is bad.
std::optional<Descriptor> find_users_descriptor(const std::string& name);

/// Returns the descriptor `name` in `folder`, which may hold TOML files of any kind: those that are
/// not descriptors are skipped. Throws Error if it is bad, or bad TOML.
std::optional<Descriptor> find_descriptor_in(const std::filesystem::path& folder,
                                             const std::string& name);

/// Returns the descriptor beside a scene's file with its name, if it names the file; else empty.
/// Throws Error if it is bad.
std::optional<Descriptor> descriptor_beside(const std::filesystem::path& scene_file);

/// Returns whether a descriptor came with the program.
bool is_programs_own(const Descriptor& descriptor);

struct DescriptorList {
  std::vector<Descriptor> descriptors;  ///< by name
  std::vector<std::string> faults;      ///< faults of those that cannot be read
};

DescriptorList all_descriptors();

/// Returns the user's descriptors; none if there is no such folder.
DescriptorList users_descriptors();

std::vector<std::string> known_scene_names();

}  // namespace foveola::scenes
