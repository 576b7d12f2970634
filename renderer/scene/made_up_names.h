// Names of what has none in its file, for users who choose among the things of a scene.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/scene/scene.h"

namespace foveola {

/// "KIND NUMBER"; "another KIND NUMBER", and so on, where that is among `taken`, to which the name
/// is added.
std::string made_up_name(std::string_view kind, std::size_t number, std::set<std::string>& taken);

/// A name for each camera, no two of them equal: its own, if it has one that no camera before it
/// has, else one made up of "camera" and its number, counted from 1.
std::vector<std::string> camera_names(const std::vector<CameraView>& cameras);

}  // namespace foveola
