#include "renderer/trace/materials/scattering_tables.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "renderer/trace/materials/bsdf_value.h"
#include "renderer/trace/materials/visible_normals.h"

namespace foveola {
namespace {

constexpr int roughness_steps = 32;
constexpr int cosine_steps = 72;
constexpr std::size_t rows = roughness_steps + 1;
constexpr std::size_t nodes_in_row = cosine_steps + 1;

/// Expected weights of sampled reflections and refractions. eta: of the far side over the near one.
float integrate_albedo(float cosine, const Ggx& ggx, float eta) {
  const Vec3 outgoing(std::sqrt((1.0F - cosine) * (1.0F + cosine)), 0.0F, cosine);
  const float lambda_outgoing = ggx.lambda(outgoing);
  const auto masking = [&](const Vec3& incoming) {
    return (1.0F + lambda_outgoing) / (1.0F + lambda_outgoing + ggx.lambda(incoming));
  };
  const bool can_reflect_totally = eta < 1.0F;
  const VisibleNormals normals(ggx, outgoing);
  double sum = 0.0;
  normals.for_each_reflecting([&](const Vec3& normal, double weight) {
    const float cosine_normal = std::min(glm::dot(outgoing, normal), 1.0F);
    const float fresnel = can_reflect_totally ? 1.0F : fresnel_split(cosine_normal, eta).reflected;
    sum += weight * fresnel * masking(2.0F * cosine_normal * normal - outgoing);
  });
  normals.for_each_transmitting(eta, [&](const Vec3& normal, double weight) {
    const float cosine_normal = std::min(glm::dot(outgoing, normal), 1.0F);
    const FresnelSplit split = fresnel_split(cosine_normal, eta);
    const Vec3 refracted =
        (cosine_normal / eta - split.transmitted_cosine) * normal - outgoing / eta;
    const double transmitted = weight * (1.0F - split.reflected);
    if (refracted.z < 0.0F) {
      sum += transmitted * masking(refracted);
    }
    // Total reflection was counted above for these normals too: the root at the critical angle
    // stays at an end of the integral.
    const Vec3 reflected = 2.0F * cosine_normal * normal - outgoing;
    if (can_reflect_totally && reflected.z > 0.0F) {
      sum -= transmitted * masking(reflected);
    }
  });
  return static_cast<float>(sum);
}

/// The roughnesses of a surface: a texture makes it smoother in places.
RoughnessInterval roughnesses(float roughness, const TextureUse& texture) {
  return {.least = texture.exists() ? 0.0F : roughness, .most = roughness};
}

std::vector<RoughnessInterval> ggx_roughnesses(std::span<const Material> materials) {
  std::vector<RoughnessInterval> all;
  for (const Material& material : materials) {
    all.push_back(roughnesses(material.roughness, material.metallic_roughness_texture));
    all.push_back(roughnesses(material.clearcoat_roughness, material.clearcoat_roughness_texture));
  }
  return all;
}

}  // namespace

GlassAlbedo::GlassAlbedo(float ior, const Workers& workers)
    : ior_(ior), nodes_(2 * rows * nodes_in_row) {
  workers.for_each_block(2 * rows, 1, [&](std::size_t i, std::size_t) {
    const float roughness = static_cast<float>(i % rows) / roughness_steps;
    const Ggx ggx{.alpha = std::max(roughness * roughness, vanishing_alpha)};
    const float eta = i < rows ? ior : 1.0F / ior;
    for (std::size_t k = 0; k < nodes_in_row; ++k) {
      const float cosine = cosine_of_node(k, cosine_steps, ggx.alpha);
      nodes_[i * nodes_in_row + k] = integrate_albedo(cosine, ggx, eta);
    }
  });
}

float GlassAlbedo::at(float roughness, float cosine, bool from_inside) const {
  assert(roughness >= min_roughness && roughness <= 1.0F);
  const NodePosition row(roughness, roughness_steps);
  const NodePosition place(albedo_position(cosine, roughness * roughness), cosine_steps);
  const float* smoother =
      &nodes_[((from_inside ? rows : 0) + row.below) * nodes_in_row + place.below];
  const float* rougher = smoother + nodes_in_row;
  return glm::mix(glm::mix(smoother[0], smoother[1], place.fraction),
                  glm::mix(rougher[0], rougher[1], place.fraction), row.fraction);
}

ScatteringTables::ScatteringTables(std::span<const Material> materials, const Workers& workers)
    : ggx_(ggx_roughnesses(materials), workers) {
  for (const Material& material : materials) {
    if (!sheen_ && max_component(material.sheen_color) > 0.0F) {
      sheen_.emplace(workers);
    }
    const bool is_known = std::ranges::any_of(
        glass_, [&](const GlassAlbedo& glass) { return glass.ior() == material.ior; });
    if (material.is_solid && material.transmission > 0.0F && !is_known &&
        is_rough_glass(material.ior, material.roughness)) {
      glass_.emplace_back(material.ior, workers);
    }
  }
}

const GlassAlbedo& ScatteringTables::glass(float ior) const {
  const auto found =
      std::ranges::find_if(glass_, [=](const GlassAlbedo& glass) { return glass.ior() == ior; });
  assert(found != glass_.end());
  return *found;
}

}  // namespace foveola
