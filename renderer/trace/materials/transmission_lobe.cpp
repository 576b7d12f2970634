#include "renderer/trace/materials/transmission_lobe.h"

#include <algorithm>

namespace foveola {

TransmissionValue ThinWall::eval(const Vec3& incoming) const {
  const Vec3 mirrored(incoming.x, incoming.y, -incoming.z);
  const Vec3 half = half_vector(ggx_.alpha, outgoing_, mirrored);
  const float microfacets = ggx_.density(half) / (4.0F * outgoing_.z);
  return {.times_cosine = scale_ * microfacets / (1.0F + lambda_ + ggx_.lambda(mirrored)),
          .pdf = microfacets / (1.0F + lambda_)};
}

Vec3 ThinWall::sample(const Vec2& u) const {
  const Vec3 mirrored = reflected(outgoing_, ggx_.sample_visible_normal(outgoing_, u));
  return {mirrored.x, mirrored.y, -mirrored.z};
}

TransmissionValue GlassInterface::eval(const Vec3& incoming) const {
  // In double: for eta near 1 the half vector is a small difference, and on a nearly smooth surface
  // its slope matters.
  const DVec3 o = glm::normalize(DVec3(outgoing_));
  const DVec3 i = glm::normalize(DVec3(incoming));
  const DVec3 sum = o + static_cast<double>(eta_) * i;
  const DVec3 half = glm::normalize(std::copysign(1.0, sum.z) * sum);
  const double cosine_outgoing = glm::dot(o, half);
  const double cosine_incoming = glm::dot(i, half);
  if (!(cosine_outgoing > 0.0 && cosine_incoming < 0.0)) {
    return {};
  }
  const FresnelSplit split =
      fresnel_split(static_cast<float>(std::min(cosine_outgoing, 1.0)), eta_);
  // Walter's eq. 17 and 21; the visible normals' density is G1 D (o.h) / o.z.
  const double normals_per_sr = ggx_.density(Vec3(half)) * cosine_outgoing / outgoing_.z *
                                static_cast<double>(eta_ * eta_) * -cosine_incoming /
                                glm::dot(sum, sum);
  const double transmitted = (1.0 - split.reflected) * normals_per_sr;
  return {.times_cosine = static_cast<float>(radiance_scale() * scale_ * transmitted /
                                             (1.0 + lambda_ + ggx_.lambda(incoming))),
          .pdf = static_cast<float>(transmitted / (1.0 + lambda_))};
}

Vec3 GlassInterface::refracted(const Vec3& normal) const {
  const float cosine = std::min(glm::dot(outgoing_, normal), 1.0F);
  const FresnelSplit split = fresnel_split(cosine, eta_);
  if (split.reflected >= 1.0F) {
    return Vec3(0.0F);
  }
  return glm::normalize((cosine / eta_ - split.transmitted_cosine) * normal - outgoing_ / eta_);
}

}  // namespace foveola
