// KHR_lights_punctual's lights, placed in the world.
#pragma once

#include <vector>

#include "renderer/base/vec.h"
#include "renderer/scene/gltf_nodes.h"
#include "renderer/scene/scene.h"
#include "renderer/scene/warnings.h"

namespace foveola {

/// The lights that shine, their positions seen from `origin`. A light's colour times its intensity
/// is taken as radiant intensity or irradiance as it stands: the extension's photometric units are
/// not converted, as emissive materials have none either. It shines along its node's -Z, and
/// nothing else of the node's transform but its position counts.
std::vector<PunctualLight> read_lights(const tinygltf::Model& model,
                                       const std::vector<PlacedItem>& lights, const DVec3& origin,
                                       Warnings& warnings);

}  // namespace foveola
