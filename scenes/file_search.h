// Finds the files of real scenes.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace foveola::scenes {

/// Extensions of scenes' files, in the order in which a name is tried with them.
inline constexpr std::array scene_extensions{".glb", ".gltf", ".obj"};

/// Returns whether the file has a scene's extension, in any letter case.
bool is_called_like_scene(const std::filesystem::path& file);

struct FileSearch {
  std::optional<std::filesystem::path> file;
  /// A line per folder that could not be searched, and per match that is not a file. Empty if the
  /// file was found.
  std::vector<std::string> obstacles;
};

/// Finds the file of that name in `folder` or one folder below.
FileSearch search_folder(const std::filesystem::path& folder, const std::string& file_name);

/// Finds the file of that name in the folders of $FOVEOLA_SCENE_PATH, their subfolders, or among
/// fetched files.
FileSearch search_scene_path(const std::string& file_name);

/// Returns the folder of fetched scenes: scenes/ in the user's data folder.
std::filesystem::path fetched_folder();

/// Returns " (OBSTACLE; OBSTACLE)", to follow the report of a missing file; empty if there are
/// none.
std::string in_brackets(const std::vector<std::string>& obstacles);

}  // namespace foveola::scenes
