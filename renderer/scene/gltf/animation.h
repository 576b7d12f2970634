// Puts the nodes of a glTF file where its animations have them at one moment.
#pragma once

#include <string>
#include <vector>

#include "renderer/scene/gltf/model.h"
#include "renderer/scene/warnings.h"

namespace foveola {

/// A name for each animation, no two of them equal: its own, or one made up.
std::vector<std::string> clip_names(const GltfModel& model);

/// Sets translations, rotations, scales and weights of `model`'s nodes to what its animation `clip`
/// has at `time_s`, or, if that is empty, all of them, one after the other in the file's order:
/// where two move the same, the later holds, with a warning. Before its first key and after its
/// last a value stays what it is there. Steps, lines and cubic splines as the specification has
/// them (Khronos, glTF 2.0.1, appendix C). Channels of other properties, and of nodes that have a
/// matrix, are ignored with a warning. Throws UsageError for a clip that the file has not, and
/// GltfFault if keys are missing, too many or not in the order of their times.
void pose_at(GltfModel& model, double time_s, const std::string& clip, Warnings& warnings);

}  // namespace foveola
