// The inverse of a radial distribution at the speed and accuracy of a float.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "renderer/base/unit_interval.h"
#include "renderer/view/radial_distribution.h"

namespace foveola {

/// RadialDistribution::eccentricity_deg in turns, within 1e-6 relative at every float of [0, 1).
/// With s = sqrt(u), the eccentricity over s is smooth from knee to knee, and may jump at one;
/// cubics through exact values stand for it, more of them where it is steep. What lies beyond the
/// last float below 1, 6e-8 of the samples, is never drawn.
class EccentricityTable {
 public:
  explicit EccentricityTable(const RadialDistribution& distribution);

  /// u in [0, 1]; 1 counts as the largest float below it.
  float operator()(float u) const { return at_root(root(u)); }

  /// The two halves of it. A compiler makes several of the first at a time. In double: where
  /// samples are rare, the last bit of a float is many of them apart.
  static double root(float u) {
    return std::sqrt(static_cast<double>(std::min(u, largest_below_one)));
  }
  float at_root(double s) const {
    const Piece* piece = pieces_.data();
    while (s > piece->end) {
      ++piece;
    }
    const double position = (s - piece->begin) * piece->cells_per_unit;
    const int cell = std::min(static_cast<int>(position), cells_in_piece - 1);
    const auto t = static_cast<float>(position - cell);
    const Cubic& c = cubics_[piece->first_cubic + static_cast<std::size_t>(cell)];
    return static_cast<float>(s) * (c[0] + t * (c[1] + t * (c[2] + t * c[3])));
  }

 private:
  static constexpr int cells_in_piece = 64;
  using Cubic = std::array<float, 4>;
  /// A range of s without a knee.
  struct Piece {
    double begin;
    double end;
    double cells_per_unit;
    std::size_t first_cubic;
  };

  /// Adds pieces over [begin, end], halved until they are exact enough.
  void add_pieces(const RadialDistribution& distribution, double begin, double end, int halvings);

  std::vector<Piece> pieces_;
  std::vector<Cubic> cubics_;
};

}  // namespace foveola
