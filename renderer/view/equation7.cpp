#include "renderer/view/equation7.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "renderer/view/sample_block.h"

namespace foveola {
namespace {

using std::numbers::pi;

constexpr double root_factor_deg = 18.64;

/// By rising powers of u, degrees.
constexpr double c0 = 3.232;
constexpr double c1 = 23.87;
constexpr double c2 = 27.61;
constexpr double c3 = 0.1680;
constexpr double c4 = 25.09;

/// The derivative of the second branch, degrees.
double slope_beyond_switch_deg(double u) {
  return c1 + u * (2.0 * c2 + u * (3.0 * c3 + u * 4.0 * c4));
}

}  // namespace

double Equation7Distribution::up_to_switch_deg(double u) { return root_factor_deg * std::sqrt(u); }

double Equation7Distribution::beyond_switch_deg(double u) {
  return c0 + u * (c1 + u * (c2 + u * (c3 + u * c4)));
}

double Equation7Distribution::eccentricity_deg(double u) const {
  return u <= switch_u ? up_to_switch_deg(u) : beyond_switch_deg(u);
}

double Equation7Distribution::cumulative(double eccentricity_deg) const {
  if (eccentricity_deg < gap_begin_deg_) {
    const double root = eccentricity_deg / root_factor_deg;
    return root * root;
  }
  if (eccentricity_deg <= gap_end_deg_) {
    return switch_u;
  }
  if (eccentricity_deg >= cutoff_deg_) {
    return 1.0;
  }
  // All of the polynomial's coefficients are positive, so it is convex, and Newton's steps from
  // beyond the root come down to it without passing it: they end where rounding says otherwise.
  double u = 1.0;
  for (;;) {
    const double next = u - (beyond_switch_deg(u) - eccentricity_deg) / slope_beyond_switch_deg(u);
    if (!(next < u)) {
      return u;
    }
    u = next;
  }
}

double Equation7Distribution::density_per_sr(double eccentricity_deg) const {
  if (eccentricity_deg <= gap_begin_deg_) {
    constexpr double per_square_degree = 1.0 / (pi * root_factor_deg * root_factor_deg);
    return foveola::density_per_sr(per_square_degree, eccentricity_deg,
                                   EccentricityMeasure::planar);
  }
  if (eccentricity_deg < gap_end_deg_ || eccentricity_deg > cutoff_deg_) {
    return 0.0;
  }
  const double slope_deg = slope_beyond_switch_deg(cumulative(eccentricity_deg));
  return foveola::density_per_sr(1.0 / (2.0 * pi * eccentricity_deg * slope_deg), eccentricity_deg,
                                 EccentricityMeasure::planar);
}

FoveatedSampler::FoveatedSampler(std::unique_ptr<RadialDistribution> distribution)
    : distribution_(std::move(distribution)), eccentricity_turns_(*distribution_) {}

void FoveatedSampler::aim(const Aim& aim) { around_ = Frame(glm::normalize(aim.gaze)); }

void FoveatedSampler::sample(std::span<const Vec2> points, std::span<ViewSample> samples) const {
  const auto polar = [this](std::span<const Vec2> block, std::span<Vec2> turns) {
    std::array<double, sample_block_size> roots;
    for (std::size_t i = 0; i < block.size(); ++i) {
      roots[i] = EccentricityTable::root(block[i].x);
    }
    for (std::size_t i = 0; i < block.size(); ++i) {
      turns[i] = Vec2(eccentricity_turns_.at_root(roots[i]), block[i].y);
    }
  };
  sample_around(around_, points, polar, samples);
}

double FoveatedSampler::density_per_sr(const Vec3& direction) const {
  return distribution_->density_per_sr(degrees(angle_between(direction, around_.normal)));
}

}  // namespace foveola
