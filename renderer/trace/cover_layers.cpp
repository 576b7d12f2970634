#include "renderer/trace/cover_layers.h"

#include <algorithm>
#include <numbers>

#include "renderer/trace/fresnel.h"

namespace foveola {
namespace {

constexpr float clearcoat_ior = 1.5F;
constexpr float uniform_hemisphere_pdf = 0.5F * std::numbers::inv_pi_v<float>;

}  // namespace

CoverLayers::CoverLayers(const Reflectance& reflectance, const Vec3& outgoing, float base_albedo,
                         const ScatteringTables& tables)
    : clearcoat_(reflectance.clearcoat_roughness, outgoing),
      clearcoat_strength_(reflectance.clearcoat),
      sheen_(reflectance.sheen_roughness, outgoing) {
  float clearcoat_albedo = 0.0F;
  if (clearcoat_strength_ > 0.0F) {
    const SchlickAlbedo albedo = tables.ggx().row(reflectance.clearcoat_roughness).at(outgoing.z);
    clearcoat_albedo =
        clearcoat_strength_ * albedo.with(reflectance_at_normal(clearcoat_ior), 1.0F);
    base_scale_ = 1.0F - clearcoat_albedo;
  }
  float sheen_albedo = 0.0F;
  const float strongest_sheen = max_component(reflectance.sheen_color);
  if (strongest_sheen > 0.0F) {
    const float white = tables.sheen().of(sheen_, reflectance.sheen_roughness, outgoing.z);
    // Where the fit's masking lets more than all light through, it is scaled down to all.
    sheen_color_ = reflectance.sheen_color * (base_scale_ / std::max(white, 1.0F));
    sheen_albedo = luminance(sheen_color_) * white;
    base_scale_ *= 1.0F - strongest_sheen * std::min(white, 1.0F);
  }
  const float total = clearcoat_albedo + sheen_albedo + base_scale_ * base_albedo;
  if (total > 0.0F) {
    clearcoat_probability_ = clearcoat_albedo / total;
    sheen_probability_ = sheen_albedo / total;
  }
}

float CoverLayers::clearcoat_reflectance(float cosine) const {
  return clearcoat_strength_ *
         glm::mix(reflectance_at_normal(clearcoat_ior), 1.0F, schlick_weight(cosine));
}

BsdfValue CoverLayers::over(const BsdfValue& base, const Vec3& incoming) const {
  BsdfValue value{.times_cosine = base_scale_ * base.times_cosine,
                  .pdf = base_probability() * base.pdf};
  if (clearcoat_strength_ > 0.0F && !clearcoat_.is_smooth()) {
    const MicrofacetLobe::Facets facets = clearcoat_.facets(incoming);
    value.times_cosine += Rgb(clearcoat_reflectance(facets.cosine) * facets.times_cosine);
    value.pdf += clearcoat_probability_ * facets.pdf;
  }
  if (sheen_probability_ > 0.0F) {
    value.times_cosine += sheen_color_ * sheen_.times_cosine(incoming);
    value.pdf += sheen_probability_ * uniform_hemisphere_pdf;
  }
  return value;
}

}  // namespace foveola
