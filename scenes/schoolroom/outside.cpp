// What is seen through the windows: the school yard, trees, the houses opposite.
#include <cmath>
#include <numbers>

#include "renderer/base/angles.h"
#include "renderer/base/random.h"
#include "scenes/modelling/curve.h"
#include "scenes/schoolroom/parts.h"

namespace foveola::scenes::school {
namespace {

using std::numbers::pi;
constexpr double ground = -0.6;
constexpr double street_z = -34.0;

/// A trunk that forks twice, and leaves in clumps around the ends of the branches.
struct Tree {
  Shape wood;
  Shape leaves;
};

Tree grown_tree(double height, const Seed& seed) {
  Pcg32 random = generator(seed);
  Tree tree;
  const double fork = 0.35 * height;
  append(tree.wood, moved(cone(0.028 * height, 0.018 * height, fork, 14), {0.0, 0.0, 0.0}));
  constexpr int branches = 9;
  for (int i = 0; i < branches; ++i) {
    const double angle = 2.0 * pi * (i + 0.5 * random.uniform()) / branches;
    const double reach = height * (0.1 + 0.16 * random.uniform());
    const DVec3 out(std::sin(angle), 0.0, std::cos(angle));
    const DVec3 tip = reach * out + DVec3(0.0, height * (0.5 + 0.42 * random.uniform()), 0.0);
    append(tree.wood, tube(curve({{0.0, 0.9 * fork, 0.0},
                                  0.35 * reach * out + DVec3(0, fork + 0.1 * height, 0),
                                  tip},
                                 4),
                           0.007 * height, 8));
    constexpr int leaves_at_tip = 170;
    for (int k = 0; k < leaves_at_tip; ++k) {
      const double polar = std::acos(1.0 - 2.0 * random.uniform());
      const double around = 2.0 * pi * random.uniform();
      const double radius = 0.16 * height * std::cbrt(random.uniform());
      const DVec3 place =
          tip + radius * DVec3(std::sin(polar) * std::sin(around), 0.75 * std::cos(polar),
                               std::sin(polar) * std::cos(around));
      const double size = 0.3 + 0.15 * random.uniform();
      const Shape blade = picture({-0.5 * size, 0.0, 0.0}, {size, 0.0, 0.0}, {0.0, size, 0.0});
      const Shape leaned = turned(blade, 140.0 * (random.uniform() - 0.5) - 60.0, {1, 0, 0});
      append(tree.leaves, moved(turned(leaned, 360.0 * random.uniform()), place));
    }
  }
  return tree;
}

void add_trees(Model& model, const Materials& m) {
  struct Place {
    double x;
    double z;
    double height;
  };
  Shape wood;
  Shape leaves;
  std::uint32_t number = 800;
  for (const Place& place :
       {Place{-10.0, -15.0, 7.5}, Place{-2.5, -21.0, 8.5}, Place{9.0, -17.0, 7.0},
        Place{17.0, -24.0, 9.0}, Place{-22.0, -22.0, 9.0}}) {
    const Tree tree = grown_tree(place.height, model.stream(++number));
    append(wood, moved(tree.wood, {place.x, ground, place.z}));
    append(leaves, moved(tree.leaves, {place.x, ground, place.z}));
  }
  add_object(model, "Trees", {{m.bark, with_uv_scale(wood, 0.6), 50.0}, {m.foliage, leaves, 5.0}});
}

void add_houses(Model& model, const Materials& m) {
  struct House {
    double left;
    double width;
    double height;
  };
  constexpr double depth = 9.0;
  Shape walls;
  Shape roofs;
  for (const House& house :
       {House{-78.0, 24.0, 6.4}, House{-52.0, 26.0, 9.6}, House{-24.0, 19.2, 6.4},
        House{-2.8, 25.6, 9.6}, House{24.8, 19.2, 6.4}, House{46.0, 28.0, 9.6}}) {
    const DVec3 low(house.left, ground, street_z - depth);
    const DVec3 high(house.left + house.width, ground + house.height, street_z);
    append(walls, box(low, high));
    const double middle_z = street_z - 0.5 * depth;
    const double ridge = high.y + 3.2;
    const double eaves = 0.4;
    // A gabled roof: a wedge with its ridge along X.
    Shape roof = patch(1, 3, [&](double u, double v) {
      const int corner = static_cast<int>(std::lround(3.0 * v)) % 3;
      const double x = std::lerp(low.x - eaves, high.x + eaves, u);
      return corner == 0   ? DVec3(x, high.y, high.z + eaves)
             : corner == 1 ? DVec3(x, ridge, middle_z)
                           : DVec3(x, high.y, low.z - eaves);
    });
    append(roofs, with_projected_uvs(roof, {1, 0, 0}, {0, 1.2, 0}));
    for (const double end : {low.x - eaves, high.x + eaves}) {
      Shape gable;
      gable.positions = {
          {end, high.y, high.z + eaves}, {end, high.y, low.z - eaves}, {end, ridge, middle_z}};
      gable.uvs = {{0, 0}, {1, 0}, {0.5, 1}};
      gable.triangles = {{0, 1, 2}};
      append(roofs, end > low.x ? gable : inside_out(gable));
    }
    append(roofs, box({house.left + 0.7 * house.width, high.y, middle_z - 0.5},
                      {house.left + 0.7 * house.width + 1.0, ridge + 0.9, middle_z + 0.5}));
  }
  add_object(model, "Houses opposite",
             {{m.facade, with_uv_scale(walls, 1.0 / 3.2)}, {m.roof, with_uv_scale(roofs, 0.3)}});
}

/// Wooded hills all around close the view below the sky.
void add_hills(Model& model, const Materials& m) {
  constexpr double distance = 260.0;
  const Shape hills = inside_out(patch(96, 6, [&](double u, double v) {
    const double angle = 2.0 * pi * u;
    const double height = 15.0 + 5.0 * std::sin(3.0 * angle + 1.0) + 3.0 * std::sin(8.0 * angle) +
                          1.5 * std::sin(19.0 * angle + 0.7);
    const double r = distance + 60.0 * v;
    return DVec3(r * std::sin(angle),
                 ground - 1.0 + (height + 1.0) * std::sin(0.5 * std::numbers::pi * v),
                 r * std::cos(angle));
  }));
  add_object(model, "Hills", {{m.grass, with_uv_scale(hills, 20.0), 60.0}});
}

}  // namespace

void add_outside(Model& model, const Materials& m) {
  const Shape lawn = rectangle({-300.0, ground, 300.0}, {600.0, 0.0, 0.0}, {0.0, 0.0, -600.0});
  add_object(model, "Lawn", {{m.grass, with_uv_scale(lawn, 0.25)}});
  const Shape yard =
      box({-14.0, ground - 0.1, -12.0}, {12.0, ground + 0.02, -half_z - wall_thickness});
  const Shape pavement =
      box({-120.0, ground - 0.1, street_z + 1.0}, {120.0, ground + 0.12, street_z + 4.0});
  Shape stone = yard;
  append(stone, pavement);
  add_object(model, "Yard", {{m.paving, with_uv_scale(stone, 0.4)}});
  Shape rails;
  for (int i = 0; i < 60; ++i) {
    const double x = -30.0 + i;
    append(rails, moved(box(DVec3(0.07, 1.0, 0.07)), {x, ground + 0.5, -27.0}));
  }
  for (const double y : {0.35, 0.8}) {
    append(rails, moved(box(DVec3(60.0, 0.1, 0.03)), {-0.5, ground + y, -26.94}));
  }
  add_object(model, "Fence", {{m.white_paint, rails}});
  add_trees(model, m);
  add_houses(model, m);
  add_hills(model, m);
}

}  // namespace foveola::scenes::school
