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

/// `names` without two that are equal: one that is empty, or that stands before, becomes one made
/// up of `kind` and its number, counted from 1.
std::vector<std::string> distinct_names(std::vector<std::string> names, std::string_view kind);

/// A name for each camera, no two of them equal: its own where it can be, else one of "camera".
std::vector<std::string> camera_names(const std::vector<CameraView>& cameras);

}  // namespace foveola
