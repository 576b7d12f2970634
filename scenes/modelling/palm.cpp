#include "scenes/modelling/palm.h"

#include <cmath>
#include <numbers>

#include "renderer/base/angles.h"
#include "renderer/base/random.h"

namespace foveola::scenes {
namespace {

using std::numbers::pi;

/// Where a frond that starts at the origin and arches towards +Z is at t in [0, 1].
DVec3 on_frond(double length, double upright, double t) {
  return {0.0, length * (upright * t - 0.75 * upright * t * t * t), length * (0.15 + 0.75 * t) * t};
}

/// A pointed leaflet from the origin along +X, folded along its middle and drooping.
Shape leaflet_blade(double length, double width) {
  return patch(3, 2, [&](double u, double v) {
    const double half = 0.5 * width * std::pow(std::sin(std::numbers::pi * (0.12 + 0.86 * u)), 0.7);
    const double across = 2.0 * v - 1.0;
    return DVec3(length * u, -0.25 * length * u * u + 0.4 * half * std::abs(across),
                 -half * across);
  });
}

Shape frond_leaflets(const PalmSize& size, double length, double upright) {
  Shape all;
  for (int i = 0; i < size.leaflets; ++i) {
    const double t = 0.18 + 0.8 * i / (size.leaflets - 1.0);
    const double shape = std::sin(std::numbers::pi * (0.12 + 0.8 * (t - 0.18) / 0.82));
    const Shape blade = leaflet_blade(0.36 * length * shape + 0.03, 0.026 + 0.012 * shape);
    for (const double side : {-1.0, 1.0}) {
      const double sweep_deg = side > 0.0 ? -50.0 : -130.0;
      const Shape swept_blade = turned(turned(blade, 14.0, {0, 0, 1}), sweep_deg);
      append(all, moved(swept_blade, on_frond(length, upright, t)));
    }
  }
  return all;
}

}  // namespace

std::vector<Part> potted_palm(const PalmSize& size, const PlantMaterials& materials,
                              const Seed& seed) {
  std::vector<Part> parts = pot_with_soil(size.pot_radius, size.pot_height, materials);
  Pcg32 random = generator(seed);
  Shape stems;
  Shape leaflets;
  const double foot = 0.92 * size.pot_height;
  for (int i = 0; i < size.fronds; ++i) {
    const double turn_deg = 360.0 * (i + 0.5 * random.uniform()) / size.fronds * 5.0;
    const double upright = 0.55 + 0.8 * random.uniform();
    const double length = size.frond_length * (0.7 + 0.3 * random.uniform());
    std::vector<DVec3> path;
    for (int k = 0; k <= 7; ++k) {
      path.push_back(on_frond(length, upright, k / 7.0));
    }
    const DVec3 place(0.0, foot, 0.0);
    append(stems, moved(turned(tube(path, 0.007, 5), turn_deg), place));
    append(leaflets, moved(turned(frond_leaflets(size, length, upright), turn_deg), place));
  }
  parts.push_back({materials.stem, stems, 60.0});
  parts.push_back({materials.leaflet, leaflets, 60.0});
  return parts;
}

std::vector<Part> potted_tree(const TreeSize& size, const PlantMaterials& materials, int fruit,
                              const Seed& seed) {
  std::vector<Part> parts = pot_with_soil(size.pot_radius, size.pot_height, materials);
  Pcg32 random = generator(seed);
  const DVec3 middle(0.0, size.pot_height + size.stem_height, 0.0);
  const auto somewhere = [&](double least_radius) {
    const double y = 2.0 * random.uniform() - 1.0;
    const double angle = 2.0 * pi * random.uniform();
    const double r = std::sqrt(1.0 - y * y);
    const DVec3 direction(r * std::sin(angle), y, r * std::cos(angle));
    return direction * std::lerp(least_radius, 1.0, random.uniform());
  };
  Shape leaves;
  for (int i = 0; i < size.leaves; ++i) {
    const DVec3 where = somewhere(0.55);
    const double length = 0.25 * size.crown_radius * (0.8 + 0.5 * random.uniform());
    const double tilt_deg = -80.0 + 100.0 * random.uniform();
    const double heading_deg =
        degrees(std::atan2(where.x, where.z)) + 120.0 * (random.uniform() - 0.5);
    const Shape blade = turned(leaf_blade(length, 0.55 * length, 0.25, 2), tilt_deg, {1, 0, 0});
    append(leaves, moved(turned(blade, heading_deg), middle + size.crown_radius * where));
  }
  Shape wood = tube({{0.0, 0.8 * size.pot_height, 0.0},
                     {0.015, size.pot_height + 0.4 * size.stem_height, 0.01},
                     middle},
                    0.032, 14);
  for (int i = 0; i < 12; ++i) {
    const DVec3 end = middle + 0.8 * size.crown_radius * somewhere(0.9);
    append(wood, tube({middle - DVec3(0.0, 0.35 * size.crown_radius, 0.0), end}, 0.01, 6));
  }
  Shape fruits;
  for (int i = 0; i < size.fruits; ++i) {
    append(fruits,
           moved(ellipsoid(DVec3(0.038), 12), middle + 0.97 * size.crown_radius * somewhere(0.95)));
  }
  parts.push_back({materials.stem, wood, 60.0});
  parts.push_back({materials.leaf, leaves, 80.0});
  parts.push_back({fruit, fruits, 60.0});
  return parts;
}

}  // namespace foveola::scenes
