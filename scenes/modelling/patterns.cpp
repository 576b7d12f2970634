#include "scenes/modelling/patterns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "renderer/base/random.h"

namespace foveola::scenes {
namespace {

/// A texel's linear colour and its alpha.
struct Texel {
  DVec3 color{0.0};
  double alpha = 1.0;
};

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
  std::array<std::uint8_t, bins + 1> bytes_{};  ///< of linear values in equal steps
};

/// An image whose texel at (u, v) in (0, 1) from the top left is texel(u, v).
template <typename Function>
Image painted(int width, int height, const Function& texel) {
  const SrgbEncoder srgb;
  Image image{width, height, {}};
  image.rgba.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
  std::uint8_t* to = image.rgba.data();
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Texel t = texel((x + 0.5) / width, (y + 0.5) / height);
      *to++ = srgb.byte(t.color.r);
      *to++ = srgb.byte(t.color.g);
      *to++ = srgb.byte(t.color.b);
      *to++ = static_cast<std::uint8_t>(std::lround(255.0 * t.alpha));
    }
  }
  return image;
}

double smooth_step(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

double blend(double a, double b, double t) { return a + (b - a) * t; }
DVec3 blend(const DVec3& a, const DVec3& b, double t) { return a + (b - a) * t; }

/// A number in [0, 1) for the cell (x, y).
double cell_value(int x, int y, std::uint32_t seed) {
  return unit_float(mix(mix(seed + static_cast<std::uint32_t>(x)) + static_cast<std::uint32_t>(y)));
}

/// Smooth noise in [0, 1] with one value at each integer point, repeating after the periods (value
/// noise, Perlin 1985 with a smoothed lattice).
class Noise {
 public:
  Noise(int period_x, int period_y, std::uint32_t seed) : period_x_(period_x), period_y_(period_y) {
    lattice_.reserve(static_cast<std::size_t>(period_x) * static_cast<std::size_t>(period_y));
    for (int y = 0; y < period_y; ++y) {
      for (int x = 0; x < period_x; ++x) {
        lattice_.push_back(static_cast<float>(cell_value(x, y, seed)));
      }
    }
  }

  /// For x in [0, period_x) and y in [0, period_y).
  double at(double x, double y) const {
    const int x0 = static_cast<int>(x);
    const int y0 = static_cast<int>(y);
    const int x1 = x0 + 1 == period_x_ ? 0 : x0 + 1;
    const int y1 = y0 + 1 == period_y_ ? 0 : y0 + 1;
    const double tx = smooth_step(0.0, 1.0, x - x0);
    const double ty = smooth_step(0.0, 1.0, y - y0);
    const double top = blend(value(x0, y0), value(x1, y0), tx);
    const double bottom = blend(value(x0, y1), value(x1, y1), tx);
    return blend(top, bottom, ty);
  }

 private:
  double value(int x, int y) const { return lattice_[static_cast<std::size_t>(y * period_x_ + x)]; }

  int period_x_;
  int period_y_;
  std::vector<float> lattice_;
};

/// Four octaves of noise in [0, 1] over the unit square, coarsest with the given periods.
class FractalNoise {
 public:
  FractalNoise(int period_x, int period_y, std::uint32_t seed)
      : period_x_(period_x), period_y_(period_y) {
    for (int octave = 0; octave < octave_count; ++octave) {
      octaves_.emplace_back(period_x << octave, period_y << octave,
                            mix(seed, static_cast<std::uint32_t>(octave)));
    }
  }

  double at(double u, double v) const {
    double sum = 0.0;
    double weight = 0.5;
    double x = u * period_x_;
    double y = v * period_y_;
    for (const Noise& octave : octaves_) {
      sum += weight * octave.at(x, y);
      weight *= 0.5;
      x *= 2.0;
      y *= 2.0;
    }
    return sum / (1.0 - 2.0 * weight);
  }

 private:
  static constexpr int octave_count = 4;

  int period_x_;
  int period_y_;
  std::vector<Noise> octaves_;
};

/// How far x is from the nearest integer, in [0, 0.5].
double distance_to_integer(double x) { return std::abs(x - std::round(x)); }

double distance_to_segment(const DVec2& p, const DVec2& a, const DVec2& b) {
  const DVec2 along = b - a;
  const double t = std::clamp(glm::dot(p - a, along) / glm::dot(along, along), 0.0, 1.0);
  return glm::distance(p, a + t * along);
}

/// 1 inside a stroke of the given width around a line, 0 outside, soft over `edge`.
double stroke(double distance, double width, double edge) {
  return 1.0 - smooth_step(0.5 * width - edge, 0.5 * width + edge, distance);
}

}  // namespace

