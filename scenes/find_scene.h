// From a scene's name to the file and the viewpoint: the way in which all other modules find
// scenes.
#pragma once

#include <filesystem>
#include <string>

#include "renderer/base/scene_source.h"

namespace foveola::scenes {

/// Finds the scene `name_or_path`. A name is that of a descriptor NAME.toml, the user's own (see
/// fetched_folder) before the program's, or else of a scene file in the user's folder. The file of
/// one of the program's real scenes is looked for in the folders of $FOVEOLA_SCENE_PATH (separated
/// by ':', searched with one level of subfolders). The file of any other descriptor lies in the
/// descriptor's own folder and nowhere else. A path is one of a descriptor, or of a .glb, .gltf or
/// .obj file. Such a file takes its viewpoint from the descriptor beside it of the same name, which
/// must name it; else from the program's descriptor of a real scene that names this file, or of the
/// built-in scene that it is a copy of. Loading another file than the described one gives a warning
/// (SceneSource::described_sha256). Throws Error if nothing fits, naming the built-in scenes or one
/// that may be meant, and for a bad descriptor.
SceneSource find_scene(const std::string& name_or_path);

/// Finds a scene that a file in `folder` names, as a protocol does. Relative paths, and names with
/// an extension, begin in this folder. A name is that of a descriptor in it, or else of a scene
/// file in it, before find_scene() is asked. The protocols that come with Foveola mean the scenes
/// that come with it, whatever the user has under these names.
SceneSource find_scene_beside(const std::string& name_or_path, const std::filesystem::path& folder);

}  // namespace foveola::scenes
