// Fresnel's reflectance: Schlick's approximation for metals and coats, the exact one for glass.
#pragma once

#include <cmath>

namespace foveola {

/// How far Schlick's Fresnel reflectance is on its way from its value at normal incidence to that
/// at grazing incidence (Schlick 1994, eq. 15). cosine: in [0, 1]; a number, or lanes of them.
template <typename Number>
Number schlick_weight(const Number& cosine) {
  const Number complement = 1.0F - cosine;
  const Number squared = complement * complement;
  return squared * squared * complement;
}

/// Reflectance at normal incidence of a dielectric in air. ior: >= 1.
inline float reflectance_at_normal(float ior) {
  const float root = (ior - 1.0F) / (ior + 1.0F);
  return root * root;
}

/// A clear coat's reflectance (KHR_materials_clearcoat): Schlick's of index 1.5. cosine: in [0, 1].
inline float clearcoat_reflectance(float cosine) {
  const float normal = reflectance_at_normal(1.5F);
  return normal + (1.0F - normal) * schlick_weight(cosine);
}

/// What a smooth interface between two dielectrics does to unpolarised light.
struct FresnelSplit {
  float reflected = 1.0F;           ///< share of the power, in [0, 1]
  float transmitted_cosine = 0.0F;  ///< between the refracted direction and the normal; 0: total
                                    ///< reflection
};

/// Snell's law and Fresnel's equations (Born and Wolf, section 1.5.2). cosine: of the incidence, in
/// [0, 1]. eta: index of refraction of the far side over that of the near side, > 0; at 1 nothing
/// is reflected or bent.
inline FresnelSplit fresnel_split(float cosine, float eta) {
  const float root = (eta - 1.0F) * (eta + 1.0F) + cosine * cosine;
  if (root <= 0.0F) {
    return {.reflected = eta == 1.0F ? 0.0F : 1.0F};
  }
  const float transmitted = std::sqrt(root) / eta;
  const float senkrecht = (cosine - eta * transmitted) / (cosine + eta * transmitted);
  const float parallel = (eta * cosine - transmitted) / (eta * cosine + transmitted);
  return {.reflected = 0.5F * (senkrecht * senkrecht + parallel * parallel),
          .transmitted_cosine = transmitted};
}

}  // namespace foveola
