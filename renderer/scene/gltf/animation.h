// Poses the nodes of a glTF file by its animations at one time.
#pragma once

#include <string>
#include <vector>

#include "renderer/scene/gltf/model.h"
#include "renderer/scene/warnings.h"

namespace foveola {

/// A unique name for each animation: its own, or a generated one.
std::vector<std::string> clip_names(const GltfModel& model);

/// Sets translations, rotations, scales and weights of `model`'s nodes to those of animation `clip`
/// at `time_s`. An empty `clip` applies all animations in the file's order: of two for the same
/// property the later wins, with a warning. Values are constant before the first key and after the
/// last. Interpolates steps, lines and cubic splines as in the specification (Khronos, glTF 2.0.1,
/// appendix C). Channels of other properties, and of nodes that have a matrix, are ignored with a
/// warning. Throws UsageError for an unknown clip, and GltfFault if keys are missing, too many or
/// out of order.
void pose_at(GltfModel& model, double time_s, const std::string& clip, Warnings& warnings);

}  // namespace foveola
