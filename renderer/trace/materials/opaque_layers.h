// The reflecting layers of the metallic-roughness model: metal, and a coat over a Lambertian layer.
#pragma once

#include <numbers>

#include "renderer/base/numbers/lanes.h"
#include "renderer/base/vec.h"
#include "renderer/trace/materials/bsdf_value.h"
#include "renderer/trace/materials/ggx.h"
#include "renderer/trace/materials/ggx_albedo.h"

namespace foveola {

/// Minimum cosine of outgoing directions; smaller ones are raised to it.
inline constexpr float min_cosine = 1e-4F;

/// Returns `w` with a cosine raised to min_cosine where it is smaller. Unit length.
template <typename Vector>
inline Vector raised_above_grazing(const Vector& w) {
  const auto is_grazing = w.z < min_cosine;
  if (!any_lane(is_grazing)) {
    return w;
  }
  return chosen(is_grazing, normalized(Vector{w.x, w.y, decltype(w.z){} + min_cosine}), w);
}

/// A direction above the surface with density cosine / pi. u: in [0, 1].
template <typename Number>
inline Vec3Of<Number> sample_cosine_hemisphere(const SinesCosines<Number>& azimuth,
                                               const Number& u) {
  const Number r = square_root(u);
  return {r * azimuth.cosine, r * azimuth.sine, square_root(1.0F - u)};
}

/// A material's values at one point (float), or at eight points (Floats).
template <typename Number>
struct OpaqueValuesOf {
  Vec3Of<Number> base_color;
  Number metallic;
  Vec3Of<Number> coat_f0;  ///< the coat's Schlick reflectance at normal incidence
  Number coat_f90;         ///< the coat's Schlick reflectance at grazing incidence
  Number coated;           ///< share of the surface with a reflecting coat
  Number opaque;           ///< share of the surface with a Lambertian layer under its coat
};

/// The layers for one outgoing direction.
template <typename Number>
class OpaqueLayersOf {
 public:
  using Vector = Vec3Of<Number>;

  /// Without layers; assign before use.
  OpaqueLayersOf() = default;

  /// Only the Lambertian layer.
  explicit OpaqueLayersOf(const Vector& base_color)
      : diffuse_(white_diffuse * base_color),
        diffuse_albedo_(
            chosen((base_color.x == 0.0F) & (base_color.y == 0.0F) & (base_color.z == 0.0F),
                   Number{}, Number{} + 1.0F)) {}

  /// albedo: of the microfacets. cosine: of the outgoing direction, in [min_cosine, 1].
  OpaqueLayersOf(const OpaqueValuesOf<Number>& values, const GgxAlbedo::RowOf<Number>& albedo,
                 const Number& cosine)
      : albedo_(albedo), lobe_(albedo.at(cosine)) {
    const Number base_luminance = luminance(values.base_color);
    if (any_lane(values.metallic < 1.0F)) {
      const Number max_f0 = max_component(values.coat_f0);
      coat_albedo_ = smaller(lobe_.with(max_f0, values.coat_f90), 1.0F);
      const Number below_coat = 1.0F - albedo.mean().with(max_f0, values.coat_f90);
      const auto is_seen = below_coat > darkest_below_coat;
      layer_f0_ = chosen(is_seen, max_f0, Number{});
      layer_f90_ = chosen(is_seen, values.coat_f90, Number{});
      has_coat_ = any_lane((layer_f0_ > 0.0F) | (layer_f90_ > 0.0F));
      const Number layer =
          white_diffuse * (1.0F - coat_albedo_) / chosen(is_seen, below_coat, Number{} + 1.0F);
      diffuse_ = (values.opaque * layer) * values.base_color;
      diffuse_albedo_ = values.opaque * (1.0F - coat_albedo_) * base_luminance;
      const Number grazing = values.coated * values.coat_f90;
      specular_normal_ = values.coated * values.coat_f0;
      specular_grazing_ = {grazing, grazing, grazing};
      specular_albedo_ = values.coated * coat_albedo_;
    }
    if (any_lane(values.metallic > 0.0F)) {
      // Turquin 2019, "Practical Multiple Scattering Compensation for Microfacet Models".
      const Number lost = (1.0F - lobe_.white) / lobe_.white;
      const Vector white{Number{} + 1.0F, Number{} + 1.0F, Number{} + 1.0F};
      const Vector metal = values.metallic * (white + lost * values.base_color);
      specular_normal_ = specular_normal_ + metal * values.base_color;
      specular_grazing_ = specular_grazing_ + metal;
      const Number metal_albedo = base_luminance * (1.0F - lobe_.grazing) + lobe_.grazing;
      specular_albedo_ = specular_albedo_ + values.metallic * metal_albedo;
    }
  }

  /// Albedo of the coat for the outgoing direction.
  const Number& coat_albedo() const { return coat_albedo_; }
  /// Albedo of the microfacets for a Fresnel reflectance of 1.
  const Number& white_albedo() const { return lobe_.white; }
  /// Luminance of the albedo of metal and coat together.
  const Number& specular_albedo() const { return specular_albedo_; }
  /// Luminance of the albedo of the Lambertian layer.
  const Number& diffuse_albedo() const { return diffuse_albedo_; }

  /// Fresnel reflectance of metal and coat together. cosine: between half vector and
  /// direction (see LobeValue).
  Vector reflectance(const Number& cosine) const {
    const Number weight = schlick_weight(cosine);
    return (1.0F - weight) * specular_normal_ + weight * specular_grazing_;
  }

  /// Value of metal and coat, with the lobe's density.
  BsdfValueOf<Number> specular(const typename MicrofacetLobeOf<Number>::LobeValue& lobe) const {
    return {.times_cosine = lobe.times_cosine * reflectance(lobe.cosine), .pdf = lobe.pdf};
  }

  /// Value of the Lambertian layer. cosine: of the incoming direction. probability: of sampling
  /// this layer, in [0, 1]; a factor of the density.
  BsdfValueOf<Number> diffuse(const Number& cosine, const Number& probability) const {
    Number received = cosine;
    if (has_coat_) {
      const Number coat_albedo = albedo_.at(cosine).with(layer_f0_, layer_f90_);
      received = larger(1.0F - coat_albedo, 0.0F) * cosine;
    }
    return {.times_cosine = received * diffuse_, .pdf = probability * cosine * white_diffuse};
  }

 private:
  /// The BSDF of a white Lambertian surface.
  static constexpr float white_diffuse = std::numbers::inv_pi_v<float>;

  /// Minimum mean transmission of the coat: below it, coat and base are not coupled. Such layers
  /// are visible at grazing angles only, and are Lambertian there. The table is too coarse for
  /// quotients of their small transmission.
  static constexpr float darkest_below_coat = 0.02F;

  bool has_coat_ = false;  ///< whether any lane has one
  GgxAlbedo::RowOf<Number> albedo_;
  SchlickAlbedoOf<Number> lobe_;
  Number coat_albedo_{};
  Vector specular_normal_{}, specular_grazing_{};
  Number layer_f0_{}, layer_f90_{};  ///< the coat's strongest channel over the Lambertian layer
  Vector diffuse_{};                 ///< the Lambertian BSDF without the factor (1 - E(incoming))
  Number specular_albedo_{}, diffuse_albedo_{};
};

}  // namespace foveola
