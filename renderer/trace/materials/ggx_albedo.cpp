#include "renderer/trace/materials/ggx_albedo.h"

#include "renderer/trace/materials/visible_normals.h"

namespace foveola {
namespace {

/// The expected weights of a sampled reflection.
SchlickAlbedo integrate_albedo(float cosine, const Ggx& ggx) {
  const Vec3 outgoing(std::sqrt((1.0F - cosine) * (1.0F + cosine)), 0.0F, cosine);
  const float lambda_outgoing = ggx.lambda(outgoing);
  double white = 0.0;
  double grazing = 0.0;
  VisibleNormals(ggx, outgoing).for_each_reflecting([&](const Vec3& normal, double weight) {
    const float cosine_normal = glm::dot(outgoing, normal);
    const Vec3 incoming = 2.0F * cosine_normal * normal - outgoing;
    const double masked =
        weight * (1.0F + lambda_outgoing) / (1.0F + lambda_outgoing + ggx.lambda(incoming));
    white += masked;
    grazing += masked * schlick_weight(std::min(cosine_normal, 1.0F));
  });
  return {.white = static_cast<float>(white), .grazing = static_cast<float>(grazing)};
}

/// Integrates over s with c = s^2, which concentrates points at grazing angles, where the albedo
/// changes most.
SchlickAlbedo mean_of(const GgxAlbedo::Row& row) {
  constexpr int points = 256;
  double white = 0.0;
  double grazing = 0.0;
  for (int i = 0; i < points; ++i) {
    const double s = (i + 0.5) / points;
    const double weight = 4.0 * s * s * s / points;
    const SchlickAlbedo albedo = row.at(static_cast<float>(s * s));
    white += weight * albedo.white;
    grazing += weight * albedo.grazing;
  }
  return {.white = static_cast<float>(white), .grazing = static_cast<float>(grazing)};
}

}  // namespace

bool GgxAlbedo::is_needed(std::size_t number, std::span<const RoughnessInterval> needed) {
  const auto first = static_cast<int>(number) - 1;
  return first == 0 || first >= roughness_steps - 1 ||
         std::ranges::any_of(needed, [&](const RoughnessInterval& some) {
           return NodePosition(some.least, roughness_steps).below <= first &&
                  first <= NodePosition(some.most, roughness_steps).below + 1;
         });
}

GgxAlbedo::GgxAlbedo(std::span<const RoughnessInterval> needed, const Workers& workers)
    : nodes_(row_count * nodes_in_row, Vec2(1.0F, 0.0F)), means_(row_count) {
  workers.for_each_block(row_count - 1, 1, [&](std::size_t i, std::size_t) {
    if (!is_needed(i + 1, needed)) {
      return;
    }
    const float roughness = static_cast<float>(i) / roughness_steps;
    const Ggx ggx{.alpha = std::max(roughness * roughness, vanishing_alpha)};
    Vec2* nodes = &nodes_[(i + 1) * nodes_in_row];
    for (std::size_t k = 0; k < nodes_in_row; ++k) {
      const float cosine = cosine_of_node(k, cosine_steps, ggx.alpha);
      nodes[k] = node_of(integrate_albedo(cosine, ggx), cosine, ggx.alpha);
    }
  });
  means_[0] = mean_of(mirror_row());
  for (std::size_t i = 1; i < row_count; ++i) {
    const float roughness = static_cast<float>(i - 1) / roughness_steps;
    if (is_needed(i, needed)) {
      means_[i] = i == 1 ? means_[0] : mean_of(row(roughness));
    }
  }
}

}  // namespace foveola
