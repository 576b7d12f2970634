// The contrast sensitivity of FovVideoVDP, as a table.
#pragma once

#include <vector>

namespace foveola {

/// The temporal channels of FovVideoVDP.
enum class VdpChannel { sustained, transient };

/// Contrast sensitivity of FovVideoVDP 1.2 at one temporal frequency: 0 Hz for the sustained
/// channel, 5 Hz for the transient one (Mantiuk et al. 2021, ACM TOG 40(4), with the constants of
/// version 1.2). At least 1e-4. luminance_cd_m2 and frequency_cpd: above 0.
double vdp_sensitivity(VdpChannel channel, double frequency_cpd, double luminance_cd_m2,
                       double eccentricity_deg);

/// The same from a table, times the gain of FovVideoVDP: trilinear in log2 of luminance, log2 of
/// frequency and the root of eccentricity, which are clamped to 1e-3..1e4 cd/m2, 1/16..64 cpd and
/// 0..120 degrees. Thread-safe.
class VdpSensitivityTable {
 public:
  explicit VdpSensitivityTable(VdpChannel channel);

  float at(float frequency_cpd, float luminance_cd_m2, float eccentricity_deg) const;

 private:
  static constexpr int steps = 32;  ///< values along each axis

  std::vector<float> log2_sensitivity_;  ///< [eccentricity][frequency][luminance]
};

}  // namespace foveola