Image floor_tiles(int size, int tiles, const Rgb& first, const Rgb& second, std::uint32_t seed) {
  constexpr double joint = 0.025;
  const FractalNoise clouds(3 * tiles, 3 * tiles, mix(seed, 1));
  return painted(size, size, [&](double u, double v) {
    const double x = u * tiles;
    const double y = v * tiles;
    const int column = static_cast<int>(x);
    const int row = static_cast<int>(y);
    const DVec3 color((column + row) % 2 == 0 ? first : second);
    const double shade = 0.85 + 0.3 * cell_value(column, row, seed);
    const double cloud = 0.8 + 0.4 * clouds.at(u, v);
    const double from_joint = std::min(distance_to_integer(x), distance_to_integer(y));
    const double tile = smooth_step(0.5 * joint, joint, from_joint);
    return Texel{blend(DVec3(0.18), color * shade * cloud, tile)};
  });
}

Image masonry(int size, const Masonry& masonry, std::uint32_t seed) {
  const FractalNoise roughnesses(24, 24, mix(seed, 1));
  return painted(size, size, [&](double u, double v) {
    const double y = v * masonry.courses;
    const int course = static_cast<int>(y);
    const double x = u * masonry.stones + (course % 2 == 0 ? 0.0 : 0.5);
    const int stone = static_cast<int>(x) % masonry.stones;
    const double stone_length = static_cast<double>(masonry.courses) / masonry.stones;
    const double from_joint =
        std::min(distance_to_integer(x) * stone_length, distance_to_integer(y));
    const double roughness = roughnesses.at(u, v);
    const double shade = 1.0 + masonry.variation * (2.0 * cell_value(stone, course, seed) - 1.0);
    const double inside =
        smooth_step(0.5 * masonry.joint, masonry.joint, from_joint + 0.02 * (roughness - 0.5));
    const DVec3 color = DVec3(masonry.stone) * shade * (0.75 + 0.5 * roughness);
    return Texel{blend(DVec3(masonry.mortar), color, inside)};
  });
}

Image wood(int size, int boards, const Rgb& light, const Rgb& dark, std::uint32_t seed) {
  std::vector<FractalNoise> bends;
  std::vector<FractalNoise> fibres;
  for (int board = 0; board < boards; ++board) {
    const std::uint32_t board_seed = mix(seed, static_cast<std::uint32_t>(board));
    bends.emplace_back(2 * boards, 2, board_seed);
    fibres.emplace_back(64 * boards, 4, mix(board_seed, 1));
  }
  return painted(size, size, [&](double u, double v) {
    const double x = u * boards;
    const int board = static_cast<int>(x);
    const double bend = bends[board].at(u, v);
    const double rings = std::sin(2.0 * std::numbers::pi * (6.0 * x + 5.0 * bend));
    const double grain =
        std::clamp(0.35 + 0.25 * rings + 0.5 * (fibres[board].at(u, v) - 0.3), 0.0, 1.0);
    const double shade = 0.85 + 0.3 * cell_value(board, 0, seed);
    const double gap = smooth_step(0.004, 0.012, distance_to_integer(x));
    return Texel{blend(DVec3(light), DVec3(dark), grain) * shade * (0.35 + 0.65 * gap)};
  });
}

