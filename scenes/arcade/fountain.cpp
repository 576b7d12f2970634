// What stands in the court: the fountain, the urn, a sundial, a bench.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenes/arcade/parts.h"

namespace foveola::scenes::arcade {
namespace {

using std::numbers::pi;
constexpr DVec3 fountain_place(0.8, court_floor, 0.0);
constexpr int jets = 8;
constexpr double jet_landing = 0.74;  ///< distance of the jets' feet from the fountain's middle
constexpr double basin_water = 0.47;
constexpr double bowl_water = 1.245;

/// A lathe whose outline is bulged into `lobes` around the axis between two heights.
Shape lobed(const Shape& shape, int lobes, double depth, double bottom, double top) {
  return deformed(shape, [=](const DVec3& p) {
    const double t = glm::clamp((p.y - bottom) / (top - bottom), 0.0, 1.0);
    const double wave = std::abs(std::cos(0.5 * lobes * std::atan2(p.x, p.z)));
    const double factor = 1.0 - depth * std::sin(pi * t) * (1.0 - wave);
    return DVec3(p.x * factor, p.y, p.z * factor);
  });
}

Shape basin() {
  std::vector<DVec2> outline = {{1.2, -0.02}, {1.2, 0.07}, {1.17, 0.1}, {1.1, 0.115}};
  // A belly between foot and rim, then the rim's roll and its way down inside.
  for (int i = 0; i <= 7; ++i) {
    const double t = i / 7.0;
    outline.emplace_back(1.0 + 0.085 * std::sin(pi * t) - 0.02 * t, 0.13 + 0.29 * t);
  }
  for (int i = 0; i <= 8; ++i) {
    const double angle = pi * (i / 8.0 - 0.5);
    outline.emplace_back(1.0 + 0.09 * std::cos(angle), 0.49 + 0.06 * std::sin(angle));
  }
  outline.insert(outline.end(), {{0.93, 0.548}, {0.915, 0.53}, {0.9, 0.2}});
  return lobed(lathe(outline, 96), 32, 0.035, 0.13, 0.42);
}

Shape bowl_on_stem() {
  std::vector<DVec2> outline = {{0.24, 0.15}, {0.24, 0.3},  {0.2, 0.34},  {0.13, 0.4},
                                {0.105, 0.5}, {0.12, 0.62}, {0.15, 0.7},  {0.14, 0.78},
                                {0.1, 0.86},  {0.105, 0.9}, {0.16, 0.92}, {0.16, 0.95}};
  for (int i = 1; i <= 12; ++i) {
    const double angle = 0.5 * pi * i / 12.0;
    outline.emplace_back(0.14 + 0.42 * std::sin(angle), 1.27 - 0.31 * std::cos(angle));
  }
  for (int i = 1; i <= 6; ++i) {
    const double angle = pi * i / 6.0;
    outline.emplace_back(0.535 + 0.025 * std::cos(angle), 1.27 + 0.02 * std::sin(angle));
  }
  for (int i = 1; i <= 8; ++i) {
    const double angle = 0.5 * pi * (1.0 - i / 8.0);
    outline.emplace_back(0.1 + 0.41 * std::sin(angle), 1.26 - 0.22 * std::cos(angle));
  }
  return lobed(lathe(outline, 64), 16, 0.09, 0.95, 1.27);
}

/// A pine cone of bronze on a turned foot.
Shape finial() {
  std::vector<DVec2> outline = {{0.1, 1.03},   {0.09, 1.1},   {0.05, 1.16},
                                {0.045, 1.24}, {0.085, 1.29}, {0.09, 1.31}};
  for (int i = 1; i <= 24; ++i) {
    const double t = i / 24.0;
    outline.emplace_back(0.105 * std::pow(std::sin(pi * (0.32 + 0.68 * t)), 0.8), 1.31 + 0.28 * t);
  }
  return deformed(lathe(outline, 48), [](const DVec3& p) {
    const double turn = std::atan2(p.x, p.z);
    const double t = std::max(0.0, p.y - 1.32) / 0.27;
    const double scales = std::sin(8.0 * turn + 22.0 * t) * std::sin(8.0 * turn - 22.0 * t);
    const double factor = 1.0 + 0.13 * std::min(1.0, 6.0 * t) * scales;
    return DVec3(p.x * factor, p.y, p.z * factor);
  });
}

DVec2 jet_direction(int i) {
  const double angle = 2.0 * pi * (i + 0.5) / jets;
  return {std::sin(angle), std::cos(angle)};
}

/// A disc of water with rings around the points where jets fall into it.
Shape water_surface() {
  std::vector<DVec2> outline;
  constexpr int rings = 26;
  for (int i = 0; i <= rings; ++i) {
    outline.emplace_back(0.922 * (1.0 - static_cast<double>(i) / rings), basin_water);
  }
  return deformed(lathe(outline, 80), [](const DVec3& p) {
    double height = 0.0;
    for (int i = 0; i < jets; ++i) {
      const double distance = glm::distance(DVec2(p.x, p.z), jet_landing * jet_direction(i));
      height += 0.005 * std::exp(-6.0 * distance) * std::cos(70.0 * distance);
    }
    return DVec3(p.x, p.y + height, p.z);
  });
}

/// The water that falls from the bowl's rim: `jets` strands that thin out as they fall.
Shape falling_water() {
  Shape all;
  for (int i = 0; i < jets; ++i) {
    const DVec2 direction = jet_direction(i);
    std::vector<DVec3> path;
    for (int k = 0; k <= 14; ++k) {
      const double t = k / 14.0;
      const double out = 0.5 + (jet_landing - 0.5) * t;
      const double height = bowl_water + 0.035 * std::sin(pi * std::min(1.0, 5.0 * t)) * (1.0 - t) -
                            (bowl_water - basin_water + 0.01) * t * t;
      const double wobble = 0.004 * std::sin(19.0 * t + i);
      path.emplace_back(out * direction.x + wobble * direction.y, height,
                        out * direction.y - wobble * direction.x);
    }
    append(all, tube(path, 0.009, 7));
  }
  return all;
}

}  // namespace

void add_fountain(Model& model, const Materials& m) {
  const Shape lining = lathe({{0.92, 0.22}, {0.0, 0.22}}, 64);
  const Shape tiles = with_projected_uvs(lining, {0.8, 0, 0}, {0, 0, 0.8});
  const Shape upper_water = lathe({{0.53, bowl_water}, {0.05, bowl_water + 0.004}}, 64);
  add_object(model, "Fountain",
             moved({{m.limestone, with_uv_scale(basin(), 1.0), 45.0},
                    {m.limestone, bowl_on_stem(), 45.0},
                    {m.bronze, finial(), 60.0},
                    {m.basin_tiles, tiles},
                    {m.water, water_surface(), 60.0},
                    {m.water, upper_water, 60.0},
                    {m.falling_water, falling_water(), 60.0}},
                   fountain_place));
}

void add_urn(Model& model, const Materials& m) {
  std::vector<DVec2> outline = {{0.0, 0.0},     {0.2, 0.0},  {0.225, 0.012},
                                {0.225, 0.045}, {0.2, 0.06}, {0.15, 0.075}};
  constexpr int steps = 20;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    outline.emplace_back(0.15 + 0.25 * std::sin(pi * std::pow(t, 0.8)), 0.085 + 0.715 * t);
  }
  outline.insert(outline.end(), {{0.145, 0.84},
                                 {0.16, 0.88},
                                 {0.215, 0.92},
                                 {0.24, 0.935},
                                 {0.245, 0.955},
                                 {0.23, 0.968},
                                 {0.19, 0.965},
                                 {0.14, 0.9},
                                 {0.12, 0.8},
                                 {0.0, 0.7}});
  Shape urn = lobed(lathe(outline, 48), 16, 0.07, 0.09, 0.45);
  // Bands turned into the clay.
  for (const DVec2& band : {DVec2(0.398, 0.5), DVec2(0.378, 0.585), DVec2(0.36, 0.62)}) {
    append(urn, moved(torus(band.x, 0.01, 48, 6), {0.0, band.y, 0.0}));
  }
  for (const double side : {-1.0, 1.0}) {
    std::vector<DVec3> handle;
    for (int i = 0; i <= 16; ++i) {
      const double angle = pi * (i / 16.0 - 0.5);
      handle.emplace_back(side * (0.2 + 0.2 * std::cos(angle)), 0.74 + 0.16 * std::sin(angle), 0.0);
    }
    append(urn, tube(handle, 0.025, 10));
  }
  const DVec3 place(-1.0, court_floor, -2.8);
  Shape plinth = moved(rounded_box({0.6, 0.34, 0.6}, 0.01, 2), {0.0, 0.25, 0.0});
  append(plinth, moved(rounded_box({0.72, 0.14, 0.72}, 0.03, 3), {0.0, 0.05, 0.0}));
  append(plinth, moved(rounded_box({0.7, 0.1, 0.7}, 0.03, 3), {0.0, 0.45, 0.0}));
  add_object(model, "Plinth", moved({{m.limestone, with_uv_scale(plinth, 0.7)}}, place));
  add_object(model, "Urn", moved({{m.plant.pot, urn, 45.0}}, place + DVec3(0.0, 0.5, 0.0)));
}

