// The meeting room's floor, walls, ceiling, windows and door.
#include <algorithm>
#include <cmath>

#include "scenes/meeting_room/parts.h"

namespace foveola::scenes::meeting {
namespace {

constexpr double tile = 0.6;
constexpr double lamp_half_x = tile;
constexpr double lamp_half_z = 0.5 * tile;

std::vector<DVec2> lamp_places() {
  std::vector<DVec2> places;
  for (int row = -1; row <= 1; ++row) {
    for (int i = 0; i < 6; ++i) {
      places.emplace_back(1.8 * (i - 2.5), 2.4 * row);
    }
  }
  return places;
}

const std::vector<DVec2>& grille_places() {
  static const std::vector<DVec2> places = {{-3.6, -1.2}, {-3.6, 1.2}, {3.6, -1.2}, {3.6, 1.2}};
  return places;
}

/// The lines of the ceiling's grid from -half to half, which pass through `first` + n tiles.
std::vector<double> grid_lines(double half, double first) {
  std::vector<double> lines = {-half};
  for (double line = first; line < half - 1e-6; line += tile) {
    lines.push_back(line);
  }
  lines.push_back(half);
  return lines;
}

/// The four inner sides of a recess above the ceiling, seen from inside it.
Shape recess_sides(const DVec2& half, double depth) {
  Shape sides = rectangle({-half.x, 0, half.y}, {2.0 * half.x, 0, 0}, {0, depth, 0});
  append(sides, rectangle({half.x, 0, -half.y}, {-2.0 * half.x, 0, 0}, {0, depth, 0}));
  append(sides, rectangle({half.x, 0, half.y}, {0, 0, -2.0 * half.y}, {0, depth, 0}));
  append(sides, rectangle({-half.x, 0, -half.y}, {0, 0, 2.0 * half.y}, {0, depth, 0}));
  return inside_out(sides);
}

Shape facing_down(const DVec2& half, double height) {
  return rectangle({-half.x, height, -half.y}, {2.0 * half.x, 0, 0}, {0, 0, 2.0 * half.y});
}

/// One square blade of an air diffuser of the given half side.
Shape diffuser_blade(double half) {
  const double r = half * std::sqrt(2.0);
  return turned(
      lathe({{r, -0.012}, {r + 0.06, 0.02}, {r + 0.054, 0.024}, {r - 0.005, -0.008}, {r, -0.012}},
            4),
      45.0);
}

}  // namespace

void add_shell(Model& model, const Materials& m) {
  const DVec3 x(2.0 * half_x, 0.0, 0.0);
  const DVec3 y(0.0, ceiling, 0.0);
  const DVec3 z(0.0, 0.0, 2.0 * half_z);
  const DVec3 corner(-half_x, 0.0, -half_z);
  add_object(model, "Floor", {{m.floor, with_uv_scale(rectangle(corner + z, x, -z), 0.5)}});
  Shape walls = rectangle(corner, x, y);
  append(walls, rectangle(corner + x + z, -x, y));
  append(walls, rectangle(corner + z, -z, y));
  add_object(model, "Walls", {{m.wall, with_uv_scale(walls, 0.4)}});
  add_object(model, "End wall", {{m.accent_wall, with_uv_scale(rectangle(corner + x, z, y), 0.4)}});
  // A board with a rounded upper edge, along each wall.
  Shape skirting;
  for (const double side : {-1.0, 1.0}) {
    append(skirting, moved(rounded_box({2.0 * half_x + 0.04, 0.14, 0.036}, 0.012, 3),
                           {0.0, 0.03, side * half_z}));
    append(skirting, moved(rounded_box({0.036, 0.14, 2.0 * half_z + 0.04}, 0.012, 3),
                           {side * half_x, 0.0295, 0.0}));
  }
  add_object(model, "Skirting", {{m.dark_wood, skirting}});
}

void add_ceiling(Model& model, const Materials& m) {
  const std::vector<double> xs = grid_lines(half_x, -half_x + 0.5 * tile);
  const std::vector<double> zs = grid_lines(half_z, -3.3);
  const std::vector<DVec2> lamps = lamp_places();
  const auto is_open = [&](const DVec2& p) {
    const auto within = [&](const DVec2& middle, double x, double z) {
      return std::abs(p.x - middle.x) < x && std::abs(p.y - middle.y) < z;
    };
    return std::any_of(
               lamps.begin(), lamps.end(),
               [&](const DVec2& place) { return within(place, lamp_half_x, lamp_half_z); }) ||
           std::any_of(grille_places().begin(), grille_places().end(),
                       [&](const DVec2& place) { return within(place, 0.5 * tile, 0.5 * tile); });
  };
  Shape tiles;
  for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
    for (std::size_t j = 0; j + 1 < zs.size(); ++j) {
      if (!is_open({0.5 * (xs[i] + xs[i + 1]), 0.5 * (zs[j] + zs[j + 1])})) {
        append(tiles, rectangle({xs[i], ceiling, zs[j]}, {xs[i + 1] - xs[i], 0, 0},
                                {0, 0, zs[j + 1] - zs[j]}));
      }
    }
  }
  // Bars carry the tiles; those along x lie a little lower. Lamps span two tiles, without a bar.
  Shape bars;
  for (std::size_t i = 1; i + 1 < xs.size(); ++i) {
    for (std::size_t j = 0; j + 1 < zs.size(); ++j) {
      const bool in_lamp = std::any_of(lamps.begin(), lamps.end(), [&](const DVec2& place) {
        return std::abs(place.x - xs[i]) < 0.1 &&
               std::abs(place.y - 0.5 * (zs[j] + zs[j + 1])) < 0.1;
      });
      if (!in_lamp) {
        append(bars, box({xs[i] - 0.012, ceiling - 0.006, zs[j]},
                         {xs[i] + 0.012, ceiling + 0.002, zs[j + 1]}));
      }
    }
  }
  for (std::size_t j = 1; j + 1 < zs.size(); ++j) {
    append(bars, box({-half_x, ceiling - 0.008, zs[j] - 0.012},
                     {half_x, ceiling + 0.002, zs[j] + 0.012}));
  }
  add_object(model, "Ceiling",
             {{m.ceiling, with_uv_scale(tiles, 1.0 / 1.2)}, {m.white_plastic, bars}});
  Shape glow;
  Shape reflectors;
  for (const DVec2& place : lamps) {
    const DVec3 middle(place.x, ceiling, place.y);
    append(glow, moved(facing_down({lamp_half_x, lamp_half_z}, 0.06), middle));
    append(reflectors, moved(recess_sides({lamp_half_x, lamp_half_z}, 0.06), middle));
    for (int i = -3; i <= 3; ++i) {
      append(reflectors, moved(box(DVec3(0.004, 0.03, 2.0 * lamp_half_z)),
                               middle + DVec3(0.15 * i, 0.02, 0.0)));
    }
    append(reflectors,
           moved(box(DVec3(2.0 * lamp_half_x, 0.034, 0.012)), middle + DVec3(0.0, 0.02, 0.0)));
  }
  add_object(model, "Ceiling lamps", {{m.lamp, glow}, {m.white_plastic, reflectors}});
  Shape blades;
  Shape ducts;
  for (const DVec2& place : grille_places()) {
    const DVec3 middle(place.x, ceiling, place.y);
    for (const double half : {0.04, 0.1, 0.16, 0.22}) {
      append(blades, moved(diffuser_blade(half), middle));
    }
    const DVec2 half(0.5 * tile);
    append(ducts, moved(facing_down(half, 0.08), middle));
    append(ducts, moved(recess_sides(half, 0.08), middle));
  }
  add_object(model, "Air grilles", {{m.white_plastic, blades, 20.0}, {m.grey_plastic, ducts}});
  Shape detectors;
  for (const double x : {-1.8, 1.8}) {
    const Shape detector = lathe({{0.0, -0.05},
                                  {0.03, -0.048},
                                  {0.045, -0.035},
                                  {0.045, -0.025},
                                  {0.06, -0.02},
                                  {0.06, 0.0}},
                                 28);
    append(detectors, moved(detector, {x, ceiling, 1.2}));
    append(detectors, moved(detector, {x, ceiling, -1.2}));
  }
  add_object(model, "Smoke detectors", {{m.white_plastic, detectors, 30.0}});
}

