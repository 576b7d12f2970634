#include "renderer/view/radial_distribution.h"

#include <limits>
#include <numbers>
#include <utility>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/lambert_w.hpp>

#include "renderer/base/angles.h"
#include "renderer/base/transformed.h"

namespace foveola {
namespace {

/// The cubic in t through its values at t = 0, 1/3, 2/3 and 1: coefficients of rising powers.
std::array<float, 4> cubic_through(const std::array<double, 4>& v) {
  return {static_cast<float>(v[0]),
          static_cast<float>(-5.5 * v[0] + 9.0 * v[1] - 4.5 * v[2] + v[3]),
          static_cast<float>(9.0 * v[0] - 22.5 * v[1] + 18.0 * v[2] - 4.5 * v[3]),
          static_cast<float>(4.5 * (v[3] - v[0]) + 13.5 * (v[1] - v[2]))};
}

/// The limit of eccentricity / sqrt(u) at u = 0 is evaluated here, where it differs by less than a
/// float resolves.
constexpr double smallest_s = 1e-8;

/// The largest s of a float u.
const double largest_s = std::sqrt(static_cast<double>(largest_below_one));

constexpr double turns_per_degree = 1.0 / 360.0;

double eccentricity_over_s(const RadialDistribution& distribution, double s) {
  const double s_in_range = std::clamp(s, smallest_s, largest_s);
  return turns_per_degree * distribution.eccentricity_deg(s_in_range * s_in_range) / s_in_range;
}

using std::numbers::pi;

// Reddy's constants as printed in the paper: beyond the knee the acuity is scale / (slope e + 1)^2.
constexpr double scale = 7.49;
constexpr double slope_per_deg = 0.3;

constexpr double foveal_integral = pi * reddy_knee_deg * reddy_knee_deg;
constexpr double peripheral_factor = 2.0 * pi * scale / (slope_per_deg * slope_per_deg);

/// With y = slope e + 1, the integral of e / y^2 de is (ln y + 1 / y) / slope^2.
double log_plus_reciprocal(double eccentricity_deg) {
  const double y = slope_per_deg * eccentricity_deg + 1.0;
  return std::log(y) + 1.0 / y;
}

std::vector<double> inside(std::vector<double> knees_deg, double cutoff_deg) {
  std::erase_if(knees_deg, [&](double knee) { return knee <= 0.0 || knee >= cutoff_deg; });
  return knees_deg;
}

}  // namespace

double density_per_sr(double per_square_degree, double eccentricity_deg,
                      EccentricityMeasure measure) {
  const double per_sr = per_square_degree * degrees(1.0) * degrees(1.0);
  const double e_rad = radians(eccentricity_deg);
  if (measure == EccentricityMeasure::solid_angle || e_rad < 1e-8) {
    return per_sr;
  }
  // A ring of 2 pi e de planar square degrees has 2 pi sin(e) de steradians.
  return per_sr * e_rad / std::sin(e_rad);
}

ReddyDistribution::ReddyDistribution(double cutoff_deg)
    : cutoff_deg_(cutoff_deg), total_(integral(cutoff_deg)) {}

std::vector<double> ReddyDistribution::knees_deg() const {
  return inside({reddy_knee_deg}, cutoff_deg_);
}

double ReddyDistribution::integral(double eccentricity_deg) const {
  const double e = std::clamp(eccentricity_deg, 0.0, cutoff_deg_);
  if (e <= reddy_knee_deg) {
    return pi * e * e;
  }
  return foveal_integral +
         peripheral_factor * (log_plus_reciprocal(e) - log_plus_reciprocal(reddy_knee_deg));
}

double ReddyDistribution::cumulative(double eccentricity_deg) const {
  return integral(eccentricity_deg) / total_;
}

double ReddyDistribution::eccentricity_deg(double u) const {
  const double target = u * total_;
  if (target <= foveal_integral) {
    return std::sqrt(target / pi);
  }
  // ln y + 1 / y = c has the solution y = -1 / W0(-exp(-c)) for y > 1, where the principal branch
  // of Lambert's W holds since then -1 / y > -1.
  const double c =
      (target - foveal_integral) / peripheral_factor + log_plus_reciprocal(reddy_knee_deg);
  const double y = -1.0 / boost::math::lambert_w0(-std::exp(-c));
  return std::min((y - 1.0) / slope_per_deg, cutoff_deg_);
}

double ReddyDistribution::density_per_sr(double eccentricity_deg) const {
  return eccentricity_deg > cutoff_deg_
             ? 0.0
             : foveola::density_per_sr(reddy_acuity(eccentricity_deg) / total_, eccentricity_deg,
                                       EccentricityMeasure::planar);
}

AcuityDistribution::AcuityDistribution(AcuityModel model, double exponent, double cutoff_deg,
                                       EccentricityMeasure measure)
    : model_(std::move(model)), exponent_(exponent), cutoff_deg_(cutoff_deg), measure_(measure) {
  constexpr int panels = 64;  // between two knees
  std::vector<double> ends = inside(model_.knees_deg, cutoff_deg);
  ends.push_back(cutoff_deg);
  nodes_deg_ = {0.0};
  sums_ = {0.0};
  for (const double end : ends) {
    const double start = nodes_deg_.back();
    // From the gaze outwards in growing panels: some models fall within a hundredth of a degree.
    const double growth = start == 0.0 ? 4.0 : 1.0;
    for (int i = 1; i <= panels; ++i) {
      const double node = start + (end - start) * std::pow(static_cast<double>(i) / panels, growth);
      sums_.push_back(sums_.back() + integral(nodes_deg_.back(), node));
      nodes_deg_.push_back(node);
    }
  }
}

std::vector<double> AcuityDistribution::knees_deg() const {
  return inside(model_.knees_deg, cutoff_deg_);
}

double AcuityDistribution::weight(double eccentricity_deg) const {
  const double circle = measure_ == EccentricityMeasure::planar
                            ? eccentricity_deg
                            : degrees(std::sin(radians(eccentricity_deg)));
  return 2.0 * pi * circle * std::pow(model_.at(eccentricity_deg), exponent_);
}

double AcuityDistribution::integral(double from_deg, double to_deg) const {
  return boost::math::quadrature::gauss<double, 15>::integrate(
      [this](double e) { return weight(e); }, from_deg, to_deg);
}

double AcuityDistribution::cumulative(double eccentricity_deg) const {
  const double e = std::clamp(eccentricity_deg, 0.0, cutoff_deg_);
  const auto above = std::upper_bound(nodes_deg_.begin() + 1, nodes_deg_.end() - 1, e);
  const auto node = static_cast<std::size_t>(above - nodes_deg_.begin()) - 1;
  return (sums_[node] + integral(nodes_deg_[node], e)) / sums_.back();
}

double AcuityDistribution::eccentricity_deg(double u) const {
  const double target = u * sums_.back();
  if (target >= sums_.back()) {
    // The last panels may hold less than a double resolves.
    return cutoff_deg_;
  }
  const auto above = std::upper_bound(sums_.begin() + 1, sums_.end() - 1, target);
  const auto panel = static_cast<std::size_t>(above - sums_.begin()) - 1;
  // Newton's steps, kept in the panel: the weight is positive but at 0, where the root is known.
  double low = nodes_deg_[panel];
  double high = nodes_deg_[panel + 1];
  double e =
      low + (high - low) * std::sqrt((target - sums_[panel]) / (sums_[panel + 1] - sums_[panel]));
  constexpr int max_steps = 60;
  for (int step = 0; step < max_steps && low < high; ++step) {
    const double excess = sums_[panel] + integral(nodes_deg_[panel], e) - target;
    (excess > 0.0 ? high : low) = e;
    const double slope = weight(e);
    const double newton = slope > 0.0 ? e - excess / slope : e;
    const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
    if (excess == 0.0 || next == e) {
      break;
    }
    e = next;
  }
  return e;
}

double AcuityDistribution::density_per_sr(double eccentricity_deg) const {
  if (eccentricity_deg > cutoff_deg_) {
    return 0.0;
  }
  return foveola::density_per_sr(std::pow(model_.at(eccentricity_deg), exponent_) / total(),
                                 eccentricity_deg, measure_);
}

EccentricityTable::EccentricityTable(const RadialDistribution& distribution) {
  std::vector<double> ends = transformed(distribution.knees_deg(), [&](const double knee_deg) {
    return std::sqrt(distribution.cumulative(knee_deg));
  });
  ends.push_back(largest_s);
  double begin = 0.0;
  for (const double end : ends) {
    // Beyond a far knee there may be less than a float resolves.
    if (end > begin && end <= largest_s) {
      add_pieces(distribution, begin, end, 0);
      begin = end;
    }
  }
}

void EccentricityTable::add_pieces(const RadialDistribution& distribution, double begin, double end,
                                   int halvings) {
  constexpr double largest_error = 2e-7;  // relative, of the cubics alone
  // Even at the end of a tail that falls by twenty powers of ten, cells are then a hundredth of the
  // distance of two floats below 1.
  constexpr int max_halvings = 26;
  const double cell = (end - begin) / cells_in_piece;
  // Values at the ends of a piece are taken just inside it: at a knee the radius may jump, and
  // either radius may be the neighbour's. A few roundings inside are inside for s^2 too.
  constexpr double a_few_roundings = 4.0 * std::numeric_limits<double>::epsilon();
  const double first = begin * (1.0 + a_few_roundings);
  const double last = end * (1.0 - a_few_roundings);
  std::vector<Cubic> cubics;
  for (int i = 0; i < cells_in_piece; ++i) {
    const auto exact = [&](double t) {
      return eccentricity_over_s(distribution, std::clamp(begin + cell * (i + t), first, last));
    };
    const Cubic c = cubic_through({exact(0.0), exact(1.0 / 3.0), exact(2.0 / 3.0), exact(1.0)});
    // Between its four points a cubic is farthest off near the ends.
    constexpr double t = 1.0 / 8.0;
    const double error = c[0] + t * (c[1] + t * (c[2] + t * c[3])) - exact(t);
    if (std::abs(error) > largest_error * exact(t) && halvings < max_halvings) {
      const double middle = 0.5 * (begin + end);
      add_pieces(distribution, begin, middle, halvings + 1);
      add_pieces(distribution, middle, end, halvings + 1);
      return;
    }
    cubics.push_back(c);
  }
  pieces_.push_back(
      {.begin = begin, .end = end, .cells_per_unit = 1.0 / cell, .first_cubic = cubics_.size()});
  cubics_.insert(cubics_.end(), cubics.begin(), cubics.end());
}

}  // namespace foveola
