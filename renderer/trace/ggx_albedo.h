// How much light a rough surface reflects at its first bounce: what is missing is given back to
// metals, and what a coat does not reflect goes to the layer below.
#pragma once

#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

#include "renderer/base/lanes.h"
#include "renderer/base/parallel.h"
#include "renderer/base/vec.h"
#include "renderer/trace/albedo_axis.h"
#include "renderer/trace/fresnel.h"
#include "renderer/trace/ggx.h"

namespace foveola {

/// A directional albedo of the GGX lobe for any Schlick Fresnel: f0 (white - grazing) + f90
/// grazing. Number: float, or Floats.
template <typename Number>
struct SchlickAlbedoOf {
  Number white;    ///< with a Fresnel reflectance of 1
  Number grazing;  ///< with Schlick's weight for the Fresnel reflectance

  Number with(const Number& f0, const Number& f90) const {
    return f0 * (white - grazing) + f90 * grazing;
  }
};
using SchlickAlbedo = SchlickAlbedoOf<float>;
using SchlickAlbedos = SchlickAlbedoOf<Floats>;

/// From least to most, perceptual, in [0, 1].
struct RoughnessInterval {
  float least = 0.0F;
  float most = 1.0F;
};

/// The albedo's table over roughness and the cosine of the direction. Within 1e-4 of the integral.
class GgxAlbedo {
 public:
  /// Computes the rows of the roughnesses in `needed`; no others may be asked for, but for 0 (a
  /// mirror) and 1 (lanes that do not shine). All of them take 70 ms of a core.
  GgxAlbedo(std::span<const RoughnessInterval> needed, const Workers& workers);

  /// The albedo as a function of the cosine, for one roughness.
  class Row {
   public:
    /// cosine: between the normal and the direction, in [0, 1].
    SchlickAlbedo at(float cosine) const;
    /// 2 * integral of albedo(c) c dc over [0, 1]: the albedo under a uniform sky.
    SchlickAlbedo mean() const;

   private:
    friend class GgxAlbedo;
    const Vec2* smoother_ = nullptr;
    float alpha_ = 0.0F;
    float rougher_weight_ = 0.0F;
    const SchlickAlbedo* smoother_mean_ = nullptr;
  };

  /// roughness: perceptual, in [0, 1]; below smallest_roughness it is that of a perfect mirror. The
  /// row is valid as long as the table.
  Row row(float roughness) const;

  /// The same for eight roughnesses.
  class Rows {
   public:
    SchlickAlbedos at(const Floats& cosine) const;
    SchlickAlbedos mean() const;

   private:
    friend class GgxAlbedo;
    const GgxAlbedo* albedo_ = nullptr;
    Ints smoother_{};  ///< number of the row
    Floats alpha_{};
    Floats rougher_weight_{};
  };
  /// roughness: in [smallest_roughness, 1].
  Rows rows(const Floats& roughness) const;

 private:
  Row mirror_row() const;
  /// Whether the row of this number is read for any of these roughnesses.
  static bool is_needed(std::size_t number, std::span<const RoughnessInterval> needed);

  static constexpr int roughness_steps = 64;
  static constexpr int cosine_steps = 96;
  static constexpr std::size_t row_count = roughness_steps + 2;
  static constexpr std::size_t nodes_in_row = cosine_steps + 1;

  /// What is tabulated of an albedo: x: the white one; y: by how much the lobe's mean Schlick
  /// weight exceeds that of the cosine, over alpha. Against the position both are nearly straight
  /// lines, also for alpha towards 0.
  static Vec2 node_of(const SchlickAlbedo& albedo, float cosine, float alpha) {
    return {albedo.white, (albedo.grazing / albedo.white - schlick_weight(cosine)) / alpha};
  }
  template <typename Number>
  static SchlickAlbedoOf<Number> albedo_of(const Number& x, const Number& y, const Number& cosine,
                                           const Number& alpha) {
    return {.white = x, .grazing = x * (schlick_weight(cosine) + alpha * y)};
  }

