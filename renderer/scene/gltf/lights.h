// Reads the lights of KHR_lights_punctual, placed in the world.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "renderer/base/scene_source.h"
#include "renderer/base/vec.h"
#include "renderer/scene/gltf/nodes.h"
#include "renderer/scene/scene.h"
#include "renderer/scene/warnings.h"

namespace foveola {

/// The light units of files with this `asset.generator`. Blender's exporter ("Khronos glTF Blender
/// I/O v3.4.50") multiplies them by 683 lm/W since its version 3.4.40, the first after its pull
/// request 1760. Its settings "Unitless" and "Raw" do not, and leave no trace in the file. All
/// other generators: radiometric.
LightUnits light_units_of(std::string_view generator);

/// The spots' cone edge in files with this `asset.generator`. Blender's exporter writes the angles
/// of Cycles's cones, which have an edge of their own (its kernel/light/spot.h; measured with
/// Blender 3.4). All other generators: as the extension recommends.
PunctualLight::ConeEdge cone_edge_of(std::string_view generator);

/// The half angle of a Cycles spot's full intensity, from the angles that Blender's exporter
/// writes. Its inner angle is outer * (1 - blend), while Cycles fades over the share `blend` of the
/// interval from the outer angle's cosine to 1. 0 <= inner <= outer, outer > 0.
double cycles_inner_cone_rad(double inner_rad, double outer_rad);

/// The lights that emit, positioned relative to `origin`. Colour times intensity, in `units`,
/// becomes radiant intensity or irradiance. Default units: those of the file's generator, with a
/// warning if that changes anything. A light emits along its node's -Z; of the node's transform
/// only position and direction count. Its size is given by its "extras" (renderer/GLTF.md), since
/// the extension has none; default 0.
std::vector<PunctualLight> read_lights(const GltfModel& model,
                                       const std::vector<PlacedItem>& lights, const DVec3& origin,
                                       std::optional<LightUnits> units, Warnings& warnings);

}  // namespace foveola
