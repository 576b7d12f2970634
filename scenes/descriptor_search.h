// Where descriptors are looked for: the user's own, and those that come with Foveola.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scenes/descriptor.h"

namespace foveola::scenes {

/// Whether `text` may name a scene, as opposed to a path: it has no '/' and begins with no dot.
bool is_scene_name(const std::string& text);

/// The descriptor `name` among the program's own, if there is one. Throws Error if it is bad.
std::optional<Descriptor> find_descriptor(const std::string& name);

/// The descriptor `name` among the user's, which lie in fetched_folder(), if there is one. Throws
/// Error if it is bad.
std::optional<Descriptor> find_users_descriptor(const std::string& name);

/// The descriptor `name` in `folder`, where TOML files of any kind may lie: those that are no
/// descriptors are passed over. Throws Error if it is bad, or bad TOML.
std::optional<Descriptor> find_descriptor_in(const std::filesystem::path& folder,
                                             const std::string& name);

/// The descriptor that lies beside a scene's file under its name, and names it, if there is one.
/// Throws Error if it is bad.
std::optional<Descriptor> descriptor_beside(const std::filesystem::path& scene_file);

/// Whether a descriptor came with the program.
bool is_programs_own(const Descriptor& descriptor);

struct DescriptorList {
  std::vector<Descriptor> descriptors;  ///< by name
  std::vector<std::string> faults;      ///< what is wrong with those that cannot be read
};

/// All descriptors of the program's own.
DescriptorList all_descriptors();

/// The user's. None if there is no such folder.
DescriptorList users_descriptors();

/// The names of both, for messages.
std::vector<std::string> known_scene_names();

}  // namespace foveola::scenes
