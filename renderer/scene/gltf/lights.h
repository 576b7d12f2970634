// KHR_lights_punctual's lights, placed in the world.
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

/// What the lights of a file with this `asset.generator` are given in, as far as that says it.
/// Blender's exporter ("Khronos glTF Blender I/O v3.4.50") multiplies them by 683 lm/W since its
/// version 3.4.40, the first after its pull request 1760, unless it is set to export "Unitless" or
/// "Raw", which leaves no trace in the file. Whatever else wrote a file: radiometric.
LightUnits light_units_of(std::string_view generator);

/// How spots of a file with this `asset.generator` fade: Blender's exporter writes the angles of
/// Cycles's cones, which have an edge of their own (its kernel/light/spot.h; measured with Blender
/// 3.4); whatever else wrote a file, as the extension recommends.
PunctualLight::ConeEdge cone_edge_of(std::string_view generator);

/// The half angle within which a spot of Cycles is at its brightest, from the angles that Blender's
/// exporter writes, whose inner one is outer * (1 - blend): Cycles fades over the share `blend` of
/// what lies between the cosine of the outer angle and 1. 0 <= inner <= outer, outer > 0.
double cycles_inner_cone_rad(double inner_rad, double outer_rad);

/// The lights that shine, their positions seen from `origin`. A light's colour times its intensity,
/// in `units`, becomes radiant intensity or irradiance. If absent, the units are those of the
/// file's generator, with a warning where that changes anything. A light shines along its node's
/// -Z, and nothing else of the node's transform but its position counts. Its size is what its
/// "extras" say (renderer/GLTF.md), since the extension has no sizes; else it has none.
std::vector<PunctualLight> read_lights(const GltfModel& model,
                                       const std::vector<PlacedItem>& lights, const DVec3& origin,
                                       std::optional<LightUnits> units, Warnings& warnings);

}  // namespace foveola
