// Finds a scene's file and viewpoint by its name, for all other modules.
#pragma once

#include <filesystem>
#include <string>

#include "renderer/base/scene_source.h"

namespace foveola::scenes {

/// Finds the scene `name_or_path`. A name is that of a descriptor NAME.toml, the user's own (see
/// fetched_folder) before the program's, or else of a scene file in the user's folder. The file of
/// one of the program's real scenes is searched in the folders of $FOVEOLA_SCENE_PATH (separated by
/// ':', with one level of subfolders). The file of any other descriptor is in the descriptor's own
/// folder and nowhere else. A path is one of a descriptor, or of a .glb, .gltf or .obj file. Such a
/// file gets its viewpoint from the descriptor beside it of the same name, which must name it.
/// Otherwise it is that of the program's descriptor of a real scene that names this file, or of the
/// built-in scene that it is a copy of. Loading another file than the described one gives a warning
/// (SceneSource::described_sha256). Throws Error if nothing fits, with the built-in scenes or a
/// similar name, and for a bad descriptor.
SceneSource find_scene(const std::string& name_or_path);

/// Finds a scene named by a file in `folder`, such as a protocol. Relative paths, and names with an
/// extension, begin in this folder. A name is that of a descriptor in it, or else of a scene file
/// in it, before find_scene() is asked. Foveola's own protocols use its own scenes, whatever the
/// user has under these names.
SceneSource find_scene_beside(const std::string& name_or_path, const std::filesystem::path& folder);

}  // namespace foveola::scenes
