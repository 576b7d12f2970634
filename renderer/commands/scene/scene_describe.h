// `foveola scene describe`: writes a descriptor of a user's own scene, with objects to choose from.
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "renderer/base/scene_source.h"

namespace CLI {
class App;
}

namespace foveola {

/// Returns the text of a scene's descriptor, with a remark for each of its objects.
using DescriptorText =
    std::function<std::string(const SceneSource& source, const std::vector<std::string>& remarks)>;

/// Adds `describe` to `scene`; see add_render.
void add_scene_describe(CLI::App& scene, const DescriptorText& descriptor_text,
                        const std::stop_token& stop);

}  // namespace foveola
