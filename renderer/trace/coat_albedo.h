// How much light the specular coat of a dielectric reflects in all, which the layer below does not
// get.
#pragma once

#include <vector>

#include "renderer/base/parallel.h"

namespace foveola {

/// Reflectance at normal incidence of glTF's dielectrics (index of refraction 1.5).
constexpr float dielectric_f0 = 0.04F;

/// The directional albedo E(cosine, roughness) of the rough dielectric coat: GGX, height-correlated
/// Smith masking, Schlick's Fresnel with dielectric_f0. A table, within 0.001 of the integral, or
/// 0.01 where the cosine is under 0.05.
class CoatAlbedo {
 public:
  explicit CoatAlbedo(const Workers& workers);

  /// E as a function of the cosine, for one roughness.
  class Row {
   public:
    /// cosine: between the normal and the direction, in [0, 1].
    float at(float cosine) const;
    /// 2 * integral of E(c) c dc over [0, 1], of just the values that at() gives.
    float mean() const { return mean_; }

   private:
    friend class CoatAlbedo;
    const float* rougher_ = nullptr;
    const float* smoother_ = nullptr;
    float rougher_weight_ = 0.0F;
    float mean_ = 0.0F;
  };

  /// roughness: perceptual, in [0, 1]. The row is valid as long as the table.
  Row row(float roughness) const;

 private:
  std::vector<float> albedos_;  ///< row-major: roughness, square root of the cosine
  std::vector<float> means_;    ///< one a roughness
};

}  // namespace foveola
