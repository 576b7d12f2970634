// The scenes that come with Foveola, so that demo and tests need no download. Each has a folder
// with its .glb and its descriptor.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace foveola::scenes {

/// Returns the names of the built-in scenes, in alphabetical order.
std::vector<std::string> builtin_names();

bool is_builtin_name(const std::string& name);

/// Returns the folder of the built-in scene `name`: NAME.glb and NAME.toml.
std::filesystem::path builtin_folder(const std::string& name);

/// Returns the .glb of the built-in scene `name`.
std::filesystem::path builtin_file(const std::string& name);

}  // namespace foveola::scenes
