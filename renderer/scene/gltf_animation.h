// Puts the nodes of a glTF file where its animations have them at one moment.
#pragma once

#include "renderer/scene/warnings.h"

namespace tinygltf {
class Model;
}

namespace foveola {

/// Sets translations, rotations, scales and weights of `model`'s nodes to what all its animations
/// have at `time_s`, one animation after the other in the file's order: where two move the same,
/// the later holds. Before its first key and after its last a value stays what it is there. Steps,
/// lines and cubic splines as the specification has them (Khronos, glTF 2.0.1, appendix C).
/// Channels of other properties, and of nodes that have a matrix, are ignored with a warning.
/// Throws GltfFault if keys are missing or too many.
void pose_at(tinygltf::Model& model, double time_s, Warnings& warnings);

}  // namespace foveola
