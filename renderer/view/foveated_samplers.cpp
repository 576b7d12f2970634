#include "renderer/view/foveated_samplers.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "renderer/base/angles.h"
#include "renderer/base/numbers/random.h"
#include "renderer/view/equirect.h"
#include "renderer/view/sample_block.h"

namespace foveola {
namespace {

using std::numbers::pi;

constexpr double root_factor_deg = 18.64;

/// In rising powers of u, degrees.
constexpr double c0 = 3.232;
constexpr double c1 = 23.87;
constexpr double c2 = 27.61;
constexpr double c3 = 0.1680;
constexpr double c4 = 25.09;

/// The derivative of the second branch, degrees.
double slope_beyond_switch_deg(double u) {
  return c1 + u * (2.0 * c2 + u * (3.0 * c3 + u * 4.0 * c4));
}

struct Quadrant {
  Meridian across;
  Meridian upright;
};
/// The quadrants in the order of the azimuth, from the temple over the head's up.
constexpr std::array<Quadrant, 4> sides{{{Meridian::temporal, Meridian::upper},
                                         {Meridian::nasal, Meridian::upper},
                                         {Meridian::nasal, Meridian::lower},
                                         {Meridian::temporal, Meridian::lower}}};

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
  // All of the polynomial's coefficients are positive, so it is convex: Newton's steps from beyond
  // the root descend to it without passing it, until rounding reverses them.
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

WatsonSampler::WatsonSampler(Eyes eyes, double exponent, double cutoff_deg,
                             EccentricityMeasure measure)
    : eyes_(eyes), exponent_(exponent), cutoff_deg_(cutoff_deg), measure_(measure) {
  for (std::size_t i = 0; i < quadrants; ++i) {
    const AcuityModel mean{
        .at =
            [side = sides[i]](double e) {
              return std::sqrt(watson_density(side.across, e) * watson_density(side.upright, e));
            },
        .knees_deg = {}};
    const AcuityDistribution distribution(mean, exponent, cutoff_deg, measure);
    eccentricity_turns_.emplace_back(distribution);
    shares_[i] = distribution.total() / quadrants;
    total_ += shares_[i];
  }
  for (double& share : shares_) {
    share /= total_;
  }
  const double each = eyes == Eyes::both ? 0.5 : 1.0;
  if (eyes != Eyes::left) {
    add_eye(true, 0.0, each);
  }
  if (eyes != Eyes::right) {
    add_eye(false, 1.0 - each, each);
  }
}

void WatsonSampler::add_eye(bool is_right, double first, double share) {
  double begin = first;
  for (std::size_t i = 0; i < quadrants; ++i) {
    const double height = share * shares_[i];
    const bool is_temporal = sides[i].across == Meridian::temporal;
    stripes_.push_back({.quadrant = i,
                        .sign_x = is_temporal == is_right ? 1.0F : -1.0F,
                        .begin = static_cast<float>(begin),
                        .height = static_cast<float>(height),
                        .is_clockwise = i % 2 == 1});
    begin += height;
  }
}

void WatsonSampler::aim(const Aim& aim) {
  gaze_ = GazeFrame(glm::normalize(aim.gaze), aim.viewport.head());
}

double WatsonSampler::meridian_density(Meridian meridian, double eccentricity_deg) const {
  const double density = watson_density(meridian, eccentricity_deg);
  return exponent_ == 1.0 ? density : std::pow(density, exponent_);
}

Vec3 WatsonSampler::local_direction(const Vec2& point) const {
  const auto above = std::upper_bound(stripes_.begin() + 1, stripes_.end(), point.y,
                                      [](float y, const Stripe& s) { return y < s.begin; });
  const Stripe& stripe = *(above - 1);
  const float within = std::min((point.y - stripe.begin) / stripe.height, largest_below_one);
  const auto [across, upright] = sides[stripe.quadrant];
  const float turns = eccentricity_turns_[stripe.quadrant](point.x);
  constexpr double degrees_per_turn = 360.0;
  const double e = degrees_per_turn * turns;
  const auto t = sine_cosine_of_turns(0.25F * (stripe.is_clockwise ? 1.0F - within : within));
  const auto ratio =
      static_cast<float>(std::sqrt(meridian_density(upright, e) / meridian_density(across, e)));
  const float y = ratio * t.sine;
  const float scale = 1.0F / std::sqrt(t.cosine * t.cosine + y * y);
  const auto [radius, ahead] = sine_cosine_of_turns(turns);
  const float sign_y = upright == Meridian::upper ? 1.0F : -1.0F;
  return {radius * scale * stripe.sign_x * t.cosine, radius * scale * sign_y * y, ahead};
}

void WatsonSampler::sample(std::span<const Vec2> points, std::span<ViewSample> samples) const {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 direction = gaze_.to_world(local_direction(points[i]));
    samples[i] = {.direction = direction, .image = equirect_from_direction(direction)};
  }
}

double WatsonSampler::eye_density(double towards_temple, double up, double eccentricity_deg) const {
  const Meridian across = towards_temple > 0.0 ? Meridian::temporal : Meridian::nasal;
  const Meridian upright = up > 0.0 ? Meridian::upper : Meridian::lower;
  return 1.0 / (towards_temple * towards_temple / meridian_density(across, eccentricity_deg) +
                up * up / meridian_density(upright, eccentricity_deg));
}

double WatsonSampler::density_per_sr(const Vec3& direction) const {
  const double e = degrees(angle_between(direction, gaze_.ahead));
  if (e > cutoff_deg_) {
    return 0.0;
  }
  const DVec3 local(gaze_.to_local(direction));
  const double radius = std::hypot(local.x, local.y);
  const double x = radius > 0.0 ? local.x / radius : 1.0;
  const double y = radius > 0.0 ? local.y / radius : 0.0;
  const double right = eyes_ == Eyes::left ? 0.0 : eye_density(x, y, e);
  const double left = eyes_ == Eyes::right ? 0.0 : eye_density(-x, y, e);
  const double each = eyes_ == Eyes::both ? 0.5 : 1.0;
  return foveola::density_per_sr(each * (right + left) / total_, e, measure_);
}

}  // namespace foveola