  /// Row-major: first a mirror's row, then the roughnesses from 0 on, each over the position of the
  /// cosine.
  std::vector<Vec2> nodes_;
  std::vector<SchlickAlbedo> means_;  ///< one a row
};

inline SchlickAlbedo GgxAlbedo::Row::at(float cosine) const {
  const NodePosition place(albedo_position(cosine, alpha_), cosine_steps);
  const Vec2* smoother = smoother_ + place.below;
  const Vec2* rougher = smoother + nodes_in_row;
  const Vec2 lower = smoother[0] + rougher_weight_ * (rougher[0] - smoother[0]);
  const Vec2 upper = smoother[1] + rougher_weight_ * (rougher[1] - smoother[1]);
  const Vec2 node = lower + place.fraction * (upper - lower);
  return albedo_of(node.x, node.y, cosine, alpha_);
}

inline SchlickAlbedo GgxAlbedo::Row::mean() const {
  const SchlickAlbedo& smoother = smoother_mean_[0];
  const SchlickAlbedo& rougher = smoother_mean_[1];
  return {.white = smoother.white + rougher_weight_ * (rougher.white - smoother.white),
          .grazing = smoother.grazing + rougher_weight_ * (rougher.grazing - smoother.grazing)};
}

inline GgxAlbedo::Row GgxAlbedo::mirror_row() const {
  Row row;
  row.smoother_ = nodes_.data();
  row.smoother_mean_ = means_.data();
  return row;
}

inline GgxAlbedo::Row GgxAlbedo::row(float roughness) const {
  assert(roughness >= 0.0F && roughness <= 1.0F);
  if (roughness < smallest_roughness) {
    return mirror_row();
  }
  const NodePosition place(roughness, roughness_steps);
  const auto below = static_cast<std::size_t>(place.below) + 1;
  Row row;
  row.smoother_ = &nodes_[below * nodes_in_row];
  row.smoother_mean_ = &means_[below];
  row.alpha_ = roughness * roughness;
  row.rougher_weight_ = place.fraction;
  return row;
}

inline GgxAlbedo::Rows GgxAlbedo::rows(const Floats& roughness) const {
  const NodePositions place(roughness, roughness_steps);
  Rows rows;
  rows.albedo_ = this;
  rows.smoother_ = place.below + 1;
  rows.alpha_ = roughness * roughness;
  rows.rougher_weight_ = place.fraction;
  return rows;
}

inline SchlickAlbedos GgxAlbedo::Rows::at(const Floats& cosine) const {
  const NodePositions place(albedo_position(cosine, alpha_), cosine_steps);
  const Ints index = smoother_ * static_cast<std::int32_t>(nodes_in_row) + place.below;
  Floats x[2][2];
  Floats y[2][2];
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    const Vec2* smoother = &albedo_->nodes_[static_cast<std::size_t>(index[lane])];
    const Vec2* rougher = smoother + nodes_in_row;
    for (std::size_t next = 0; next < 2; ++next) {
      x[0][next][lane] = smoother[next].x;
      y[0][next][lane] = smoother[next].y;
      x[1][next][lane] = rougher[next].x;
      y[1][next][lane] = rougher[next].y;
    }
  }
  const auto between = [&](const Floats(&node)[2][2]) {
    const Floats lower = node[0][0] + rougher_weight_ * (node[1][0] - node[0][0]);
    const Floats upper = node[0][1] + rougher_weight_ * (node[1][1] - node[0][1]);
    return lower + place.fraction * (upper - lower);
  };
  return albedo_of(between(x), between(y), cosine, alpha_);
}

inline SchlickAlbedos GgxAlbedo::Rows::mean() const {
  SchlickAlbedos smoother;
  SchlickAlbedos rougher;
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    const SchlickAlbedo* means = &albedo_->means_[static_cast<std::size_t>(smoother_[lane])];
    smoother.white[lane] = means[0].white;
    smoother.grazing[lane] = means[0].grazing;
    rougher.white[lane] = means[1].white;
    rougher.grazing[lane] = means[1].grazing;
  }
  return {.white = smoother.white + rougher_weight_ * (rougher.white - smoother.white),
          .grazing = smoother.grazing + rougher_weight_ * (rougher.grazing - smoother.grazing)};
}

}  // namespace foveola
