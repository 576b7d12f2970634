#include "renderer/vision/castle_csf.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "renderer/vision/luminance_curves.h"

namespace foveola {
namespace {

double square(double x) { return x * x; }

/// Spatial summation: the area above which sensitivity is constant decreases with frequency.
struct Summation {
  double area_deg2;      ///< at low frequencies
  double frequency_cpd;  ///< where it begins to decrease

  double factor(const CsfStimulus& stimulus) const {
    const double critical = area_deg2 / (1.0 + square(stimulus.frequency_cpd / frequency_cpd));
    return stimulus.frequency_cpd * std::sqrt(critical / (1.0 + critical / stimulus.area_deg2));
  }
};

/// Decades of sensitivity lost per degree of eccentricity: constant + slope * frequency.
struct FallOff {
  double constant;
  double slope;
};

double eccentricity_factor(const CsfStimulus& stimulus, const FallOff& temporal,
                           const FallOff& nasal) {
  const double share = std::min(1.0, std::abs(stimulus.visual_field_deg - 180.0) / 90.0);
  const double constant = std::lerp(nasal.constant, temporal.constant, share);
  const double slope = std::lerp(nasal.slope, temporal.slope, share);
  return std::pow(10.0, -(constant + slope * stimulus.frequency_cpd) * stimulus.eccentricity_deg);
}

/// A band-pass mechanism keeps at least 1 - truncation at low frequencies.
double truncated_parabola(double frequency, double peak, double bandwidth, double truncation) {
  const double value = log_parabola(frequency, peak, std::exp2(bandwidth));
  return frequency < peak ? std::max(value, 1.0 - truncation) : value;
}

double sustained(const CsfStimulus& stimulus) {
  constexpr PeakedCurve peak_sensitivity = {{56.4947, 7.54726, 0.144532},
                                            {1.0, 5.58341e-7, 9.66862e9}};
  constexpr SaturatingCurve peak_cpd = {1.78119, 91.5718, 0.256682};
  constexpr Summation summation = {157.103, 0.702338};
  const double luminance = stimulus.luminance_cd_m2;
  return std::exp(-std::pow(stimulus.temporal_frequency_hz, 1.3314) / 10.5795) *
         peak_sensitivity.at(luminance) *
         truncated_parabola(stimulus.frequency_cpd, peak_cpd.at(luminance), 0.000213047, 0.100207) *
         summation.factor(stimulus);
}

double transient(const CsfStimulus& stimulus) {
  constexpr double exponent = 0.1898;
  constexpr Summation summation = {3.81611, 3.01389};
  const double log_luminance = std::log10(stimulus.luminance_cd_m2);
  // Below 0.0113 cd/m2 the peak frequency is negative, and its power complex.
  const std::complex<double> peak_hz = 4.7036 + 2.41482 * log_luminance;
  const double distance =
      std::abs(std::pow(stimulus.temporal_frequency_hz, exponent) - std::pow(peak_hz, exponent));
  const double peak_sensitivity = 2748.09 * std::pow(stimulus.luminance_cd_m2, 0.193434);
  return std::exp(-square(distance) / 0.0844836) * peak_sensitivity *
         truncated_parabola(stimulus.frequency_cpd, 0.000316696, 2.6761, 0.000241177) *
         summation.factor(stimulus);
}

/// A mechanism of two colours, low-pass.
struct ChromaticMechanism {
  SaturatingCurve peak_sensitivity;
  double corner_cpd;
  double bandwidth;
  Summation summation;
  double temporal_exponent;
  double temporal_scale;
  FallOff temporal;
  FallOff nasal;

  double sensitivity(const CsfStimulus& stimulus) const {
    return peak_sensitivity.at(stimulus.luminance_cd_m2) *
           truncated_parabola(stimulus.frequency_cpd, corner_cpd, bandwidth, 0.0) *
           summation.factor(stimulus) *
           std::exp(-std::pow(stimulus.temporal_frequency_hz, temporal_exponent) / temporal_scale) *
           eccentricity_factor(stimulus, temporal, nasal);
  }
};

constexpr ChromaticMechanism red_green = {.peak_sensitivity = {681.434, 38.0038, 0.480386},
                                          .corner_cpd = 0.0178364,
                                          .bandwidth = 2.42104,
                                          .summation = {2816.44, 0.0711058},
                                          .temporal_exponent = 1.15591,
                                          .temporal_scale = 16.4325,
                                          .temporal = {0.0591402, 0.0},
                                          .nasal = {2.89615e-5, 0.18108}};
constexpr ChromaticMechanism yellow_violet = {.peak_sensitivity = {166.683, 62.8974, 0.41193},
                                              .corner_cpd = 0.00425753,
                                              .bandwidth = 2.68197,
                                              .summation = {2.82789e7, 0.000635093},
                                              .temporal_exponent = 0.969123,
                                              .temporal_scale = 7.15012,
                                              .temporal = {0.00356865, 0.00806631},
                                              .nasal = {0.0, 0.0110662}};

}  // namespace

CastleSensitivity castle_sensitivity(const CsfStimulus& stimulus) {
  constexpr FallOff temporal = {0.0239853, 0.0189038};
  constexpr FallOff nasal = {0.0400662, 0.00813619};
  return {.achromatic = (sustained(stimulus) + transient(stimulus)) *
                        eccentricity_factor(stimulus, temporal, nasal),
          .red_green = red_green.sensitivity(stimulus),
          .yellow_violet = yellow_violet.sensitivity(stimulus)};
}

double castle_sensitivity(const CsfStimulus& stimulus, const DVec3& lms_step,
                          const DVec3& lms_background) {
  const CastleSensitivity by_mechanism = castle_sensitivity(stimulus);
  const double background = lms_background.x + lms_background.y;
  const DVec3 contrast = DVec3(lms_step.x + lms_step.y, lms_step.x - 2.3112 * lms_step.y,
                               50.9875 * lms_step.z - lms_step.x - lms_step.y) /
                         background;
  const DVec3 sensitivities(by_mechanism.achromatic, by_mechanism.red_green,
                            by_mechanism.yellow_violet);
  return std::numbers::sqrt3 * glm::length(contrast * sensitivities) /
         glm::length(lms_step / lms_background);
}

}  // namespace foveola
