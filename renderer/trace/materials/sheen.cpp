#include "renderer/trace/materials/sheen.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <boost/math/quadrature/gauss.hpp>

#include "renderer/trace/materials/ggx_albedo.h"

namespace foveola {
namespace {

constexpr int sheen_roughness_steps = 40;
constexpr int sheen_cosine_steps = 64;
constexpr std::size_t sheen_rows = sheen_roughness_steps + 1;
constexpr std::size_t sheen_nodes_in_row = sheen_cosine_steps + 1;

constexpr float roughness_range = 1.0F - CharlieSheen::min_roughness;

/// A roughness's position on the table's axis, whose nodes are denser for fine fibres.
float roughness_position(float roughness) {
  return std::sqrt(std::max(0.0F, roughness - CharlieSheen::min_roughness) / roughness_range);
}

float roughness_of_row(std::size_t row) {
  const float position = static_cast<float>(row) / sheen_roughness_steps;
  return CharlieSheen::min_roughness + roughness_range * position * position;
}

/// A cosine's position on the table's axis, whose nodes are denser towards grazing angles.
float cosine_position(float cosine) { return std::sqrt(std::sqrt(cosine)); }

float cosine_of_node(std::size_t node) {
  const float position = std::max(static_cast<float>(node) / sheen_cosine_steps, 1e-2F);
  return position * position * position * position;
}

/// Gauss-Legendre quadrature over the cube root of the incoming cosine and half of the azimuths.
float integrate_albedo(float roughness, float cosine) {
  using Gauss = boost::math::quadrature::gauss<double, 20>;
  constexpr int azimuths = 20;
  const Vec3 outgoing(std::sqrt((1.0F - cosine) * (1.0F + cosine)), 0.0F, cosine);
  const CharlieSheen sheen(roughness, outgoing);
  double sum = 0.0;
  const auto add_ring = [&](double root, double weight) {
    const double z = root * root * root;
    const double r = std::sqrt((1.0 - z) * (1.0 + z));
    for (int k = 0; k < azimuths; ++k) {
      const double azimuth = std::numbers::pi * (k + 0.5) / azimuths;
      sum += weight * 1.5 * root * root *
             sheen.times_cosine(Vec3(r * std::cos(azimuth), r * std::sin(azimuth), z));
    }
  };
  for (std::size_t i = 0; i < Gauss::abscissa().size(); ++i) {
    add_ring(0.5 - 0.5 * Gauss::abscissa()[i], Gauss::weights()[i]);
    add_ring(0.5 + 0.5 * Gauss::abscissa()[i], Gauss::weights()[i]);
  }
  return static_cast<float>(2.0 * std::numbers::pi * sum / azimuths) / sheen.outgoing_factor();
}

}  // namespace

CharlieSheen::CharlieSheen(float roughness, const Vec3& outgoing) : outgoing_(outgoing) {
  const float clamped = std::max(roughness, min_roughness);
  const float alpha = clamped * clamped;
  const float smoothness = (1.0F - alpha) * (1.0F - alpha);
  inverse_alpha_ = 1.0F / alpha;
  a_ = glm::mix(21.5473F, 25.3245F, smoothness);
  b_ = glm::mix(3.82987F, 3.32435F, smoothness);
  c_ = glm::mix(0.19823F, 0.16801F, smoothness);
  d_ = glm::mix(-1.97760F, -1.27393F, smoothness);
  e_ = glm::mix(-4.32054F, -4.85967F, smoothness);
  lambda_outgoing_ = lambda(outgoing.z);
}

float CharlieSheen::lambda_exponent(float cosine) const {
  return a_ / (1.0F + b_ * std::pow(cosine, c_)) + d_ * cosine + e_;
}

float CharlieSheen::lambda(float cosine) const {
  // Rounding may raise the cosine of a direction along the normal above 1, and the power of a
  // negative number is NaN.
  return std::exp(cosine < 0.5F ? lambda_exponent(cosine)
                                : 2.0F * lambda_exponent(0.5F) -
                                      lambda_exponent(std::max(0.0F, 1.0F - cosine)));
}

float CharlieSheen::times_cosine(const Vec3& incoming) const {
  const Vec3 half = glm::normalize(outgoing_ + incoming);
  const float sine_squared = half.x * half.x + half.y * half.y;
  const float density = (2.0F + inverse_alpha_) * std::pow(sine_squared, 0.5F * inverse_alpha_) *
                        (0.5F * std::numbers::inv_pi_v<float>);
  return density / (4.0F * outgoing_.z * (1.0F + lambda_outgoing_ + lambda(incoming.z)));
}

SheenAlbedo::SheenAlbedo(const Workers& workers) : nodes_(sheen_rows * sheen_nodes_in_row) {
  workers.for_each_block(sheen_rows, 1, [&](std::size_t i, std::size_t) {
    for (std::size_t k = 0; k < sheen_nodes_in_row; ++k) {
      nodes_[i * sheen_nodes_in_row + k] = integrate_albedo(roughness_of_row(i), cosine_of_node(k));
    }
  });
}

float SheenAlbedo::of(const CharlieSheen& sheen, float roughness, float cosine) const {
  const NodePosition row(roughness_position(roughness), sheen_roughness_steps);
  const NodePosition place(cosine_position(cosine), sheen_cosine_steps);
  const float* finer = &nodes_[static_cast<std::size_t>(row.below) * sheen_nodes_in_row +
                               static_cast<std::size_t>(place.below)];
  const float* rougher = finer + sheen_nodes_in_row;
  return sheen.outgoing_factor() * glm::mix(glm::mix(finer[0], finer[1], place.fraction),
                                            glm::mix(rougher[0], rougher[1], place.fraction),
                                            row.fraction);
}

}  // namespace foveola
