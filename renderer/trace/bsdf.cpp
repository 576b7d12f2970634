#include "renderer/trace/bsdf.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace foveola {
namespace {

constexpr float inverse_pi = std::numbers::inv_pi_v<float>;
constexpr float smallest_cosine = 1e-4F;

Vec3 sample_cosine_hemisphere(const Vec2& u) {
  const float r = std::sqrt(u.y);
  const float azimuth = 2.0F * std::numbers::pi_v<float> * u.x;
  return {r * std::cos(azimuth), r * std::sin(azimuth), std::sqrt(1.0F - u.y)};
}

Vec3 raised_above_grazing(const Vec3& w) {
  return w.z >= smallest_cosine ? w : glm::normalize(Vec3(w.x, w.y, smallest_cosine));
}

}  // namespace

Bsdf::Bsdf(const Reflectance& reflectance, const Vec3& outgoing, const CoatAlbedo& coat)
    : outgoing_(raised_above_grazing(outgoing)),
      ggx_(ggx_of_roughness(reflectance.roughness)),
      lambda_outgoing_(ggx_.lambda(outgoing_)),
      coat_(coat.row(reflectance.roughness)),
      specular_f0_(glm::mix(Rgb(dielectric_f0), reflectance.base_color, reflectance.metallic)) {
  const float coat_albedo = coat_.at(outgoing_.z);
  const Rgb diffuse_albedo = (1.0F - reflectance.metallic) * reflectance.base_color;
  diffuse_ = diffuse_albedo * (inverse_pi * (1.0F - coat_albedo) / (1.0F - coat_.mean()));

  const Rgb metal_albedo = glm::mix(reflectance.base_color, Rgb(1.0F), schlick_weight(outgoing_.z));
  const float specular = glm::mix(coat_albedo, luminance(metal_albedo), reflectance.metallic);
  const float diffuse = (1.0F - coat_albedo) * luminance(diffuse_albedo);
  const float total = specular + diffuse;
  specular_probability_ = total > 0.0F ? specular / total : 1.0F;
}

BsdfValue Bsdf::eval(const Vec3& incoming) const {
  if (!(incoming.z > 0.0F)) {
    return {};
  }
  const Vec3 half = glm::normalize(outgoing_ + incoming);
  const float cosine_half = std::min(glm::dot(outgoing_, half), 1.0F);
  // Both share D / (4 cos(outgoing)); the masking is G2 in the BSDF and G1 in the density of
  // visible normals (Heitz 2018, eq. 17).
  const float microfacets = ggx_.density(half) / (4.0F * outgoing_.z);
  const float masking = 1.0F / (1.0F + lambda_outgoing_ + ggx_.lambda(incoming));
  const Rgb fresnel = glm::mix(specular_f0_, Rgb(1.0F), schlick_weight(cosine_half));
  return {.times_cosine = fresnel * (microfacets * masking) +
                          diffuse_ * ((1.0F - coat_.at(incoming.z)) * incoming.z),
          .pdf = specular_probability_ * microfacets / (1.0F + lambda_outgoing_) +
                 (1.0F - specular_probability_) * incoming.z * inverse_pi};
}

std::optional<BsdfSample> Bsdf::sample(float u_lobe, const Vec2& u) const {
  Vec3 incoming;
  if (u_lobe < specular_probability_) {
    const Vec3 normal = ggx_.sample_visible_normal(outgoing_, u);
    incoming = glm::normalize(2.0F * glm::dot(outgoing_, normal) * normal - outgoing_);
  } else {
    incoming = sample_cosine_hemisphere(u);
  }
  const BsdfValue value = eval(incoming);
  if (!(value.pdf > 0.0F)) {
    return std::nullopt;
  }
  return BsdfSample{
      .incoming = incoming, .weight = value.times_cosine / value.pdf, .pdf = value.pdf};
}

}  // namespace foveola
