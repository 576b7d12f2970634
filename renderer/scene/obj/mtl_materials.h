// Converts the statements of a material library to this renderer's materials.
#pragma once

#include <functional>
#include <string>

#include "renderer/scene/obj/mtl_file.h"
#include "renderer/scene/obj/textures.h"
#include "renderer/scene/scene.h"
#include "renderer/scene/warnings.h"

namespace foveola {

/// OBJ's "white material", for faces without a known material: a Lambertian surface.
Material default_obj_material();

/// Finds the file of a texture statement, as written; empty leaves the texture out. Throws Error if
/// it must not be read.
using ObjTextureFinder = std::function<std::filesystem::path(const std::string& name)>;

/// The material that `source` describes; its textures are added to `textures`. place: of the
/// material, for warnings. All are double-sided, since OBJ has no others.
///
/// - Kd and map_Kd: a Lambertian surface, exactly, unless one of the following holds. A Kd of zero
///   under a map counts as white, as other importers have it.
/// - Ks with an illum of 2 or more, or none: a dielectric's reflection of strength and colour Ks
///   over it, with GGX alpha = sqrt(2 / (Ns + 2)), the width of Blinn and Phong's lobe (Walter et
///   al. 2007, "Microfacet Models for Refraction through Rough Surfaces", section 5.2).
/// - illum 3 or 5, Ks and a Kd of at most 0.001: a smooth metal of base colour Ks and map_Ks.
/// - illum 6, 7 or 9, or 4 with Ni > 1 and either d < 1 or a Tf that is not white: solid smooth
///   glass of index Ni and base colour Tf.
/// - Pr, Pm, Ps, Pc, Pcr, their maps and norm (the extension for physically based rendering):
///   roughness, metalness, sheen, clearcoat and its roughness, normal texture, over Kd. A bump map
///   in colours is a normal texture, too.
/// - Ke and map_Ke: emitted radiance. map_d: a cut-out at 0.5; d otherwise: the probability that
///   the surface is there.
Material material_of(const MtlMaterial& source, const ObjTextureFinder& find_texture,
                     ObjTextureSet& textures, const std::string& place, Warnings& warnings);

}  // namespace foveola
