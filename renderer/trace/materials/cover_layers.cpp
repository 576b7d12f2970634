#include "renderer/trace/materials/cover_layers.h"

#include <algorithm>
#include <numbers>

#include "renderer/base/turns.h"
#include "renderer/trace/materials/opaque_layers.h"

namespace foveola {
namespace {

constexpr float uniform_hemisphere_pdf = 0.5F * std::numbers::inv_pi_v<float>;

}  // namespace

CoverLayers::CoverLayers(const Reflectance& reflectance, const Vec3& outgoing,
                         const Vec3& coat_normal, float base_albedo, const ScatteringTables& tables)
    : coat_frame_(coat_normal),
      coat_outgoing_(raised_above_grazing(coat_frame_.to_local(outgoing))),
      clearcoat_(reflectance.clearcoat_roughness, coat_outgoing_),
      clearcoat_strength_(reflectance.clearcoat),
      sheen_(reflectance.sheen_roughness, outgoing) {
  float clearcoat_albedo = 0.0F;
  if (clearcoat_strength_ > 0.0F) {
    const SchlickAlbedo albedo =
        tables.ggx().row(reflectance.clearcoat_roughness).at(coat_outgoing_.z);
    clearcoat_albedo = clearcoat_strength_ * albedo.with(clearcoat_reflectance(1.0F), 1.0F);
    base_scale_ = 1.0F - clearcoat_albedo;
  }
  float sheen_albedo = 0.0F;
  const float strongest_sheen = max_component(reflectance.sheen_color);
  if (strongest_sheen > 0.0F) {
    const float white = tables.sheen().of(sheen_, reflectance.sheen_roughness, outgoing.z);
    // Where the fit's masking gives an albedo above 1, it is scaled down to 1.
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

std::optional<CoverLayers::Mirror> CoverLayers::clearcoat_mirror() const {
  if (!clearcoat_.is_smooth()) {
    return std::nullopt;
  }
  const Vec3 mirrored(-coat_outgoing_.x, -coat_outgoing_.y, coat_outgoing_.z);
  return Mirror{.incoming = coat_frame_.to_world(mirrored),
                .reflectance = clearcoat_strength_ * clearcoat_reflectance(coat_outgoing_.z)};
}

std::optional<Vec3> CoverLayers::sample_clearcoat(const Vec2& u) const {
  const Vec3 incoming = clearcoat_.sample(azimuth_at(u.x), u.y);
  return incoming.z > 0.0F ? std::optional(coat_frame_.to_world(incoming)) : std::nullopt;
}

BsdfValue CoverLayers::over(const BsdfValue& base, const Vec3& incoming) const {
  BsdfValue value{.times_cosine = base_scale_ * base.times_cosine,
                  .pdf = base_probability() * base.pdf};
  const Vec3 coat_incoming = coat_frame_.to_local(incoming);
  if (clearcoat_strength_ > 0.0F && !clearcoat_.is_smooth() && coat_incoming.z > 0.0F) {
    const MicrofacetLobe::LobeValue facets = clearcoat_.eval(coat_incoming);
    value.times_cosine +=
        Rgb(clearcoat_strength_ * clearcoat_reflectance(facets.cosine) * facets.times_cosine);
    value.pdf += clearcoat_probability_ * facets.pdf;
  }
  if (sheen_probability_ > 0.0F && incoming.z > 0.0F) {
    value.times_cosine += sheen_color_ * sheen_.times_cosine(incoming);
    value.pdf += sheen_probability_ * uniform_hemisphere_pdf;
  }
  return value;
}

}  // namespace foveola
