// Computes the eye's thresholds over eccentricity, in channels of lightness and colour.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "renderer/base/vec.h"
#include "study/participant/population.h"

namespace foveola::study {

/// The opponent channels.
enum class Channel : std::size_t { achromatic, red_green, blue_yellow };
inline constexpr std::size_t channel_count = 3;
using ChannelValues = std::array<double, channel_count>;

/// Returns the channels of an sRGB-encoded colour, in just noticeable differences at the gaze:
/// CIELAB (D65, whose L*, a* and b* are the three channels), linearised at middle grey (encoded
/// 0.5), over jnd_lab. For greys from 0.2 to 1, CIELAB's derivatives by encoded values stay within
/// 17 % of this linear map's.
ChannelValues opponent_channels(const Rgb& encoded, double jnd_lab);

/// Returns the threshold of `channel` at eccentricity_deg over that of a large area at the gaze,
/// for cells of cell_deg, of which two make a period. With f = 1 / (2 cell_deg) it is exp(decay f
/// (e + e2) / e2), the contrast threshold of Geisler and Perry (1998, eq. 1) over its CT0. For
/// chromatic channels it is exp(decay f (chromatic_decay_factor + e / e2)), for red-green times
/// 10^(decades e).
double relative_threshold(const Vision& vision, Channel channel, double cell_deg,
                          double eccentricity_deg);

/// Tabulates the inverse squares of thresholds over eccentricity for cells of one size.
class Visibility {
 public:
  Visibility(const Vision& vision, double cell_deg);

  /// Returns 1 / threshold^2 of each channel at the angle from the gaze whose cosine is `cosine`:
  /// less than 1, and decreasing with the angle. In steps of 0.02 degrees; constant beyond 90
  /// degrees.
  const std::array<float, channel_count>& at(float cosine) const;

 private:
  std::vector<std::array<float, channel_count>> by_chord_;
};

}  // namespace foveola::study
