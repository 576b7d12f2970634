// Writes a model as a binary glTF 2.0 file, the form in which everything enters the renderer.
#pragma once

#include <string>

#include "scenes/modelling/model.h"

namespace foveola::scenes {

/// The .glb file of `model`: the same bytes for the same model. Images are embedded as PNG, each
/// object is a node with a mesh, each camera a node with a camera; emission beyond 1 uses
/// KHR_materials_emissive_strength, glass and varnish are KHR_materials_transmission and
/// _clearcoat. (glTF 2.0 specification, Khronos 2021, sections 3 and 4.)
std::string glb_from(const Model& model);

}  // namespace foveola::scenes
