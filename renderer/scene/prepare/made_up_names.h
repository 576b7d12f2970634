// Generates names for unnamed things of a scene, so that users can choose among them.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/scene/scene.h"

namespace foveola {

/// "KIND NUMBER", preceded by as many "another" as needed to differ from `taken`. Adds the name to
/// `taken`.
std::string made_up_name(std::string_view kind, std::size_t number, std::set<std::string>& taken);

/// `names` made unique: an empty or repeated name is replaced by one made up of `kind` and its
/// number, counted from 1.
std::vector<std::string> distinct_names(std::vector<std::string> names, std::string_view kind);

/// A unique name for each camera: its own if possible, else a made-up one of "camera".
std::vector<std::string> camera_names(const std::vector<CameraView>& cameras);

}  // namespace foveola
