#include "scenes/arcade/patterns.h"

#include <algorithm>
#include <cmath>

#include "renderer/base/random.h"
#include "scenes/modelling/painting.h"

namespace foveola::scenes::arcade {

using namespace paint;  // NOLINT(google-build-using-namespace): its every name is drawn with here

Image weathered_stone(int size, const Rgb& color, const Seed& seed) {
  return painted(size, size, [&](double u, double v) {
    const double broad = cloud(u, v, 3, seed);
    const double grain = cloud(u, v, 96, mix(seed, 1));
    const double pores = smooth_step(0.66, 0.74, cloud(u, v, 48, mix(seed, 2)));
    const double streaks = smooth_step(0.5, 0.8, cloud(u, 0.5, 24, mix(seed, 3)));
    const double shade = 0.78 + 0.3 * broad + 0.16 * grain - 0.28 * pores - 0.1 * streaks * broad;
    const DVec3 warmth = blend(DVec3(1.0), {1.06, 0.98, 0.86}, cloud(u, v, 5, mix(seed, 4)));
    return DVec3(color) * shade * warmth;
  });
}

Image banner_cloth(int size, const Rgb& ground, const Seed& seed) {
  const DVec3 gold(0.62, 0.42, 0.12);
  const DVec3 cream(0.66, 0.6, 0.48);
  constexpr double edge = 0.002;
  constexpr double height = 1.53;  // of the banner in widths
  constexpr double threads_per_width = 160.0;
  return painted(size, size, [&](double u, double v) {
    const DVec2 p(u - 0.5, height * (0.5 - v));
    const DVec2 half(0.5, 0.5 * height);
    const double from_edge = -to_rectangle(p, half);
    // A field of lozenges with a dot in each.
    const DVec2 skew(7.0 * (p.x + 0.7 * p.y), 7.0 * (p.x - 0.7 * p.y));
    const double lattice = std::min(distance_to_integer(skew.x), distance_to_integer(skew.y));
    const DVec2 cell(distance_to_integer(skew.x + 0.5), distance_to_integer(skew.y + 0.5));
    DVec3 color = blend(DVec3(ground), DVec3(ground) * 0.6, inside(lattice - 0.06, 0.02));
    color = blend(color, gold, inside(glm::length(cell) - 0.12, 0.03));
    // The medallion.
    const double radius = glm::length(p - DVec2(0.0, 0.08));
    const DVec2 from_middle = p - DVec2(0.0, 0.08);
    color = blend(color, gold, inside(to_foil(from_middle, 8, 0.25, 0.11), edge));
    color = blend(color, DVec3(ground) * 0.8, inside(radius - 0.27, edge));
    color = blend(color, cream, stroke(radius - 0.24, 0.012, edge));
    const DVec2 ray = in_sector(from_middle, 8);
    color = blend(color, gold, inside(std::abs(ray.x) - 0.36 * (0.21 - ray.y), edge));
    color = blend(color, DVec3(ground) * 0.7, inside(radius - 0.055, edge));
    color = blend(color, cream, inside(to_foil(from_middle, 4, 0.018, 0.02), edge));
    // The border: a gold band with a row of foils between cream lines.
    color = blend(color, DVec3(ground) * 0.7, inside(from_edge - 0.085, edge));
    const bool on_side = half.x - std::abs(p.x) < half.y - std::abs(p.y);
    const double run = 11.0 * (on_side ? p.y : p.x);
    const DVec2 foil((run - std::round(run)) / 11.0, from_edge - 0.05);
    color = blend(color, gold, inside(to_foil(foil, 4, 0.013, 0.013), edge));
    color = blend(color, cream, stroke(from_edge - 0.085, 0.008, edge));
    color = blend(color, cream, stroke(from_edge - 0.016, 0.008, edge));
    const double weave = std::sin(6.2832 * threads_per_width * u) *
                         std::sin(6.2832 * threads_per_width * height * v);
    return color * (0.85 + 0.07 * weave + 0.28 * cloud(u, v, 6, seed));
  });
}

}  // namespace foveola::scenes::arcade