namespace {

constexpr double window_half_width = 1.1;
constexpr double window_sill = 0.9;
constexpr double window_height = 1.6;

/// A curved slat of a blind, along X about the origin.
Shape slat() {
  return patch(1, 4, [](double u, double v) {
    const double across = v - 0.5;
    return DVec3((u - 0.5) * (2.0 * window_half_width - 0.04), 0.03 * (0.25 - across * across),
                 -0.05 * across);
  });
}

/// What is seen of the town, as flat pieces just before the sky: u, height and tone.
void add_skyline(Shape& far_houses, Shape& near_houses, int window, const DVec3& middle) {
  for (int i = 0; i < 9; ++i) {
    const double height = 0.42 + 0.34 * std::abs(std::sin(2.1 * i + 3.7 * window));
    const double x = -window_half_width + 0.25 * i;
    const double end = std::min(x + 0.25, window_half_width);
    Shape& houses = i % 2 == 0 ? far_houses : near_houses;
    const double z = half_z - (i % 2 == 0 ? 0.022 : 0.024);
    if (end - x > 0.01) {
      append(houses, moved(rectangle({end, 0.0, z}, {x - end, 0, 0}, {0, height, 0}), middle));
    }
  }
}

}  // namespace

void add_windows(Model& model, const Materials& m) {
  constexpr int windows = 4;
  Shape panes;
  Shape frames;
  Shape slats;
  Shape cords;
  Shape far_houses;
  Shape near_houses;
  for (int i = 0; i < windows; ++i) {
    const DVec3 middle(2.8 * (i - 0.5 * (windows - 1)), window_sill, 0.0);
    append(panes, moved(rectangle({window_half_width, 0.0, half_z - 0.02},
                                  {-2.0 * window_half_width, 0, 0}, {0, window_height, 0}),
                        middle));
    add_skyline(far_houses, near_houses, i, middle);
    const auto add_frame = [&](const DVec3& size, const DVec3& place) {
      append(frames, moved(rounded_box(size, 0.008, 2), middle + place));
    };
    for (const double side : {-1.0, 0.0, 1.0}) {
      add_frame({0.06, window_height, 0.07},
                {side * window_half_width, 0.5 * window_height, half_z - 0.03});
    }
    add_frame({2.0 * window_half_width + 0.06, 0.06, 0.064}, {0.0, 0.04, half_z - 0.03});
    add_frame({2.0 * window_half_width + 0.34, 0.035, 0.24}, {0.0, -0.005, half_z - 0.1});
    add_frame({2.0 * window_half_width + 0.1, 0.09, 0.12}, {0.0, window_height, half_z - 0.05});
    for (const double side : {-1.0, 1.0}) {
      add_frame({0.022, 0.13, 0.03}, {side * 0.06, 0.75, half_z - 0.08});
    }
    // Every second blind is half drawn up.
    const bool is_raised = i % 2 == 1;
    const double lowest = is_raised ? 0.95 : 0.1;
    constexpr double spacing = 0.05;
    for (double y = window_height - 0.1; y > lowest; y -= spacing) {
      append(slats, moved(turned(slat(), 38.0, {1, 0, 0}), middle + DVec3(0.0, y, half_z - 0.11)));
    }
    if (is_raised) {
      for (int k = 0; k < 14; ++k) {
        append(slats, moved(slat(), middle + DVec3(0.0, lowest - 0.008 * k, half_z - 0.11)));
      }
    }
    const double foot = is_raised ? lowest - 0.13 : lowest - 0.02;
    add_frame({2.0 * window_half_width - 0.04, 0.02, 0.05}, {0.0, foot, half_z - 0.11});
    for (const double x : {-0.8, 0.0, 0.8}) {
      for (const double z : {-0.135, -0.085}) {
        append(cords, moved(tube({{x, foot, half_z + z}, {x, window_height - 0.02, half_z + z}},
                                 0.0015, 4),
                            middle));
      }
    }
    append(cords,
           moved(tube({{1.0, 0.3, half_z - 0.15}, {1.0, window_height - 0.03, half_z - 0.14}},
                      0.003, 5),
                 middle));
    append(cords, moved(cone(0.012, 0.005, 0.05, 10), middle + DVec3(1.0, 0.26, half_z - 0.15)));
  }
  add_object(model, "Windows",
             {{m.daylight, panes},
              {m.white_plastic, frames},
              {m.far_building, far_houses},
              {m.near_building, near_houses}});
  add_object(model, "Blinds", {{m.blind, slats, 70.0}, {m.white_plastic, cords}});
}

