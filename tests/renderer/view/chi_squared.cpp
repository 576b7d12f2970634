#include "tests/renderer/view/chi_squared.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include <boost/math/distributions/chi_squared.hpp>

#include "renderer/base/angles.h"

namespace foveola::test {
namespace {

using std::numbers::pi;
constexpr int rings = 60;
constexpr int sectors = 16;
constexpr int steps_per_ring = 48;
constexpr int steps_per_sector = 32;

/// Around `pole` up to `reach_rad`: rings of equal eccentricity, sectors of equal azimuth; all that
/// lies beyond is one more cell, the last.
class Cells {
 public:
  Cells(const Vec3& pole, double reach_rad) : frame_(pole), reach_rad_(reach_rad) {}

  std::size_t of(const Vec3& direction) const {
    const Vec3 local = frame_.to_local(direction);
    const double eccentricity = std::atan2(std::hypot(local.x, local.y), local.z);
    const double azimuth = std::atan2(local.y, local.x) + pi;
    const int ring = static_cast<int>(eccentricity / reach_rad_ * rings);
    if (ring >= rings && reach_rad_ < pi) {
      return static_cast<std::size_t>(rings) * sectors;
    }
    const int sector = std::min(static_cast<int>(azimuth / (2.0 * pi) * sectors), sectors - 1);
    return static_cast<std::size_t>(std::min(ring, rings - 1)) * sectors +
           static_cast<std::size_t>(sector);
  }

  /// The integral of `density` over one cell.
  double integrate(int ring, int sector, const std::function<double(const Vec3&)>& density) const {
    const double ring_step = reach_rad_ / rings / steps_per_ring;
    const double sector_step = 2.0 * pi / sectors / steps_per_sector;
    double sum = 0.0;
    for (int i = 0; i < steps_per_ring; ++i) {
      const double eccentricity = (ring * steps_per_ring + i + 0.5) * ring_step;
      for (int j = 0; j < steps_per_sector; ++j) {
        const double azimuth = (sector * steps_per_sector + j + 0.5) * sector_step - pi;
        const Vec3 local(std::sin(eccentricity) * std::cos(azimuth),
                         std::sin(eccentricity) * std::sin(azimuth), std::cos(eccentricity));
        sum += density(frame_.to_world(local)) * std::sin(eccentricity);
      }
    }
    return sum * ring_step * sector_step;
  }

 private:
  Frame frame_;
  double reach_rad_;
};

std::vector<double> cell_probabilities(const std::function<double(const Vec3&)>& density,
                                       const Cells& cells) {
  std::vector<double> probabilities;
  for (int ring = 0; ring < rings; ++ring) {
    for (int sector = 0; sector < sectors; ++sector) {
      probabilities.push_back(cells.integrate(ring, sector, density));
    }
  }
  return probabilities;
}

}  // namespace

double chi_squared_p_value(std::span<const Vec3> directions,
                           const std::function<double(const Vec3&)>& density_per_sr,
                           const Vec3& pole, double reach_rad) {
  const Cells cells(pole, reach_rad);
  std::vector<double> observed(static_cast<std::size_t>(rings) * sectors + 1, 0.0);
  for (const Vec3& direction : directions) {
    observed[cells.of(direction)] += 1.0;
  }
  std::vector<double> probabilities = cell_probabilities(density_per_sr, cells);
  const double inside = std::accumulate(probabilities.begin(), probabilities.end(), 0.0);
  probabilities.push_back(reach_rad < pi ? std::max(0.0, 1.0 - inside) : 0.0);
  double statistic = 0.0;
  double pooled_expected = 0.0;
  double pooled_observed = 0.0;
  int degrees_of_freedom = -1;
  const auto compare = [&](double count, double expected) {
    statistic += (count - expected) * (count - expected) / expected;
    ++degrees_of_freedom;
  };
  for (std::size_t i = 0; i < observed.size(); ++i) {
    const double expected = probabilities[i] * static_cast<double>(directions.size());
    if (expected >= 5.0) {
      compare(observed[i], expected);
    } else {
      pooled_expected += expected;
      pooled_observed += observed[i];
    }
  }
  if (pooled_expected >= 5.0) {
    compare(pooled_observed, pooled_expected);
  } else if (pooled_observed > 40.0) {
    return 0.0;  // many samples where the density says there are next to none
  }
  return boost::math::cdf(boost::math::complement(
      boost::math::chi_squared(std::max(degrees_of_freedom, 1)), statistic));
}

double integral_over_sphere(const std::function<double(const Vec3&)>& density_per_sr,
                            const Vec3& pole) {
  double sum = 0.0;
  for (const double probability : cell_probabilities(density_per_sr, Cells(pole, pi))) {
    sum += probability;
  }
  return sum;
}

}  // namespace foveola::test
