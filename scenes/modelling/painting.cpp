#include "scenes/modelling/painting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "renderer/base/parallel.h"
#include "renderer/base/random.h"

namespace foveola::scenes::paint {
namespace {

using std::numbers::pi;

/// Linear light to sRGB bytes (IEC 61966-2-1), rounded.
class SrgbEncoder {
 public:
  SrgbEncoder() {
    for (std::size_t i = 0; i < thresholds_.size(); ++i) {
      const double encoded = (static_cast<double>(i) + 0.5) / 255.0;
      thresholds_[i] =
          encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
    }
    for (std::size_t i = 0; i < bytes_.size(); ++i) {
      bytes_[i] = next_byte(0, static_cast<double>(i) / bins);
    }
  }

  std::uint8_t byte(double linear) const {
    const auto bin = static_cast<std::size_t>(std::clamp(linear, 0.0, 1.0) * bins);
    return next_byte(bytes_[bin], linear);
  }

 private:
  static constexpr std::size_t bins = 4096;

  /// The byte for `linear`, which is known to be no less than `least`.
  std::uint8_t next_byte(std::size_t least, double linear) const {
    while (least < thresholds_.size() && thresholds_[least] <= linear) {
      ++least;
    }
    return static_cast<std::uint8_t>(least);
  }

  std::array<double, 255> thresholds_{};  ///< the linear value from which on a byte is one more
  std::array<std::uint8_t, bins + 1> bytes_{};  ///< for linear values in equal steps
};

/// Where along the line from a to b the point nearest to p lies, in [0, 1].
double nearest_on_segment(const DVec2& p, const DVec2& a, const DVec2& b) {
  const DVec2 segment = b - a;
  const double squared = glm::dot(segment, segment);
  return squared > 0.0 ? std::clamp(glm::dot(p - a, segment) / squared, 0.0, 1.0) : 0.0;
}

/// The angle from upwards, clockwise, in turns within [0, 1).
double clockwise_turn(const DVec2& p) {
  const double turn = std::atan2(p.x, p.y) / (2.0 * pi);
  return turn - std::floor(turn);
}

}  // namespace

Image painted(int width, int height, const ColorFunction& color) {
  return cut_out(width, height, [&](double u, double v) { return Texel{color(u, v)}; });
}

Image cut_out(int width, int height, const TexelFunction& texel) {
  constexpr std::size_t rows_in_block = 16;
  const SrgbEncoder srgb;
  Image image{width, height, {}};
  image.rgba.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
  const auto paint_row = [&](std::size_t y) {
    std::uint8_t* to = image.rgba.data() + y * static_cast<std::size_t>(width) * 4;
    for (int x = 0; x < width; ++x) {
      const Texel t = texel((x + 0.5) / width, (static_cast<double>(y) + 0.5) / height);
      *to++ = srgb.byte(t.color.r);
      *to++ = srgb.byte(t.color.g);
      *to++ = srgb.byte(t.color.b);
      *to++ = static_cast<std::uint8_t>(std::lround(255.0 * t.alpha));
    }
  };
  Workers().for_each_block(static_cast<std::size_t>(height), rows_in_block,
                           [&](std::size_t begin, std::size_t end) {
                             for (std::size_t y = begin; y < end; ++y) {
                               paint_row(y);
                             }
                           });
  return image;
}

double smooth_step(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

DVec3 blend(const DVec3& a, const DVec3& b, double t) { return a + (b - a) * t; }

double cell_value(int x, int y, const Seed& seed) {
  const std::uint32_t column = mix(seed.bits() + static_cast<std::uint32_t>(x));
  return unit_float(mix(column + static_cast<std::uint32_t>(y)));
}

double noise(double x, double y, int period_x, int period_y, const Seed& seed) {
  const int x0 = static_cast<int>(x);
  const int y0 = static_cast<int>(y);
  const int x1 = x0 + 1 == period_x ? 0 : x0 + 1;
  const int y1 = y0 + 1 == period_y ? 0 : y0 + 1;
  const double tx = smooth_step(0.0, 1.0, x - x0);
  const double ty = smooth_step(0.0, 1.0, y - y0);
  return std::lerp(std::lerp(cell_value(x0, y0, seed), cell_value(x1, y0, seed), tx),
                   std::lerp(cell_value(x0, y1, seed), cell_value(x1, y1, seed), tx), ty);
}

double cloud(double u, double v, int period, const Seed& seed) {
  return cloud(u, v, period, period, seed);
}

double cloud(double u, double v, int period_u, int period_v, const Seed& seed) {
  double sum = 0.0;
  double weight = 0.5;
  for (std::uint32_t octave = 0; octave < 4; ++octave) {
    const int scale = 1 << octave;
    const int cells_u = period_u * scale;
    const int cells_v = period_v * scale;
    sum += weight * noise(u * cells_u, v * cells_v, cells_u, cells_v, mix(seed, octave));
    weight *= 0.5;
  }
  return sum / (1.0 - 2.0 * weight);
}

double distance_to_integer(double x) { return std::abs(x - std::round(x)); }

double inside(double distance, double edge) { return 1.0 - smooth_step(-edge, edge, distance); }

double stroke(double distance, double width, double edge) {
  return inside(std::abs(distance) - 0.5 * width, edge);
}

double distance_to_segment(const DVec2& p, const DVec2& a, const DVec2& b) {
  return to_limb(p, a, b, 0.0, 0.0);
}

double to_circle(const DVec2& p, double radius) { return glm::length(p) - radius; }

double to_rectangle(const DVec2& p, const DVec2& half_size) {
  const DVec2 beyond = glm::abs(p) - half_size;
  return glm::length(glm::max(beyond, DVec2(0.0))) + std::min(std::max(beyond.x, beyond.y), 0.0);
}

double to_foil(const DVec2& p, int lobes, double offset, double radius) {
  return to_circle(in_sector(p, lobes) - DVec2(0.0, offset), radius);
}

double to_limb(const DVec2& p, const DVec2& a, const DVec2& b, double radius_a, double radius_b) {
  const double t = nearest_on_segment(p, a, b);
  return glm::distance(p, a + t * (b - a)) - std::lerp(radius_a, radius_b, t);
}

int sector_of(const DVec2& p, int count) {
  return static_cast<int>(std::floor(clockwise_turn(p) * count + 0.5)) % count;
}

DVec2 in_sector(const DVec2& p, int count) {
  const double turn = clockwise_turn(p) * count + 0.5;
  const double angle = (turn - std::floor(turn) - 0.5) * 2.0 * pi / count;
  return glm::length(p) * DVec2(std::sin(angle), std::cos(angle));
}

}  // namespace foveola::scenes::paint