Image plaster(int size, const Rgb& color, double variation, std::uint32_t seed) {
  const FractalNoise coarse(4, 4, seed);
  const FractalNoise fine(40, 40, mix(seed, 1));
  return painted(size, size, [&](double u, double v) {
    const double shade = 1.0 + variation * (1.4 * coarse.at(u, v) + 0.6 * fine.at(u, v) - 1.0);
    return Texel{DVec3(color) * shade};
  });
}

Image cloth(int size, int stripes, const Rgb& ground, const Rgb& stripe, std::uint32_t seed) {
  const double threads = size / 8.0;
  const FractalNoise wear(6, 6, seed);
  return painted(size, size, [&](double u, double v) {
    const double from_middle = distance_to_integer(u * stripes);
    const double band = 1.0 - smooth_step(0.12, 0.14, from_middle);
    const double hem = stroke(std::abs(from_middle - 0.2), 0.02, 0.004);
    const DVec3 color = blend(DVec3(ground), DVec3(stripe), std::max(band, hem));
    const double weave = std::sin(2.0 * std::numbers::pi * u * threads) *
                         std::sin(2.0 * std::numbers::pi * v * threads);
    return Texel{color * (0.85 + 0.08 * weave + 0.3 * (wear.at(u, v) - 0.35))};
  });
}

Image ceiling_panels(int size, int panels, std::uint32_t seed) {
  constexpr int holes = 24;
  const FractalNoise shades(16, 16, seed);
  return painted(size, size, [&](double u, double v) {
    const double x = u * panels;
    const double y = v * panels;
    const double from_groove = std::min(distance_to_integer(x), distance_to_integer(y));
    const double groove = smooth_step(0.006, 0.014, from_groove);
    const DVec2 from_hole(distance_to_integer(x * holes + 0.5),
                          distance_to_integer(y * holes + 0.5));
    const double hole = 1.0 - smooth_step(0.1, 0.2, glm::length(from_hole));
    const double shade = 0.96 + 0.08 * shades.at(u, v);
    return Texel{DVec3(0.72) * shade * (0.4 + 0.6 * groove) * (1.0 - 0.5 * hole * groove)};
  });
}

Image leaf(int size, const Rgb& color, std::uint32_t seed) {
  constexpr double stalk_length = 0.12;
  const FractalNoise shades(5, 5, seed);
  return painted(size, size, [&](double u, double v) {
    const double along = 1.0 - v;
    const double across = u - 0.5;
    const double t = std::clamp((along - stalk_length) / (1.0 - stalk_length), 0.0, 1.0);
    const double half_width = 0.72 * std::sqrt(t) * (1.0 - t);
    const bool blade = along > stalk_length && std::abs(across) < half_width;
    const bool stalk = along <= stalk_length + 0.05 && std::abs(across) < 0.018;
    const double rib = stroke(std::abs(across), 0.03, 0.008);
    const double veins =
        stroke(distance_to_integer(9.0 * (along - 0.9 * std::abs(across))), 0.12, 0.05);
    const double shade = 0.75 + 0.5 * shades.at(u, v);
    const DVec3 lighter = DVec3(color) * 1.6 + DVec3(0.03);
    return Texel{blend(DVec3(color) * shade, lighter, std::max(rib, 0.5 * veins)),
                 blade || stalk ? 1.0 : 0.0};
  });
}

