#include "renderer/vision/vdp_sensitivity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "renderer/base/vec.h"
#include "renderer/vision/luminance_curves.h"

namespace foveola {
namespace {

using std::numbers::pi;

/// A stimulus at an eccentricity, scaled by cortical magnification.
struct MagnifiedStimulus {
  double frequency_cpd;
  double area_deg2;
  double luminance_cd_m2;  ///< L + M
};

struct Mechanism {
  PeakedCurve peak_sensitivity;
  SaturatingCurve peak_cpd;
  double bandwidth;
  double area_exponent;
  double critical_area;
  bool passes_low_frequencies;

  double sensitivity(const MagnifiedStimulus& stimulus) const {
    const double peak = peak_cpd.at(stimulus.luminance_cd_m2);
    const double summed = std::pow(stimulus.area_deg2, area_exponent) * stimulus.frequency_cpd *
                          stimulus.frequency_cpd;
    const double tuned =
        passes_low_frequencies && stimulus.frequency_cpd < peak
            ? 1.0
            : log_parabola(stimulus.frequency_cpd, peak, 0.5 * std::exp2(bandwidth));
    return peak_sensitivity.at(stimulus.luminance_cd_m2) * tuned *
           std::sqrt(summed / (critical_area + 0.65 * stimulus.area_deg2 + summed));
  }
};

constexpr PeakedCurve never_falls(const SaturatingCurve& curve) {
  return {.rise = curve, .fall = {0.0, 0.0, 0.0}};
}
constexpr SaturatingCurve constant(double value) { return {value, 0.0, 0.0}; }

constexpr std::array<Mechanism, 3> mechanisms = {{
    {.peak_sensitivity = {{356404.0, 6.2726, 0.320031}, {1.0, 895943.0, 7.77919e-5}},
     .peak_cpd = {2.3021, 3317.45, 0.186215},
     .bandwidth = 1.07516,
     .area_exponent = 1.1107,
     .critical_area = 52.9768,
     .passes_low_frequencies = false},
    {.peak_sensitivity = never_falls({423.978, 15.4032, 0.50343}),
     .peak_cpd = constant(0.122699),
     .bandwidth = 2.70669,
     .area_exponent = 1.72903,
     .critical_area = 1.38437,
     .passes_low_frequencies = true},
    {.peak_sensitivity = never_falls({11811.9, 196.342, 0.339396}),
     .peak_cpd = constant(7.1099e-8),
     .bandwidth = 5.3416,
     .area_exponent = 1.47263,
     .critical_area = 0.282573,
     .passes_low_frequencies = true},
}};

/// Responses of the mechanisms (rows) to cone contrasts.
const DMat3 mechanism_of_contrast =
    glm::transpose(DMat3(1.0, 0.256197, 6.42e-7,  //
                         1.0, -0.933541, 0.00373304, -0.00130319, -1.1504, 1.0));

/// Sensitivity to moving gratings (after Kelly 1979), up to its scale. speed: degrees per second.
double moving_sensitivity(double frequency_cpd, double speed) {
  const double slowest = std::max(speed, 0.1);
  const double k = 6.1 + 7.3 * std::pow(std::abs(std::log10(0.7986 * slowest / 3.0)), 3.0);
  const double peak_cpd = 45.9 / (0.7986 * slowest + 2.0);
  const double scaled = 0.8404 * 2.0 * pi * frequency_cpd;
  return k * 0.6329 * 0.8404 * 0.7986 * slowest * scaled * scaled *
         std::exp(-2.0 * scaled / peak_cpd);
}

double temporal_factor(VdpChannel channel, double frequency_cpd) {
  const double frequency_hz = channel == VdpChannel::transient ? 5.0 : 0.0;
  return moving_sensitivity(frequency_cpd, frequency_hz / frequency_cpd) /
         (moving_sensitivity(frequency_cpd, 0.0) + 1e-5);
}

/// An axis of the table.
struct Axis {
  double first;
  double last;

