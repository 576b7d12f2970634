// Distributions of eccentricity around the gaze, with exact inverses.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "renderer/base/numbers/random.h"
#include "renderer/view/acuity.h"

namespace foveola {

/// Measure of an eccentricity e on the sphere. g(e) is proportional to the density times 2 pi e
/// (planar, as in the paper) or times 2 pi sin(e) (solid angle). They differ by e / sin(e): 1.42 at
/// 80 degrees.
enum class EccentricityMeasure { planar, solid_angle };

/// Converts a density per square degree to one per steradian. eccentricity_deg in [0, 180).
double density_per_sr(double per_square_degree, double eccentricity_deg,
                      EccentricityMeasure measure);

/// A probability distribution of eccentricity on [0, cut-off]; the azimuth around the gaze is
/// uniform.
class RadialDistribution {
 public:
  virtual ~RadialDistribution() = default;
  virtual double cutoff_deg() const = 0;
  /// Kinks and jumps of the density, strictly inside (0, cut-off), ascending.
  virtual std::vector<double> knees_deg() const = 0;
  /// The fraction of samples below an eccentricity.
  virtual double cumulative(double eccentricity_deg) const = 0;
  /// The inverse of cumulative(), for u in [0, 1]; used to build tables.
  virtual double eccentricity_deg(double u) const = 0;
  /// Probability density per steradian at an eccentricity; 0 beyond the cut-off.
  virtual double density_per_sr(double eccentricity_deg) const = 0;
};

/// The published distribution: Reddy's acuity, planar measure, in closed form, inverted by
/// Lambert's W. The integral of 2 pi e m(e) de to 80 degrees, the paper's normaliser H, is 1091.85.
class ReddyDistribution final : public RadialDistribution {
 public:
  /// cutoff_deg in (0, 180).
  explicit ReddyDistribution(double cutoff_deg);

  double cutoff_deg() const override { return cutoff_deg_; }
  std::vector<double> knees_deg() const override;
  double cumulative(double eccentricity_deg) const override;
  double eccentricity_deg(double u) const override;
  double density_per_sr(double eccentricity_deg) const override;

  /// The integral of 2 pi e m(e) de over [0, eccentricity_deg].
  double integral(double eccentricity_deg) const;

 private:
  double cutoff_deg_;
  double total_;
};

/// Any acuity model to any power in either measure, integrated numerically to 1e-12.
class AcuityDistribution final : public RadialDistribution {
 public:
  /// exponent positive, cutoff_deg in (0, 180).
  AcuityDistribution(AcuityModel model, double exponent, double cutoff_deg,
                     EccentricityMeasure measure);

  double cutoff_deg() const override { return cutoff_deg_; }
  std::vector<double> knees_deg() const override;
  double cumulative(double eccentricity_deg) const override;
  double eccentricity_deg(double u) const override;
  double density_per_sr(double eccentricity_deg) const override;

  /// Integral of the acuity's power over the field, in square degrees of the measure.
  double total() const { return sums_.back(); }

 private:
  /// The density per degree of eccentricity, not normalised.
  double weight(double eccentricity_deg) const;
  double integral(double from_deg, double to_deg) const;

  AcuityModel model_;
  double exponent_;
  double cutoff_deg_;
  EccentricityMeasure measure_;
  std::vector<double> nodes_deg_;  ///< nodes from 0 to the cut-off, the knees among them
  std::vector<double> sums_;       ///< the integral to each node
};

/// RadialDistribution::eccentricity_deg in turns, within 1e-6 relative at every float of [0, 1).
/// Over s = sqrt(u), the eccentricity is smooth between knees, where it may jump. It is
/// interpolated by cubics through exact values, denser where it is steep. The 6e-8 of the samples
/// beyond the last float below 1 are never drawn.
class EccentricityTable {
 public:
  explicit EccentricityTable(const RadialDistribution& distribution);

  /// u in [0, 1]; 1 is replaced by the largest float below it.
  float operator()(float u) const { return at_root(root(u)); }

  /// The two steps of operator(). Compilers vectorise the first. In double: where samples are rare,
  /// the last bit of a float spans many of them.
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
  /// An interval of s without a knee.
  struct Piece {
    double begin;
    double end;
    double cells_per_unit;
    std::size_t first_cubic;
  };

  /// Adds pieces over [begin, end], halved until they are precise enough.
  void add_pieces(const RadialDistribution& distribution, double begin, double end, int halvings);

  std::vector<Piece> pieces_;
  std::vector<Cubic> cubics_;
};

}  // namespace foveola
