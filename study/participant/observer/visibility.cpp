#include "study/participant/observer/visibility.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/base/angles.h"

namespace foveola::study {
namespace {

/// Derivatives of CIELAB's L*, a* and b* by sRGB-encoded red, green and blue at (0.5, 0.5, 0.5), by
/// central differences of the formulas of CIE 15 and IEC 61966-2-1.
constexpr std::array<std::array<double, 3>, channel_count> lab_by_encoded{{
    {21.2716, 71.5296, 7.2190},
    {95.3972, -146.1253, 50.7280},
    {33.6130, 104.4493, -138.0623},
}};

constexpr std::size_t steps = 4096;
constexpr double longest_chord = std::numbers::sqrt2;  // The chord of 90 degrees.

}  // namespace

ChannelValues opponent_channels(const Rgb& encoded, double jnd_lab) {
  ChannelValues values{};
  for (std::size_t channel = 0; channel < channel_count; ++channel) {
    const auto& row = lab_by_encoded[channel];
    values[channel] = (row[0] * encoded.r + row[1] * encoded.g + row[2] * encoded.b) / jnd_lab;
  }
  return values;
}

double relative_threshold(const Vision& vision, Channel channel, double cell_deg,
                          double eccentricity_deg) {
  const double cycles_per_deg = 0.5 / cell_deg;
  const double at_gaze = channel == Channel::achromatic ? 1.0 : vision.chromatic_decay_factor;
  const double threshold = std::exp(vision.decay_deg * cycles_per_deg *
                                    (at_gaze + eccentricity_deg / vision.half_resolution_deg));
  return channel == Channel::red_green
             ? threshold * std::pow(10.0, vision.red_green_decades_per_deg * eccentricity_deg)
             : threshold;
}

Visibility::Visibility(const Vision& vision, double cell_deg) : by_chord_(steps) {
  for (std::size_t i = 0; i < steps; ++i) {
    const double chord = longest_chord * (static_cast<double>(i) + 0.5) / steps;
    const double eccentricity_deg = degrees(2.0 * std::asin(0.5 * chord));
    for (std::size_t channel = 0; channel < channel_count; ++channel) {
      const double threshold = relative_threshold(vision, static_cast<Channel>(channel), cell_deg,
                                                  i == 0 ? 0.0 : eccentricity_deg);
      by_chord_[i][channel] = static_cast<float>(1.0 / (threshold * threshold));
    }
  }
}

const std::array<float, channel_count>& Visibility::at(float cosine) const {
  constexpr auto steps_per_chord = static_cast<float>(steps / longest_chord);
  const float chord = std::sqrt(std::max(0.0F, 2.0F * (1.0F - cosine)));
  return by_chord_[std::min(steps - 1, static_cast<std::size_t>(chord * steps_per_chord))];
}

}  // namespace foveola::study