void add_sundial(Model& model, const Materials& m) {
  std::vector<DVec2> outline = {{0.2, 0.08}, {0.2, 0.14}, {0.17, 0.17}, {0.13, 0.19}};
  for (int i = 0; i <= 16; ++i) {
    const double t = i / 16.0;
    outline.emplace_back(0.1 + 0.045 * std::sin(pi * std::pow(1.0 - t, 1.6)), 0.2 + 0.62 * t);
  }
  outline.insert(outline.end(), {{0.13, 0.84}, {0.18, 0.88}, {0.2, 0.9}, {0.2, 0.92}});
  Shape pedestal = lathe(outline, 40);
  append(pedestal, moved(rounded_box({0.52, 0.1, 0.52}, 0.015, 2), {0.0, 0.04, 0.0}));
  append(pedestal, moved(rounded_box({0.46, 0.07, 0.46}, 0.02, 3), {0.0, 0.945, 0.0}));
  Shape dial = moved(lathe({{0.19, 0.0}, {0.19, 0.012}, {0.18, 0.018}, {0.0, 0.018}}, 48),
                     {0.0, 0.975, 0.0});
  for (int hour = 0; hour < 12; ++hour) {
    const double length = hour % 3 == 0 ? 0.05 : 0.03;
    const Shape mark = moved(box(DVec3(0.006, 0.006, length)), {0.0, 0.994, 0.16 - 0.5 * length});
    append(dial, turned(mark, 30.0 * hour));
  }
  append(dial, moved(torus(0.172, 0.004, 48, 8), {0.0, 0.993, 0.0}));
  // The gnomon is a thin triangle that rises towards the back.
  const DVec3 foot(0.0, 0.992, 0.11);
  const DVec3 heel(0.0, 0.992, -0.1);
  const DVec3 tip(0.0, 1.15, -0.1);
  append(dial, tube({foot, tip, heel, foot}, 0.006, 8));
  Shape plate;
  plate.positions = {foot, heel, tip};
  plate.uvs.assign(3, DVec2(0.0));
  plate.triangles = {{0, 1, 2}};
  const Shape far_side = inside_out(plate);
  append(dial, moved(plate, {-0.003, 0.0, 0.0}));
  append(dial, moved(far_side, {0.003, 0.0, 0.0}));
  const DVec3 place(4.5, court_floor, 2.0);
  add_object(
      model, "Sundial",
      moved({{m.limestone, with_uv_scale(pedestal, 0.7), 45.0}, {m.bronze, dial, 40.0}}, place));
}

void add_benches(Model& model, const Materials& m) {
  Shape bench = moved(rounded_box({1.5, 0.08, 0.42}, 0.025, 2), {0.0, 0.44, 0.0});
  for (const double side : {-1.0, 1.0}) {
    append(bench, moved(deformed(rounded_box({0.14, 0.42, 0.34}, 0.02, 1, 6),
                                 [](const DVec3& p) {
                                   const double waist = 1.0 - 0.25 * std::cos(pi * p.y / 0.42);
                                   return DVec3(p.x, p.y, p.z * waist);
                                 }),
                        {side * 0.55, 0.205, 0.0}));
  }
  const Shape one = with_uv_scale(bench, 0.7);
  add_object(model, "Bench", {{m.limestone, moved(turned(one, 90.0), {-7.6, court_floor, 0.0})}});
  add_object(model, "Shaded bench", {{m.limestone, moved(one, {6.0, court_floor, -3.55})}});
}

}  // namespace foveola::scenes::arcade
