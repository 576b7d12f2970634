// What goes into a BSDF and what comes out of it.
#pragma once

#include "renderer/base/lanes.h"
#include "renderer/base/vec.h"
#include "renderer/trace/fresnel.h"

namespace foveola {

/// A material's values at one point, textures included.
struct Reflectance {
  Rgb base_color{1.0F};  ///< linear, in [0, 1]
  float metallic = 0.0F;
  float roughness = 1.0F;     ///< perceptual, in [0, 1]
  float ior = 1.5F;           ///< >= 1
  float specular = 1.0F;      ///< in [0, 1]
  Rgb specular_color{1.0F};   ///< >= 0
  float transmission = 0.0F;  ///< in [0, 1]
  bool is_solid = false;      ///< what is transmitted is refracted; else the wall is thin
  bool from_inside = false;   ///< the outgoing direction lies in the solid
  float clearcoat = 0.0F;     ///< in [0, 1]
  float clearcoat_roughness = 0.0F;
  Rgb sheen_color{0.0F};  ///< in [0, 1]
  float sheen_roughness = 0.0F;
};

/// Schlick's reflectance of a dielectric's coat, at normal and at grazing incidence.
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
  float pdf;      ///< per steradian; of a specular sample the probability
  /// The direction is the only one of a perfect mirror or lens: eval() knows nothing of it.
  bool is_specular = false;
  bool is_transmitted = false;  ///< through the surface; else it is reflected
  /// How much transmission has scaled the radiance: eta^2 when refracted (MATERIALS.md), else 1.
  /// Roulette takes it out again.
  float radiance_scale = 1.0F;
};

/// The BSDF and its sampling density, which share nearly all of their terms. Number: float, or
/// Floats.
template <typename Number>
struct BsdfValueOf {
  Vec3Of<Number> times_cosine{};  ///< BSDF times the incoming direction's cosine
  Number pdf{};                   ///< per steradian, with which sample() gives that direction

  BsdfValueOf& operator+=(const BsdfValueOf& other) {
    times_cosine = times_cosine + other.times_cosine;
    pdf += other.pdf;
    return *this;
  }
};
using BsdfValue = BsdfValueOf<float>;

}  // namespace foveola
