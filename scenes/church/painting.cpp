#include "scenes/church/painting.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/base/random.h"

namespace foveola::scenes::paint {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

/// Linear light as an sRGB byte (IEC 61966-2-1). The small offset keeps values that lie halfway
/// between two bytes, such as those of plain colours, on one side of it on every machine.
std::uint8_t srgb_byte(double linear) {
  const double x = std::clamp(linear, 0.0, 1.0);
  const double encoded = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255.0 * encoded + 1e-7));
}

/// Smooth noise in [0, 1] with one value at each integer point, repeating after `period`.
double lattice_noise(double x, double y, int period, std::uint32_t seed) {
  const int x0 = static_cast<int>(std::floor(x));
  const int y0 = static_cast<int>(std::floor(y));
  const double tx = smooth_step(0.0, 1.0, x - x0);
  const double ty = smooth_step(0.0, 1.0, y - y0);
  const auto at = [&](int i, int j) { return cell_value(i % period, j % period, seed); };
  return std::lerp(std::lerp(at(x0, y0), at(x0 + 1, y0), tx),
                   std::lerp(at(x0, y0 + 1), at(x0 + 1, y0 + 1), tx), ty);
}

/// The angle from upwards, clockwise, in turns within [0, 1).
double clockwise_turn(const DVec2& p) {
  const double turn = std::atan2(p.x, p.y) / two_pi;
  return turn - std::floor(turn);
}

}  // namespace

Image painted(int width, int height, const ColorFunction& color) {
  Image image{width, height, {}};
  image.rgba.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const DVec3 c = color((x + 0.5) / width, (y + 0.5) / height);
      image.rgba.insert(image.rgba.end(), {srgb_byte(c.r), srgb_byte(c.g), srgb_byte(c.b), 255});
    }
  }
  return image;
}

double smooth_step(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

DVec3 blend(const DVec3& a, const DVec3& b, double t) { return a + (b - a) * t; }

double cell_value(int x, int y, std::uint32_t seed) {
  return unit_float(mix(mix(seed + static_cast<std::uint32_t>(x)) + static_cast<std::uint32_t>(y)));
}

double cloud(double u, double v, int period, std::uint32_t seed) {
  double sum = 0.0;
  double weights = 0.0;
  for (int octave = 0; octave < 4; ++octave) {
    const int cells = period << octave;
    const double weight = 1.0 / (1 << octave);
    sum += weight * lattice_noise(u * cells, v * cells, cells,
                                  mix(seed, static_cast<std::uint32_t>(octave)));
    weights += weight;
  }
  return sum / weights;
}

double distance_to_integer(double x) { return std::abs(x - std::round(x)); }

double inside(double distance, double edge) { return 1.0 - smooth_step(-edge, edge, distance); }

double along(double distance, double width, double edge) {
  return inside(std::abs(distance) - 0.5 * width, edge);
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
  const DVec2 limb = b - a;
  const double t = std::clamp(glm::dot(p - a, limb) / glm::dot(limb, limb), 0.0, 1.0);
  return glm::distance(p, a + t * limb) - std::lerp(radius_a, radius_b, t);
}

int sector_of(const DVec2& p, int count) {
  return static_cast<int>(std::floor(clockwise_turn(p) * count + 0.5)) % count;
}

DVec2 in_sector(const DVec2& p, int count) {
  const double turn = clockwise_turn(p) * count + 0.5;
  const double angle = (turn - std::floor(turn) - 0.5) * two_pi / count;
  return glm::length(p) * DVec2(std::sin(angle), std::cos(angle));
}

}  // namespace foveola::scenes::paint
