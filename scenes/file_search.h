// Where the files of real scenes are looked for.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace foveola::scenes {

/// The extensions of scenes' files, in the order in which a name is tried with them.
inline constexpr std::array scene_extensions{".glb", ".gltf", ".obj"};

/// Whether the file is called like one of a scene, in whatever case its extension is.
bool is_called_like_scene(const std::filesystem::path& file);

struct FileSearch {
  std::optional<std::filesystem::path> file;
  /// One line for each folder that could not be searched, and for what bears the name without being
  /// a file. Empty where the file was found.
  std::vector<std::string> obstacles;
};

/// The file of that name in `folder` or one folder below.
FileSearch search_folder(const std::filesystem::path& folder, const std::string& file_name);

/// The file of that name in the folders of $FOVEOLA_SCENE_PATH, their subfolders, or among what was
/// fetched.
FileSearch search_scene_path(const std::string& file_name);

/// Where fetched scenes are kept: scenes/ in the user's data folder.
std::filesystem::path fetched_folder();

/// " (OBSTACLE; OBSTACLE)", to follow what says that a file was not found; empty if there are none.
std::string in_brackets(const std::vector<std::string>& obstacles);

}  // namespace foveola::scenes
