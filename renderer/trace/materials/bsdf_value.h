// Inputs and outputs of a BSDF; Fresnel reflectances: Schlick's approximation for metals and coats,
// exact for glass.
#pragma once

#include <cmath>

#include "renderer/base/numbers/lanes.h"
#include "renderer/base/vec.h"

namespace foveola {

/// Schlick's interpolation weight between reflectance at normal and at grazing incidence (Schlick
/// 1994, eq. 15). cosine: in [0, 1]; a number, or lanes of them.
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

/// Fresnel reflection of unpolarised light at a smooth interface of two dielectrics.
struct FresnelSplit {
  float reflected = 1.0F;           ///< share of the power, in [0, 1]
  float transmitted_cosine = 0.0F;  ///< between the refracted direction and the normal; 0: total
                                    ///< reflection
};

/// Snell's law and Fresnel's equations (Born and Wolf, section 1.5.2). cosine: of the incidence, in
/// [0, 1]. eta: index of refraction of the far side over that of the near side, > 0; at 1 light
/// passes unchanged.
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

/// A material's values at one point, textures included.
struct Reflectance {
  Rgb base_color{1.0F};  ///< linear, in [0, 1]
  float metallic = 0.0F;
  float roughness = 1.0F;     ///< perceptual, in [0, 1]
  float ior = 1.5F;           ///< >= 1
  float specular = 1.0F;      ///< in [0, 1]
  Rgb specular_color{1.0F};   ///< >= 0
  float transmission = 0.0F;  ///< in [0, 1]
  bool is_solid = false;      ///< transmitted light is refracted; otherwise the wall is thin
  bool from_inside = false;   ///< the outgoing direction lies in the solid
  float clearcoat = 0.0F;     ///< in [0, 1]
  float clearcoat_roughness = 0.0F;
  Rgb sheen_color{0.0F};  ///< in [0, 1]
  float sheen_roughness = 0.0F;
};

/// Schlick reflectance of a dielectric coat, at normal and at grazing incidence.
struct CoatReflectance {
  Rgb normal;
  float grazing;
};
inline CoatReflectance coat_reflectance(const Reflectance& reflectance) {
  return {.normal = reflectance.specular *
                    glm::min(reflectance_at_normal(reflectance.ior) * reflectance.specular_color,
                             Rgb(1.0F)),
          .grazing = reflectance.ior > 1.0F ? reflectance.specular : 0.0F};
}

struct BsdfSample {
  Vec3 incoming;  ///< unit length, local
  Rgb weight;     ///< BSDF times |cosine| over pdf
  float pdf;      ///< per steradian; for a specular sample the probability
  /// The single direction of a perfect mirror or lens, for which eval() is 0.
  bool is_specular = false;
  bool is_transmitted = false;  ///< transmitted; otherwise reflected
  /// Factor of refraction on the radiance: eta^2 (MATERIALS.md), else 1. Roulette divides by it.
  float radiance_scale = 1.0F;
};

/// The BSDF and its sampling density, which share most of their terms. Number: float, or Floats.
template <typename Number>
struct BsdfValueOf {
  Vec3Of<Number> times_cosine{};  ///< BSDF times the incoming direction's cosine
  Number pdf{};                   ///< per steradian, of sample() for that direction

  BsdfValueOf& operator+=(const BsdfValueOf& other) {
    times_cosine = times_cosine + other.times_cosine;
    pdf += other.pdf;
    return *this;
  }
};
using BsdfValue = BsdfValueOf<float>;

}  // namespace foveola
