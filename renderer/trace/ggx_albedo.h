// How much light a rough surface reflects at its first bounce: what is missing is given back to
// metals, and what a coat does not reflect goes to the layer below.
#pragma once

#include <cstddef>
#include <vector>

#include "renderer/base/parallel.h"
#include "renderer/base/vec.h"

namespace foveola {

/// A directional albedo of the GGX lobe for any Schlick Fresnel: f0 (white - grazing) + f90
/// grazing.
struct SchlickAlbedo {
  float white = 1.0F;    ///< with a Fresnel reflectance of 1
  float grazing = 0.0F;  ///< with Schlick's weight for the Fresnel reflectance

  float with(float f0, float f90) const { return f0 * (white - grazing) + f90 * grazing; }
};

/// The albedo's table over roughness and the cosine of the direction. Within 1e-4 of the integral.
class GgxAlbedo {
 public:
  explicit GgxAlbedo(const Workers& workers);

  /// The albedo as a function of the cosine, for one roughness.
  class Row {
   public:
    /// cosine: between the normal and the direction, in [0, 1].
    SchlickAlbedo at(float cosine) const;
    /// 2 * integral of albedo(c) c dc over [0, 1]: the albedo under a uniform sky.
    const SchlickAlbedo& mean() const { return mean_; }

   private:
    friend class GgxAlbedo;
    const Vec2* smoother_ = nullptr;
    float alpha_ = 0.0F;
    float rougher_weight_ = 0.0F;
    SchlickAlbedo mean_;
  };

  /// roughness: perceptual, in [0, 1]; below smallest_roughness it is that of a perfect mirror. The
  /// row is valid as long as the table.
  Row row(float roughness) const;

 private:
  /// Row-major: roughness, position(). x: the white albedo. y: the cosine c' at which Schlick's
  /// weight is the lobe's mean weight, over c + alpha. Against the position both are nearly
  /// straight lines, also for alpha towards 0.
  std::vector<Vec2> nodes_;
  std::vector<SchlickAlbedo> means_;  ///< one a roughness
};

}  // namespace foveola
