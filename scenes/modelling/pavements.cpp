#include "scenes/modelling/pavements.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "renderer/base/random.h"
#include "scenes/modelling/painting.h"

namespace foveola::scenes {
namespace {

using namespace paint;  // NOLINT(google-build-using-namespace): its every name is drawn with here

const DVec3 white_marble(0.62, 0.6, 0.55);
const DVec3 porphyry(0.26, 0.045, 0.05);
const DVec3 serpentine(0.05, 0.17, 0.09);
const DVec3 yellow_marble(0.5, 0.33, 0.1);

/// The colour of a small inlaid stone.
DVec3 inlay(int i, int j, const Seed& seed) {
  const std::array<DVec3, 4> stones = {porphyry, serpentine, yellow_marble, white_marble * 0.9};
  const auto index = static_cast<std::size_t>(4.0 * cell_value(i, j, seed));
  return stones.at(index) * (0.75 + 0.5 * cell_value(j, i, mix(seed, 1)));
}

/// Triangles between white joints in square cells: `x` and `y` count the cells.
DVec3 small_triangles(double x, double y, const Seed& seed) {
  const double fx = x - std::floor(x);
  const double fy = y - std::floor(y);
  const int half = fx + fy < 1.0 ? 0 : 1;
  const double joint = std::min({fx, fy, 1.0 - fx, 1.0 - fy, 0.7 * std::abs(fx + fy - 1.0)});
  const DVec3 stone =
      inlay(2 * static_cast<int>(std::floor(x)) + half, static_cast<int>(std::floor(y)) + 7, seed);
  return blend(white_marble, stone, smooth_step(0.05, 0.09, joint));
}

DVec3 worn(const DVec3& color, double u, double v, const Seed& seed) {
  return color * (0.75 + 0.5 * cloud(u, v, 24, seed));
}

}  // namespace

Image stone_slabs(int size, const Seed& seed) {
  constexpr int rows = 5;
  constexpr std::array<int, rows> slabs_in_row = {3, 4, 3, 5, 4};
  constexpr double joint = 0.0035;
  return painted(size, size, [&](double u, double v) {
    const double wander = 0.003 * (cloud(u, v, 8, mix(seed, 1)) - 0.5);
    const int row = std::min(static_cast<int>(v * rows), rows - 1);
    const int slabs = slabs_in_row.at(static_cast<std::size_t>(row));
    const double shifted = (u + wander + 2.0 + cell_value(row, 0, seed)) * slabs;
    const int slab = static_cast<int>(std::floor(shifted)) % slabs;
    const double from_joint = std::min(distance_to_integer((v + wander) * rows) / rows,
                                       distance_to_integer(shifted) / slabs);
    const double tone = cell_value(slab, row + 10, seed);
    const DVec3 stone = blend({0.3, 0.27, 0.22}, {0.36, 0.35, 0.33}, tone);
    const double shade = 0.72 + 0.36 * cell_value(slab, row + 20, seed);
    const double grain = 0.7 + 0.6 * cloud(u, v, 40, mix(seed, 2));
    const double stain = 0.85 + 0.3 * cloud(u, v, 5, mix(seed, 3));
    // Feet have rounded the edges and left the joints dark.
    const double edge = 0.8 + 0.2 * smooth_step(joint, 6.0 * joint, from_joint);
    const double open = smooth_step(0.5 * joint, joint, from_joint);
    return blend(DVec3(0.07, 0.06, 0.05), stone * shade * grain * stain * edge, open);
  });
}

Image inlaid_rosette(int size, const Seed& seed) {
  constexpr double edge = 0.0015;
  return painted(size, size, [&](double u, double v) {
    const DVec2 p(2.0 * u - 1.0, 1.0 - 2.0 * v);
    const double radius = glm::length(p);
    const double turn = std::atan2(p.x, p.y) / (2.0 * std::numbers::pi) + 0.5;
    DVec3 color = small_triangles(20.0 * u, 20.0 * v, seed);
    const auto disc = [&](double r, const DVec3& with) {
      color = blend(color, white_marble, inside(radius - r - 0.012, edge));
      color = blend(color, with, inside(radius - r, edge));
    };
    disc(0.96, small_triangles(96.0 * turn, 12.0 * radius, mix(seed, 1)));
    disc(0.78, white_marble * 0.92);
    // Eight discs around the middle, each in a ring of triangles.
    const DVec2 petal = in_sector(p, 8) - DVec2(0.0, 0.58);
    const int number = sector_of(p, 8);
    const double petal_turn = std::atan2(petal.x, petal.y) / (2.0 * std::numbers::pi) + 0.5;
    const double petal_radius = glm::length(petal);
    color = blend(color, small_triangles(24.0 * petal_turn, 14.0 * petal_radius, mix(seed, 2)),
                  inside(petal_radius - 0.18, edge));
    color = blend(color, white_marble, stroke(petal_radius - 0.11, 0.014, edge));
    color = blend(color, number % 2 == 0 ? porphyry : serpentine, inside(petal_radius - 0.1, edge));
    disc(0.36, small_triangles(40.0 * turn, 14.0 * radius, mix(seed, 3)));
    disc(0.28, serpentine);
    // A star of sixteen points: a triangle in each sector.
    const DVec2 ray = in_sector(p, 16);
    color = blend(color, yellow_marble, inside(std::abs(ray.x) - 0.19 * (0.27 - ray.y), edge));
    disc(0.11, porphyry);
    return worn(color, u, v, mix(seed, 4));
  });
}

Image inlaid_band(int size, const Seed& seed) {
  constexpr double edge = 0.004;
  return painted(size, size, [&](double u, double v) {
    const DVec2 p(2.0 * u - 1.0, 1.0 - 2.0 * v);
    const double from_edge = 1.0 - std::abs(p.y);
    const double turn = std::atan2(p.x, p.y) / (2.0 * std::numbers::pi) + 0.5;
    const double radius = glm::length(p);
    DVec3 color = small_triangles(12.0 * u, 12.0 * v, seed);
    color = blend(color, white_marble, inside(from_edge - 0.16, edge));
    color = blend(color, porphyry, inside(std::abs(from_edge - 0.08) - 0.035, edge));
    color = blend(color, white_marble, inside(radius - 0.8, edge));
    color = blend(color, small_triangles(36.0 * turn, 9.0 * radius, mix(seed, 1)),
                  inside(radius - 0.76, edge));
    color = blend(color, white_marble, inside(radius - 0.5, edge));
    color = blend(color, serpentine, inside(radius - 0.46, edge));
    color = blend(color, white_marble, inside(to_foil(p, 4, 0.2, 0.17), edge));
    color = blend(color, porphyry, inside(to_foil(p, 4, 0.2, 0.13), edge));
    return worn(color, u, v, mix(seed, 2));
  });
}

}  // namespace foveola::scenes
