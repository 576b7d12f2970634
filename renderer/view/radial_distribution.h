// Where samples fall around the gaze: distributions of eccentricity, with exact inverses.
#pragma once

#include <vector>

#include "renderer/view/acuity.h"

namespace foveola {

/// How samples of an eccentricity e are spread over the sphere: g(e) is proportional to the density
/// times 2 pi e (the paper's, as if the field of view were a plane) or times 2 pi sin(e), which is
/// the density per solid angle. They differ by e / sin(e): 1.42 at 80 degrees.
enum class EccentricityMeasure { planar, solid_angle };

/// A density per square degree of `measure` as one per steradian. eccentricity_deg in [0, 180).
double density_per_sr(double per_square_degree, double eccentricity_deg,
                      EccentricityMeasure measure);

/// A probability distribution of eccentricity on [0, cut-off]; the azimuth around the gaze is
/// uniform.
class RadialDistribution {
 public:
  virtual ~RadialDistribution() = default;
  virtual double cutoff_deg() const = 0;
  /// Where the density bends or jumps, strictly inside (0, cut-off), ascending.
  virtual std::vector<double> knees_deg() const = 0;
  /// The fraction of samples below an eccentricity.
  virtual double cumulative(double eccentricity_deg) const = 0;
  /// The inverse of cumulative, for u in [0, 1]; for setting up tables.
  virtual double eccentricity_deg(double u) const = 0;
  /// Samples per steradian at an eccentricity, of one sample in all; 0 beyond the cut-off.
  virtual double density_per_sr(double eccentricity_deg) const = 0;
};

/// The published one: Reddy's acuity, planar measure, in closed form; its inverse is by Lambert's
/// W. The integral of 2 pi e m(e) de to 80 degrees, the paper's normaliser H, is 1091.85.
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

  /// The integral of the acuity to its power over the field, in square degrees of the measure.
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

}  // namespace foveola
