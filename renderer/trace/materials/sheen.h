// Sheen: light scattered by the fibres of cloth, mostly at grazing angles.
#pragma once

#include <vector>

#include "renderer/base/vec.h"
#include "renderer/base/work/parallel.h"

namespace foveola {

/// The Charlie microfacets of Estevez and Kulla 2017, "Production Friendly Microfacet Sheen BRDF",
/// as in KHR_materials_sheen: no Fresnel, no softened terminator. All directions are local, unit
/// length, z > 0.
class CharlieSheen {
 public:
  /// roughness: perceptual, in [0, 1]; values below min_roughness are raised to it.
  CharlieSheen(float roughness, const Vec3& outgoing);

  /// BSDF times the incoming direction's cosine, for the sheen colour 1.
  float times_cosine(const Vec3& incoming) const;

  /// The factor that does not depend on the incoming direction: 1 / (4 cosine (1 + Lambda)).
  float outgoing_factor() const { return 0.25F / (outgoing_.z * (1.0F + lambda_outgoing_)); }

  /// Finer fibres would reflect only within 4 degrees of the surface.
  static constexpr float min_roughness = 0.07F;

 private:
  /// Smith's Lambda, their fit (eq. 3 and table 1).
  float lambda(float cosine) const;
  float lambda_exponent(float cosine) const;

  Vec3 outgoing_;
  float inverse_alpha_;
  float a_, b_, c_, d_, e_;
  float lambda_outgoing_;
};

/// The directional albedo of white sheen: a table, within 5e-4 of the integral. For fine fibres at
/// grazing angles it exceeds 1.
class SheenAlbedo {
 public:
  explicit SheenAlbedo(const Workers& workers);

  /// roughness: of `sheen`. cosine: of its outgoing direction.
  float of(const CharlieSheen& sheen, float roughness, float cosine) const;

 private:
  /// Row-major: roughness, cosine. The albedo divided by outgoing_factor().
  std::vector<float> nodes_;
};

}  // namespace foveola
