#include "renderer/view/eccentricity_table.h"

#include <limits>

namespace foveola {
namespace {

/// The cubic in t through its values at t = 0, 1/3, 2/3 and 1: coefficients of rising powers.
std::array<float, 4> cubic_through(const std::array<double, 4>& v) {
  return {static_cast<float>(v[0]),
          static_cast<float>(-5.5 * v[0] + 9.0 * v[1] - 4.5 * v[2] + v[3]),
          static_cast<float>(9.0 * v[0] - 22.5 * v[1] + 18.0 * v[2] - 4.5 * v[3]),
          static_cast<float>(4.5 * (v[3] - v[0]) + 13.5 * (v[1] - v[2]))};
}

/// The limit of eccentricity / sqrt(u) at u = 0 is taken from so near that it differs by less than
/// a float resolves.
constexpr double smallest_s = 1e-8;

/// The largest s that a float u has.
const double largest_s = std::sqrt(static_cast<double>(largest_below_one));

constexpr double turns_per_degree = 1.0 / 360.0;

double eccentricity_over_s(const RadialDistribution& distribution, double s) {
  const double s_in_range = std::clamp(s, smallest_s, largest_s);
  return turns_per_degree * distribution.eccentricity_deg(s_in_range * s_in_range) / s_in_range;
}

}  // namespace

EccentricityTable::EccentricityTable(const RadialDistribution& distribution) {
  std::vector<double> ends;
  for (const double knee_deg : distribution.knees_deg()) {
    ends.push_back(std::sqrt(distribution.cumulative(knee_deg)));
  }
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
  // At the end even of a tail that thins out by twenty powers of ten, cells are then a hundredth of
  // what two floats below 1 are apart.
  constexpr int most_halvings = 26;
  const double cell = (end - begin) / cells_in_piece;
  // What holds at the ends of a piece is what holds inside it: at a knee the radius may jump, and
  // of the two radii there either is the neighbour's. A few roundings inside is inside for s^2 too.
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
    if (std::abs(error) > largest_error * exact(t) && halvings < most_halvings) {
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
