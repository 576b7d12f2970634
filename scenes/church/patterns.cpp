#include "scenes/church/patterns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "renderer/base/random.h"
#include "scenes/modelling/painting.h"

namespace foveola::scenes {
namespace {

using namespace paint;  // NOLINT(google-build-using-namespace): its every name is drawn with here

const DVec3 gold(0.72, 0.48, 0.12);

}  // namespace

Image veined_marble(int size, const Rgb& ground, const Rgb& vein, const Seed& seed) {
  return painted(size, size, [&](double u, double v) {
    const double bend = cloud(u, v, 3, seed);
    const double fine = cloud(u, v, 7, mix(seed, 1));
    const double coarse_vein = 1.0 - smooth_step(0.0, 0.05, std::abs(bend - 0.5));
    const double fine_vein = 1.0 - smooth_step(0.0, 0.035, std::abs(fine - 0.52));
    const double amount = std::min(1.0, 0.7 * coarse_vein * fine * 1.6 + 0.35 * fine_vein);
    return blend(DVec3(ground) * (0.85 + 0.3 * fine), DVec3(vein), amount);
  });
}

Image starry_sky(int size, const Seed& seed) {
  constexpr int stars = 6;
  return painted(size, size, [&](double u, double v) {
    const double x = u * stars;
    const double y = v * stars;
    const int i = static_cast<int>(x);
    const int j = static_cast<int>(y);
    const DVec2 from_middle(x - i - 0.3 - 0.4 * cell_value(i, j, seed),
                            y - j - 0.3 - 0.4 * cell_value(j, i, mix(seed, 1)));
    const DVec2 ray = in_sector(from_middle, 6);
    const double size_here = 0.12 + 0.1 * cell_value(i + j, i, mix(seed, 2));
    const double star = inside(std::abs(ray.x) - 0.3 * (size_here - ray.y), 0.012);
    const double patchy = 0.7 + 0.6 * cloud(u, v, 6, mix(seed, 3));
    return blend(DVec3(0.05, 0.11, 0.36) * patchy, gold, star);
  });
}

Image altar_frontal(int height, const Seed& seed) {
  return painted(2 * height, height, [&](double u, double v) {
    const DVec2 cell(6.0 * u - std::floor(6.0 * u) - 0.5, 3.0 * v - std::floor(3.0 * v) - 0.5);
    const double arms =
        std::min(to_rectangle(cell, {0.05, 0.26}), to_rectangle(cell, {0.26, 0.05}));
    const double cross = inside(arms, 0.012);
    const double ring = stroke(to_circle(cell, 0.38), 0.03, 0.01);
    const double weave = 0.9 + 0.1 * std::sin(900.0 * u) * std::sin(450.0 * v);
    const DVec3 red = DVec3(0.34, 0.02, 0.03) * (0.8 + 0.4 * cloud(u, v, 5, seed));
    DVec3 color = blend(red, gold, std::max(cross, ring));
    const bool braid = (v > 0.02 && v < 0.05) || (v > 0.84 && v < 0.87);
    const double threads = 0.55 + 0.45 * std::sin(500.0 * u);
    color = braid ? gold : v > 0.87 ? gold * threads : color;
    return color * weave;
  });
}

Image open_book(int size, const Seed& seed) {
  constexpr int lines = 18;
  return painted(size, size, [&](double u, double v) {
    const double page_u = 2.0 * u - std::floor(2.0 * u);
    const bool in_block = page_u > 0.14 && page_u < 0.86 && v > 0.1 && v < 0.9;
    const double y = (v - 0.1) / 0.8 * lines;
    const int line = static_cast<int>(std::floor(y));
    const double letters = cloud(u, (line + 0.5) / 64.0, 48, seed);
    const bool is_ink = in_block && letters > 0.46 && std::abs(y - line - 0.5) < 0.28;
    const bool is_initial = page_u > 0.14 && page_u < 0.28 && v > 0.1 && v < 0.24;
    const DVec3 paper = DVec3(0.66, 0.6, 0.46) * (0.9 + 0.2 * cloud(u, v, 6, mix(seed, 1)));
    const double gutter = smooth_step(0.0, 0.05, std::abs(u - 0.5));
    const DVec3 ink = is_initial ? DVec3(0.45, 0.03, 0.03) : DVec3(0.05, 0.04, 0.04);
    return blend(paper, ink, is_ink || is_initial ? 0.85 : 0.0) * (0.5 + 0.5 * gutter);
  });
}

}  // namespace foveola::scenes
