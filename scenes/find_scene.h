// From a scene's name to the file and the viewpoint: the way in which all other modules find
// scenes.
#pragma once

#include <string>

#include "renderer/base/scene_source.h"

namespace foveola::scenes {

/// Finds the scene `name_or_path`. A name is that of a descriptor scenes/NAME.toml: a built-in
/// scene is made now unless it lies in the cache; a real one is looked for in the folders of
/// $FOVEOLA_SCENE_PATH (separated by ':', searched with one level of subfolders). A path to a .glb
/// or .gltf file takes its viewpoint from the descriptor of a real scene that names this file, or
/// of the built-in scene that it is a copy of or, by its name, a variant of. Loading another file
/// than the described one gives a warning (SceneSource::described_sha256). Throws Error if nothing
/// fits, naming the built-in scenes.
SceneSource find_scene(const std::string& name_or_path);

}  // namespace foveola::scenes
