// The KHR_materials extensions of glTF's metallic-roughness material.
#pragma once

#include "renderer/scene/gltf/material_context.h"
#include "renderer/scene/scene.h"

namespace tinygltf {
struct Material;
}

namespace foveola {

/// emissiveFactor times KHR_materials_emissive_strength's factor.
Rgb emission_of(const tinygltf::Material& source, MaterialContext& context);

/// Reads KHR_materials_ior, _transmission, _volume, _specular, _clearcoat and _sheen into
/// `material`. A texture whose factor is 0 is not used.
void read_material_extensions(const tinygltf::Material& source, MaterialContext& context,
                              Material& material);

}  // namespace foveola