void add_door(Model& model, const Materials& m) {
  const DVec3 place(-half_x, 0.0, -1.9);
  Shape leaf = moved(rounded_box({0.06, 2.1, 1.0}, 0.004, 1), {0.02, 1.055, 0.0});
  Shape frame;
  for (const double side : {-1.0, 1.0}) {
    append(frame, moved(rounded_box({0.16, 2.18, 0.1}, 0.008, 2), {0.01, 1.09, side * 0.555}));
  }
  append(frame, moved(rounded_box({0.158, 0.1, 1.21}, 0.008, 2), {0.01, 2.16, 0.0}));
  Shape metal;
  append(metal, moved(rounded_box({0.012, 0.2, 0.05}, 0.005, 2), {0.053, 1.02, 0.42}));
  append(metal, tube({{0.05, 1.06, 0.42},
                      {0.1, 1.06, 0.42},
                      {0.112, 1.06, 0.41},
                      {0.114, 1.06, 0.39},
                      {0.112, 1.06, 0.29}},
                     0.011, 14));
  append(metal, moved(turned(cylinder(0.012, 0.008, 16), -90.0, {0, 0, 1}), {0.056, 0.965, 0.42}));
  for (const double y : {0.3, 1.05, 1.8}) {
    append(metal, moved(cylinder(0.009, 0.1, 12), {0.056, y, -0.495}));
  }
  append(metal, moved(rounded_box({0.006, 0.25, 0.9}, 0.002, 1), {0.051, 0.18, 0.0}));
  // A closer above, and the switches beside.
  append(metal, moved(rounded_box({0.05, 0.06, 0.24}, 0.01, 2), {0.07, 2.03, -0.2}));
  append(metal, tube({{0.09, 2.06, -0.15}, {0.1, 2.09, 0.05}, {0.09, 2.15, 0.25}}, 0.007, 8));
  Shape switches;
  for (const double z : {0.76, 0.85}) {
    append(switches, moved(rounded_box({0.016, 0.082, 0.082}, 0.005, 2), {0.006, 1.1, z}));
    append(switches, moved(turned(rounded_box({0.012, 0.056, 0.056}, 0.004, 1), 4.0, {0, 0, 1}),
                           {0.013, 1.1, z}));
  }
  add_object(model, "Door",
             moved({{m.dark_wood, leaf},
                    {m.white_plastic, frame},
                    {m.chrome, metal, 50.0},
                    {m.white_plastic, switches}},
                   place));
}

}  // namespace foveola::scenes::meeting
