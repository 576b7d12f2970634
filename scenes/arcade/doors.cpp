// Doors in the walks' walls, and lanterns under the vaults.
#include <cmath>
#include <numbers>

#include "scenes/arcade/parts.h"

namespace foveola::scenes::arcade {
namespace {

using std::numbers::pi;

/// A raised panel of a door, its back in the plane z = 0 about the origin.
Shape raised_panel(double width, double height) {
  constexpr double bevel = 0.05;
  constexpr double thickness = 0.022;
  const DVec2 half(0.5 * width, 0.5 * height);
  const DVec2 inner = half - DVec2(bevel);
  Shape panel =
      rectangle({-inner.x, -inner.y, thickness}, {2.0 * inner.x, 0, 0}, {0, 2.0 * inner.y, 0});
  const auto side = [&](const DVec2& outer_a, const DVec2& outer_b, const DVec2& inner_a,
                        const DVec2& inner_b) {
    append(panel, patch(1, 1, [&](double u, double v) {
             const DVec2 p =
                 glm::mix(glm::mix(outer_a, outer_b, u), glm::mix(inner_a, inner_b, u), v);
             return DVec3(p, thickness * v);
           }));
  };
  const auto corner = [](const DVec2& size, double x, double y) {
    return DVec2(x * size.x, y * size.y);
  };
  side(corner(half, -1, -1), corner(half, 1, -1), corner(inner, -1, -1), corner(inner, 1, -1));
  side(corner(half, 1, -1), corner(half, 1, 1), corner(inner, 1, -1), corner(inner, 1, 1));
  side(corner(half, 1, 1), corner(half, -1, 1), corner(inner, 1, 1), corner(inner, -1, 1));
  side(corner(half, -1, 1), corner(half, -1, -1), corner(inner, -1, 1), corner(inner, -1, -1));
  return panel;
}

struct Door {
  Shape leaves;
  Shape frame;
  Shape fittings;
};

/// A door of two leaves with four panels each, in a moulded stone frame, its back at z = 0.
Door make_door() {
  constexpr double height = 2.2;
  constexpr double leaf_width = 0.55;
  constexpr double face = 0.05;
  Door door;
  for (const double side : {-1.0, 1.0}) {
    const double middle = 0.5 * side * leaf_width;
    append(door.leaves, moved(box(DVec3(leaf_width - 0.006, height, 0.06)),
                              {middle, 0.5 * height, face - 0.03}));
    double foot = 0.12;
    for (const double panel_height : {0.5, 0.34, 0.62, 0.38}) {
      append(door.leaves,
             moved(raised_panel(0.4, panel_height), {middle, foot + 0.5 * panel_height, face}));
      foot += panel_height + 0.06;
    }
    append(door.fittings, moved(turned(torus(0.055, 0.009, 14, 5), 90.0, {1, 0, 0}),
                                {side * 0.07, 1.0, face + 0.02}));
    append(door.fittings,
           moved(ellipsoid({0.025, 0.025, 0.02}, 8), {side * 0.07, 1.055, face + 0.012}));
    for (const double y : {0.35, 1.05, 1.85}) {
      append(door.fittings,
             moved(box(DVec3(0.3, 0.035, 0.014)), {side * (leaf_width - 0.15), y, face + 0.004}));
    }
    append(door.frame, moved(rounded_box({0.16, height + 0.01, 0.16}, 0.025, 1),
                             {side * (leaf_width + 0.08), 0.5 * height, 0.05}));
  }
  append(door.frame, moved(rounded_box({2.0 * leaf_width + 0.36, 0.18, 0.18}, 0.025, 1),
                           {0.0, height + 0.09, 0.05}));
  append(door.frame, moved(rounded_box({2.0 * leaf_width + 0.52, 0.07, 0.3}, 0.02, 1),
                           {0.0, height + 0.21, 0.08}));
  append(door.frame, moved(box(DVec3(1.5, 0.05, 0.36)), {0.0, 0.0, 0.1}));
  return door;
}

/// A six-sided lantern that hangs from its chain's upper end at the origin.
struct Lantern {
  Shape iron;
  Shape panes;
  Shape candle;
};

Lantern make_lantern(double chain_length) {
  Lantern lantern;
  constexpr double half_height = 0.17;
  constexpr double top_radius = 0.13;
  constexpr double foot_radius = 0.09;
  const double top = -chain_length;
  const double foot = top - 2.0 * half_height;
  const auto corner = [&](int i, double y, double radius) {
    const double angle = pi / 3.0 * i;
    return DVec3(radius * std::sin(angle), y, radius * std::cos(angle));
  };
  for (int i = 0; i < 6; ++i) {
    append(lantern.iron,
           tube({corner(i, foot, foot_radius), corner(i, top, top_radius)}, 0.006, 4));
    const DVec3 a = corner(i, foot, foot_radius);
    const DVec3 b = corner(i + 1, foot, foot_radius);
    const DVec3 c = corner(i, top, top_radius);
    const DVec3 d = corner(i + 1, top, top_radius);
    append(lantern.panes, patch(1, 1, [&](double u, double v) {
             return glm::mix(glm::mix(a, b, u), glm::mix(c, d, u), v);
           }));
  }
  append(lantern.iron,
         moved(cone(foot_radius + 0.012, foot_radius, 0.02, 6), {0.0, foot - 0.015, 0.0}));
  append(lantern.iron, moved(cone(top_radius + 0.03, 0.035, 0.1, 6), {0.0, top, 0.0}));
  append(lantern.iron, moved(ellipsoid({0.03, 0.025, 0.03}, 8), {0.0, top + 0.11, 0.0}));
  append(lantern.iron, moved(ellipsoid({0.02, 0.035, 0.02}, 8), {0.0, foot - 0.03, 0.0}));
  constexpr double link = 0.085;
  const int links = static_cast<int>((chain_length - 0.13) / link);
  for (int i = 0; i < links; ++i) {
    const Shape ring = scaled(turned(torus(0.018, 0.004, 7, 4), 90.0, {1, 0, 0}), {1.0, 2.7, 1.0});
    append(lantern.iron, moved(turned(ring, 90.0 * (i % 2)), {0.0, -link * (i + 0.5), 0.0}));
  }
  lantern.candle = moved(cylinder(0.022, 0.16, 14), {0.0, foot + 0.004, 0.0});
  return lantern;
}

}  // namespace

void add_doors(Model& model, const Materials& m) {
  const Door door = make_door();
  const auto below = [](const Shape& one) {
    return in_each_bay(moved(one, {0.0, 0.0, -walk_depth}));
  };
  const auto on_both_floors = [&](const Shape& one) {
    Shape both = below(one);
    append(both, moved(below(one), {0.0, upper_walk, 0.0}));
    return both;
  };
  add_object(model, "Doors",
             {{m.old_wood, on_both_floors(door.leaves), 20.0},
              {m.limestone, with_uv_scale(on_both_floors(door.frame), 0.5)},
              {m.iron, below(door.fittings)}});
}

void add_lanterns(Model& model, const Materials& m) {
  constexpr double crown = 4.36;
  const Lantern lantern = make_lantern(0.95);
  const auto everywhere = [](const Shape& one) {
    return in_each_bay(moved(one, {0.0, crown, -0.5 * (walk_depth + 0.25)}));
  };
  add_object(model, "Lanterns",
             {{m.iron, everywhere(lantern.iron)},
              {m.lantern_glass, everywhere(lantern.panes), 10.0},
              {m.candle, everywhere(lantern.candle)}});
}

}  // namespace foveola::scenes::arcade
