// How far the paper's equations 5 and 7 are from what they stand for, from their coefficients.
#pragma once

namespace foveola {

/// The largest error of something, and at which random number and radius of equation 7.
struct LargestError {
  double error = 0.0;  ///< with its sign
  double u = 0.0;
  double eccentricity_deg = 0.0;
};

/// Equation 7 (Equation7Distribution) beside the exact inverse to 80 degrees (ReddyDistribution).
/// The paper (section 3) states "the maximum approximation error" and "the integral of the
/// difference", but not of what; here is every reading of them.
struct Equation7Errors {
  double gap_begin_deg = 0.0;  ///< the ring without samples, at the switch of the branches
  double gap_end_deg = 0.0;
  double last_radius_deg = 0.0;  ///< at u = 1, where the exact one is 80

  LargestError radius_relative;
  LargestError radius_deg;
  LargestError density_relative;  ///< at equal radius, outside the gap
  LargestError share;             ///< of the samples within a radius

  double mean_radius_deg = 0.0;  ///< the exact one's: its integral over u
  /// Integrals over u: of the radius's difference, its absolute value, and that over the radius.
  double signed_radius_difference_deg = 0.0;
  double radius_difference_deg = 0.0;
  double relative_radius_difference = 0.0;
  /// The integral over all radii of the absolute difference of the densities.
  double density_difference = 0.0;

  double foveal_share = 0.0;        ///< of equation 7's samples, within 5.79 degrees
  double exact_foveal_share = 0.0;  ///< of equation 2's
};

Equation7Errors equation7_errors();

/// Equation 5, the integral of equation 2 in square degrees, whose constants are printed rounded.
struct Equation5Errors {
  /// By how much its second branch starts above where the first ends, at 5.79 degrees.
  double jump = 0.0;
  double normaliser = 0.0;  ///< at 80 degrees, as printed
  double exact_normaliser = 0.0;
};

Equation5Errors equation5_errors();

}  // namespace foveola