  double value(int i, int steps) const { return std::lerp(first, last, i / (steps - 1.0)); }
  /// The clamped position of a value, in steps.
  float place(float x, int steps) const {
    const auto lower = static_cast<float>(first);
    const auto upper = static_cast<float>(last);
    return (std::clamp(x, lower, upper) - lower) / (upper - lower) * static_cast<float>(steps - 1);
  }
};

const Axis log2_luminance = {std::log2(1e-3), std::log2(1e4)};
constexpr Axis log2_frequency = {-4.0, 6.0};
const Axis root_eccentricity = {0.0, std::sqrt(120.0)};

/// The steps around a position.
struct Between {
  int step;
  float share;

  Between(float place, int steps)
      : step(std::min(static_cast<int>(place), steps - 2)),
        share(place - static_cast<float>(step)) {}
};

}  // namespace

double vdp_sensitivity(VdpChannel channel, double frequency_cpd, double luminance_cd_m2,
                       double eccentricity_deg) {
  const double magnification = std::pow(3.67 / (eccentricity_deg + 3.67), 0.604562);
  const DVec3 cones = luminance_cd_m2 * DVec3(0.734752, 0.316277, 0.0208195);
  const DVec3 contrast = DVec3(0.698, 0.302, 0.019613) / cones;
  const double radius_deg = 1.5 * magnification / frequency_cpd;
  const MagnifiedStimulus stimulus = {.frequency_cpd = frequency_cpd / magnification,
                                      .area_deg2 = pi * radius_deg * radius_deg,
                                      .luminance_cd_m2 = cones.x + cones.y};
  DVec3 response = mechanism_of_contrast * contrast;
  for (int i = 0; i < 3; ++i) {
    response[i] *= mechanisms[static_cast<std::size_t>(i)].sensitivity(stimulus);
  }
  const double spatial = std::numbers::sqrt3 * glm::length(response) / glm::length(contrast);
  return std::max(spatial * temporal_factor(channel, stimulus.frequency_cpd), 1e-4);
}

VdpSensitivityTable::VdpSensitivityTable(VdpChannel channel) {
  const double log2_gain = 16.2596 / 20.0 * std::log2(10.0);
  log2_sensitivity_.reserve(std::size_t{steps} * steps * steps);
  for (int e = 0; e < steps; ++e) {
    const double root_deg = root_eccentricity.value(e, steps);
    for (int f = 0; f < steps; ++f) {
      const double frequency_cpd = std::exp2(log2_frequency.value(f, steps));
      for (int l = 0; l < steps; ++l) {
        const double luminance_cd_m2 = std::exp2(log2_luminance.value(l, steps));
        log2_sensitivity_.push_back(static_cast<float>(
            log2_gain + std::log2(vdp_sensitivity(channel, frequency_cpd, luminance_cd_m2,
                                                  root_deg * root_deg))));
      }
    }
  }
}

float VdpSensitivityTable::at(float frequency_cpd, float luminance_cd_m2,
                              float eccentricity_deg) const {
  const Between l(log2_luminance.place(std::log2(luminance_cd_m2), steps), steps);
  const Between f(log2_frequency.place(std::log2(frequency_cpd), steps), steps);
  const Between e(root_eccentricity.place(std::sqrt(eccentricity_deg), steps), steps);
  const float* corner = log2_sensitivity_.data() + (e.step * steps + f.step) * steps + l.step;
  const auto along_luminance = [&](int offset) {
    return corner[offset] + l.share * (corner[offset + 1] - corner[offset]);
  };
  const auto along_frequency = [&](int offset) {
    const float lower = along_luminance(offset);
    return lower + f.share * (along_luminance(offset + steps) - lower);
  };
  const float lower = along_frequency(0);
  return std::exp2(lower + e.share * (along_frequency(steps * steps) - lower));
}

}  // namespace foveola
