#include "scenes/modelling/props.h"

#include <cmath>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>

#include "renderer/base/random.h"
#include "scenes/modelling/patterns.h"

namespace foveola::scenes {
namespace {

using std::numbers::pi;

/// Where a stem is at height fraction t: it leans outwards as it rises.
DVec3 stem_point(const PlantSize& size, double angle, double lean, double height, double t) {
  const double out = size.pot_radius * 0.3 + lean * height * t * t;
  return {out * std::sin(angle), size.pot_height * 0.9 + height * t, out * std::cos(angle)};
}

}  // namespace

Shape leaf_blade(double length, double width, double droop, int rows) {
  Shape blade = patch(rows > 2 ? 4 : 2, rows, [&](double u, double v) {
    const double across = u - 0.5;
    const double rise = length * (0.35 * v - droop * v * v);
    const double fold = 0.22 * width * std::abs(across) * (1.0 - 0.6 * v);
    const double wave = 0.03 * width * std::abs(across) * std::sin(14.0 * v + 9.0 * across);
    return DVec3(across * width, rise + fold + wave, length * v);
  });
  for (DVec2& uv : blade.uvs) {
    uv.y = 1.0 - uv.y;
  }
  return inside_out(blade);
}

Shape column(const ColumnSize& size, int segments) {
  const double r = size.radius;
  const double slab_height = 0.12;
  const double foot_height = 0.16;
  const double top = size.height - slab_height;
  std::vector<DVec2> outline = {{1.35 * r, foot_height}};
  const auto add_ring = [&](double middle_radius, double bulge, double from, double height) {
    constexpr int steps = 6;
    for (int i = 0; i <= steps; ++i) {
      const double angle = std::numbers::pi * (static_cast<double>(i) / steps - 0.5);
      outline.emplace_back(middle_radius + bulge * std::cos(angle),
                           from + 0.5 * height * (1.0 + std::sin(angle)));
    }
  };
  add_ring(1.3 * r, 0.18 * r, foot_height, 0.1);
  add_ring(1.1 * r, 0.12 * r, foot_height + 0.13, 0.05);
  const double shaft_from = foot_height + 0.2;
  const double capital_height = 1.3 * r;
  const double shaft_to = top - capital_height - 0.06;
  constexpr int shaft_steps = 8;
  for (int i = 0; i <= shaft_steps; ++i) {
    const double t = static_cast<double>(i) / shaft_steps;
    outline.emplace_back(r * (1.0 - 0.16 * t * t), std::lerp(shaft_from, shaft_to, t));
  }
  add_ring(0.86 * r, 0.1 * r, shaft_to, 0.06);
  constexpr int capital_steps = 6;
  for (int i = 0; i <= capital_steps; ++i) {
    const double t = static_cast<double>(i) / capital_steps;
    const double flare = 1.0 - std::cos(0.5 * std::numbers::pi * t);
    outline.emplace_back(0.84 * r + (0.5 * size.slab * 0.96 - 0.84 * r) * flare,
                         shaft_to + 0.06 + capital_height * t);
  }
  Shape shape = lathe(outline, segments);
  append(shape, moved(box(DVec3(2.9 * r, foot_height, 2.9 * r)), {0.0, 0.5 * foot_height, 0.0}));
  append(shape, moved(box(DVec3(size.slab, slab_height, size.slab)),
                      {0.0, size.height - 0.5 * slab_height, 0.0}));
  return shape;
}

Shape baluster(double height, int segments) {
  const std::vector<DVec2> outline = {{0.06, 0.0},   {0.06, 0.08},  {0.035, 0.14}, {0.05, 0.24},
                                      {0.065, 0.34}, {0.05, 0.46},  {0.03, 0.62},  {0.028, 0.74},
                                      {0.05, 0.82},  {0.035, 0.88}, {0.06, 0.92},  {0.06, 1.0}};
  return scaled(lathe(outline, segments), {1.0, height, 1.0});
}

Shape hanging_cloth(const ClothSize& size, const Seed& seed) {
  Pcg32 random = generator(seed);
  const double phase = 2.0 * pi * random.uniform();
  const double drift = random.uniform() - 0.5;
  const int columns = 10 * size.folds;
  Shape shape = patch(columns, 24, [&](double u, double v) {
    const double fallen = 1.0 - v;
    const double depth = size.fold_depth * (0.35 + 0.65 * fallen);
    const double fold = std::sin(2.0 * pi * size.folds * u + phase + 1.5 * drift * fallen);
    const double sway = 0.3 * std::sin(2.0 * pi * 0.8 * u + 4.0 * fallen + 2.0 * phase);
    const double gathered = 1.0 - 0.06 * fallen * (1.0 - fallen) * 4.0;
    return DVec3((u - 0.5) * size.width * gathered, -size.drop * fallen, depth * (fold + sway));
  });
  for (DVec2& uv : shape.uvs) {
    uv.y = 1.0 - uv.y;
  }
  return shape;
}

PlantMaterials add_plant_materials(Model& model) {
  PlantMaterials materials;
  materials.pot = add_textured_material(
      model, "terracotta", plaster(256, {0.5F, 0.2F, 0.1F}, 0.2, model.stream(1)), 0.8F);
  materials.soil = add_material(model, {.name = "soil", .base_color = {0.06F, 0.04F, 0.025F}});
  materials.stem = add_material(model, {.name = "stem", .base_color = {0.12F, 0.2F, 0.05F}});
  const int leaf_image = add_image(model, leaf(512, {0.1F, 0.28F, 0.05F}, model.stream(2)));
  materials.leaf = add_material(model, {.name = "leaf",
                                        .base_color = Rgb(1.0F),
                                        .roughness = 0.6F,
                                        .base_color_image = leaf_image,
                                        .alpha_cutoff = 0.5F,
                                        .double_sided = true});
  materials.leaflet = add_material(model, {.name = "leaflet",
                                           .base_color = {0.09F, 0.22F, 0.05F},
                                           .roughness = 0.5F,
                                           .double_sided = true});
  return materials;
}

std::vector<Part> pot_with_soil(double r, double h, const PlantMaterials& materials) {
  const Shape pot = lathe({{0.0, 0.0},
                           {0.66 * r, 0.0},
                           {0.7 * r, 0.015 * h},
                           {0.72 * r, 0.05 * h},
                           {0.83 * r, 0.45 * h},
                           {0.95 * r, 0.82 * h},
                           {0.97 * r, 0.84 * h},
                           {1.04 * r, 0.855 * h},
                           {1.06 * r, 0.87 * h},
                           {1.07 * r, 0.96 * h},
                           {1.06 * r, 0.985 * h},
                           {1.03 * r, h},
                           {0.95 * r, h},
                           {0.93 * r, 0.985 * h},
                           {0.9 * r, 0.88 * h}},
                          40);
  const Shape soil = lathe({{0.91 * r, 0.9 * h}, {0.4 * r, 0.93 * h}, {0.0, 0.94 * h}}, 28);
  return {{materials.pot, pot, 35.0}, {materials.soil, soil, 60.0}};
}

std::vector<Part> potted_plant(const PlantSize& size, const PlantMaterials& materials,
                               const Seed& seed) {
  std::vector<Part> parts = pot_with_soil(size.pot_radius, size.pot_height, materials);
  Pcg32 random = generator(seed);
  Shape stems;
  Shape leaves;
  for (int i = 0; i < size.stems; ++i) {
    const double angle = 2.0 * pi * (i + 0.6 * random.uniform()) / size.stems;
    const double lean = 0.15 + 0.45 * random.uniform();
    const double height = size.stem_height * (0.55 + 0.45 * random.uniform());
    std::vector<DVec3> path;
    for (int k = 0; k <= 5; ++k) {
      path.push_back(stem_point(size, angle, lean, height, k / 5.0));
    }
    append(stems, tube(path, 0.008, 6));
    for (int k = 0; k < size.leaves_per_stem; ++k) {
      const double t = 1.0 - 0.75 * k / size.leaves_per_stem;
      const double length = size.leaf_length * (0.7 + 0.5 * random.uniform());
      const double droop = 0.3 + 0.6 * random.uniform();
      const double turn_deg = 137.5 * k + 360.0 * random.uniform();
      const Shape blade = turned(leaf_blade(length, 0.75 * length, droop, 6), turn_deg);
      append(leaves, moved(blade, stem_point(size, angle, lean, height, t)));
    }
  }
  parts.push_back({materials.stem, stems, 60.0});
  parts.push_back({materials.leaf, leaves, 80.0});
  return parts;
}

std::vector<Part> moved(std::vector<Part> parts, const DVec3& offset) {
  for (Part& part : parts) {
    part.shape = moved(std::move(part.shape), offset);
  }
  return parts;
}

}  // namespace foveola::scenes
