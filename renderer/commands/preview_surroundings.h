// What the preview's camera knows of the scene in which it moves.
#pragma once

#include "renderer/progressive/loaded_scene.h"
#include "renderer/window/free_camera.h"

namespace foveola {

/// They refer to the scene, which must outlive them.
CameraSurroundings surroundings_of(const LoadedScene& loaded);

}  // namespace foveola
