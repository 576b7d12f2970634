#include "renderer/view/equation7_errors.h"

#include <cmath>
#include <numbers>

#include "renderer/view/equation7.h"

namespace foveola {
namespace {

using std::numbers::pi;

/// The paper's upper limit of the eccentricity.
constexpr double cutoff_deg = 80.0;

void take_if_larger(double error, double u, double eccentricity_deg, LargestError& largest) {
  if (std::abs(error) > std::abs(largest.error)) {
    largest = {.error = error, .u = u, .eccentricity_deg = eccentricity_deg};
  }
}

/// The exact density over equation 7's.
double density_ratio(const ReddyDistribution& exact, const Equation7Distribution& approximate,
                     double eccentricity_deg) {
  return exact.density_per_sr(eccentricity_deg) / approximate.density_per_sr(eccentricity_deg);
}

void compare_at(double u, double radius_deg, const ReddyDistribution& exact,
                const Equation7Distribution& approximate, Equation7Errors& errors) {
  const double exact_deg = exact.eccentricity_deg(u);
  take_if_larger(radius_deg - exact_deg, u, radius_deg, errors.radius_deg);
  take_if_larger(radius_deg / exact_deg - 1.0, u, radius_deg, errors.radius_relative);
  take_if_larger(1.0 / density_ratio(exact, approximate, radius_deg) - 1.0, u, radius_deg,
                 errors.density_relative);
  take_if_larger(u - exact.cumulative(radius_deg), u, radius_deg, errors.share);
}

/// The second branch of equation 5, as printed.
double beyond_knee(double eccentricity_deg) {
  const double y = 0.3 * eccentricity_deg + 1.0;
  return (1.0 / y + std::log(y)) * 166.4 * pi - 612.3;
}

}  // namespace

Equation7Errors equation7_errors() {
  const ReddyDistribution exact(cutoff_deg);
  const Equation7Distribution approximate;
  Equation7Errors errors{.gap_begin_deg = approximate.gap_begin_deg(),
                         .gap_end_deg = approximate.gap_end_deg(),
                         .last_radius_deg = approximate.cutoff_deg(),
                         .foveal_share = approximate.cumulative(reddy_knee_deg),
                         .exact_foveal_share = exact.cumulative(reddy_knee_deg)};
  constexpr double switch_u = Equation7Distribution::switch_u;
  compare_at(switch_u, errors.gap_begin_deg, exact, approximate, errors);
  compare_at(switch_u, errors.gap_end_deg, exact, approximate, errors);
  compare_at(1.0, errors.last_radius_deg, exact, approximate, errors);
  // By the midpoint rule. What lies in the gap and beyond the last radius is in no u.
  errors.density_difference = exact.cumulative(errors.gap_end_deg) -
                              exact.cumulative(errors.gap_begin_deg) + 1.0 -
                              exact.cumulative(errors.last_radius_deg);
  constexpr int steps = 100'000;
  constexpr double du = 1.0 / steps;
  for (int i = 0; i < steps; ++i) {
    const double u = (i + 0.5) * du;
    const double radius_deg = approximate.eccentricity_deg(u);
    const double exact_deg = exact.eccentricity_deg(u);
    compare_at(u, radius_deg, exact, approximate, errors);
    errors.mean_radius_deg += exact_deg * du;
    errors.signed_radius_difference_deg += (radius_deg - exact_deg) * du;
    errors.radius_difference_deg += std::abs(radius_deg - exact_deg) * du;
    errors.relative_radius_difference += std::abs(radius_deg / exact_deg - 1.0) * du;
    errors.density_difference += std::abs(1.0 - density_ratio(exact, approximate, radius_deg)) * du;
  }
  return errors;
}

Equation5Errors equation5_errors() {
  const ReddyDistribution exact(cutoff_deg);
  return {.jump = beyond_knee(reddy_knee_deg) - pi * reddy_knee_deg * reddy_knee_deg,
          .normaliser = beyond_knee(cutoff_deg),
          .exact_normaliser = exact.integral(cutoff_deg)};
}

}  // namespace foveola
