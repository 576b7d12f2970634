// The other model of a glTF material, from before there was KHR_materials_specular.
#pragma once

#include "renderer/scene/gltf/material_context.h"
#include "renderer/scene/scene.h"

namespace tinygltf {
struct Material;
}

namespace foveola {

/// Whether `source` has KHR_materials_pbrSpecularGlossiness, which then takes the place of its
/// metallic-roughness values, as the extension says.
bool has_specular_glossiness(const tinygltf::Material& source);

/// Reads it into `material`, but for the alpha mode: a dielectric that reflects the specular colour
/// at normal incidence, which is exact (KHR_materials_specular's colour may exceed 1), over the
/// diffuse one, with a roughness of 1 - glossiness; a texture's is rounded to 8 bits. Where the
/// extension scales the diffuse colour by 1 - the largest specular component, this renderer's
/// dielectric takes what it reflects at each angle.
void read_specular_glossiness(const tinygltf::Material& source, MaterialContext& context,
                              Material& material);

}  // namespace foveola
