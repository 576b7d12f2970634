#include "scenes/modelling/column.h"

#include <cmath>
#include <numbers>

namespace foveola::scenes {
namespace {

using std::numbers::pi;

/// Half a torus' outline that bulges from `radius`, from height `from` over `height`.
void add_roll(std::vector<DVec2>& outline, double radius, double bulge, double from,
              double height) {
  constexpr int steps = 4;
  for (int i = 0; i <= steps; ++i) {
    const double angle = pi * (static_cast<double>(i) / steps - 0.5);
    outline.emplace_back(radius + bulge * std::cos(angle),
                         from + 0.5 * height * (1.0 + std::sin(angle)));
  }
}

/// An acanthus leaf before a capital's bell at z = 0: its tip curls outwards and down, its edge is
/// lobed, its midrib stands out.
Shape acanthus_leaf(double height, double width, int rows) {
  return patch(4, rows, [&](double u, double v) {
    const double across = 2.0 * u - 1.0;
    const double lobes = 1.0 - 0.18 * std::abs(std::sin(3.5 * pi * v));
    const double half_width = 0.5 * width * lobes * std::pow(std::sin(pi * (0.2 + 0.74 * v)), 0.7);
    const double curl = 2.6 * std::max(0.0, v - 0.55);
    const double rise = std::min(v, 0.55) + 0.38 * std::sin(curl);
    const double out = 0.1 + 0.25 * v * v + 0.42 * (1.0 - std::cos(curl));
    const double relief = 0.16 * (1.0 - std::abs(across)) - 0.08 * across * across;
    return DVec3(across * half_width, height * rise, width * (0.55 * out + relief));
  });
}

/// A scroll that stands out of the capital's corner towards +Z under the slab.
Shape volute(double size) {
  std::vector<DVec3> path;
  constexpr int steps = 12;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const double angle = 0.5 * pi + 3.4 * pi * (1.0 - t);
    const double radius = size * (0.08 + 0.42 * (1.0 - t));
    path.emplace_back(0.0, radius * std::sin(angle), radius * std::cos(angle));
  }
  return scaled(tube(path, 0.13 * size, 5), {1.6, 1.0, 1.0});
}

void add_leaves(Shape& capital, const Shape& leaf, double radius, double foot, double first_deg) {
  constexpr int count = 8;
  for (int i = 0; i < count; ++i) {
    append(capital, turned(moved(leaf, {0.0, foot, radius}), first_deg + 360.0 * i / count));
  }
}

Shape bevelled_slab(double side, double bottom, double height) {
  return moved(rounded_box({side, height, side}, 0.2 * height, 1), {0.0, bottom + 0.5 * height, 0});
}

}  // namespace

Shape carved_column(const CarvedColumn& size) {
  const double r = size.radius;
  const double plinth = 0.75 * r;
  const double slab = 0.55 * r;
  const double bell_height = 2.0 * r;
  const double bell_foot = size.height - slab - bell_height;
  std::vector<DVec2> outline = {{1.36 * r, plinth - 0.05 * r}};
  add_roll(outline, 1.3 * r, 0.18 * r, plinth, 0.5 * r);
  // The hollow between the base's two rolls.
  for (int i = 0; i <= 3; ++i) {
    const double angle = pi * i / 3.0;
    outline.emplace_back((1.2 - 0.1 * std::sin(angle)) * r, plinth + (0.525 + 0.075 * i) * r);
  }
  add_roll(outline, 1.1 * r, 0.12 * r, plinth + 0.775 * r, 0.25 * r);
  constexpr int shaft_steps = 3;
  for (int i = 0; i <= shaft_steps; ++i) {
    const double t = static_cast<double>(i) / shaft_steps;
    outline.emplace_back(r * (1.0 - 0.16 * t * t),
                         std::lerp(plinth + 1.1 * r, bell_foot - 0.3 * r, t));
  }
  add_roll(outline, 0.86 * r, 0.12 * r, bell_foot - 0.275 * r, 0.25 * r);
  constexpr int bell_steps = 4;
  for (int i = 0; i <= bell_steps; ++i) {
    const double t = static_cast<double>(i) / bell_steps;
    const double flare = 1.0 - std::cos(0.5 * pi * t);
    outline.emplace_back(std::lerp(0.84 * r, 0.42 * size.slab, flare), bell_foot + bell_height * t);
  }
  Shape shape = lathe(outline, size.segments);
  append(shape, bevelled_slab(2.95 * r, 0.0, plinth));
  append(shape, bevelled_slab(size.slab, size.height - slab, slab + 0.05 * r));
  add_leaves(shape, acanthus_leaf(0.62 * bell_height, 0.68 * r, size.leaf_rows), 0.86 * r,
             bell_foot, 0.0);
  add_leaves(shape, acanthus_leaf(0.95 * bell_height, 0.66 * r, size.leaf_rows), 0.88 * r,
             bell_foot + 0.04 * bell_height, 22.5);
  const double scroll = 0.85 * r;
  for (int corner = 0; corner < 4; ++corner) {
    append(shape,
           turned(moved(volute(scroll), {0.0, size.height - slab - 0.5 * scroll, 0.54 * size.slab}),
                  45.0 + 90.0 * corner));
  }
  return shape;
}

}  // namespace foveola::scenes