Image written_board(int height, std::uint32_t seed) {
  constexpr double edge = 0.002;
  constexpr int lines = 9;
  const DVec3 black(0.03);
  const DVec3 blue(0.03, 0.08, 0.4);
  const DVec3 red(0.5, 0.04, 0.03);
  const FractalNoise clouds(4, 4, seed);
  const Noise gaps(128, lines, mix(seed, 1));
  const Noise waves(128, lines, mix(seed, 2));
  return painted(2 * height, height, [&](double u, double v) {
    const DVec2 p(2.0 * u, v);
    DVec3 color = DVec3(0.74) * (0.97 + 0.06 * clouds.at(u, v));
    const auto draw = [&](const DVec3& ink, double amount) { color = blend(color, ink, amount); };
    // Writing: on each line a wavering stroke, broken into words.
    const double y = (p.y - 0.12) / 0.085;
    const int line = static_cast<int>(std::floor(y));
    if (line >= 0 && line < lines && p.x > 0.1 && p.x < 0.95 - 0.25 * cell_value(line, 0, seed)) {
      const bool in_word = gaps.at(p.x * 14.0, line) > 0.28;
      const double letters = waves.at(p.x * 70.0, line) - 0.5;
      const double height_in_line = y - line - 0.5;
      draw(line == 0 ? red : black,
           in_word ? stroke(std::abs(height_in_line - 0.75 * letters), 0.16, 0.05) : 0.0);
    }
    // A chart: axes and a rising line over bars.
    const DVec2 origin(1.12, 0.8);
    const DVec2 right(1.9, 0.8);
    const DVec2 up(1.12, 0.15);
    draw(black, stroke(distance_to_segment(p, origin, right), 0.01, edge));
    draw(black, stroke(distance_to_segment(p, origin, up), 0.01, edge));
    constexpr int bars = 6;
    const double bar_position = (p.x - origin.x) / (right.x - origin.x) * bars;
    const int bar = static_cast<int>(std::floor(bar_position));
    if (bar >= 0 && bar < bars && p.y < origin.y && bar_position - bar > 0.35) {
      const double top = origin.y - 0.1 - 0.07 * bar - 0.08 * cell_value(bar, 1, seed);
      draw(bar % 2 == 0 ? blue : red, p.y > top ? 0.8 : 0.0);
    }
    draw(black, stroke(distance_to_segment(p, {1.16, 0.66}, {1.86, 0.2}), 0.012, edge));
    return Texel{color};
  });
}

Image landscape(int size, std::uint32_t seed) {
  constexpr int ridges = 4;
  std::vector<FractalNoise> skylines;
  for (int ridge = 0; ridge < ridges; ++ridge) {
    skylines.emplace_back(3, 3, mix(seed, static_cast<std::uint32_t>(ridge)));
  }
  return painted(size, size, [&](double u, double v) {
    const DVec3 sky = blend({0.15, 0.3, 0.65}, {0.85, 0.6, 0.4}, smooth_step(0.0, 0.55, v));
    DVec3 color = sky;
    for (int ridge = 0; ridge < ridges; ++ridge) {
      const double height = 0.42 + 0.13 * ridge - 0.2 * (skylines[ridge].at(u, 0.5) - 0.4);
      const DVec3 hill = blend({0.3, 0.35, 0.45}, {0.08, 0.18, 0.04}, ridge / 3.0);
      color = blend(color, hill, smooth_step(height, height + 0.01, v));
    }
    return Texel{color};
  });
}

Image clock_face(int size) {
  constexpr double edge = 0.004;
  return painted(size, size, [&](double u, double v) {
    const DVec2 p(u - 0.5, 0.5 - v);
    const double radius = glm::length(p);
    const double turn = std::atan2(p.x, p.y) / (2.0 * std::numbers::pi);
    const double from_hour = distance_to_integer(12.0 * turn) / 12.0 * 2.0 * std::numbers::pi;
    const double mark =
        radius > 0.36 && radius < 0.44 ? stroke(from_hour * radius, 0.025, edge) : 0.0;
    const auto hand = [&](double turn_of_hand, double length, double width) {
      const double angle = 2.0 * std::numbers::pi * turn_of_hand;
      const DVec2 tip = length * DVec2(std::sin(angle), std::cos(angle));
      return stroke(distance_to_segment(p, {0.0, 0.0}, tip), width, edge);
    };
    constexpr double ten_past_ten = (10.0 + 1.0 / 6.0) / 12.0;
    const double ink =
        std::max({mark, hand(ten_past_ten, 0.24, 0.035), hand(1.0 / 6.0, 0.36, 0.022)});
    return Texel{blend(DVec3(0.78), DVec3(0.03), ink)};
  });
}

}  // namespace foveola::scenes
