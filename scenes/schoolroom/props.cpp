// Things to look at: globe, planets, microscope, molecule, plants.
#include <cmath>
#include <numbers>

#include "renderer/base/random.h"
#include "scenes/modelling/curve.h"
#include "scenes/schoolroom/layout.h"
#include "scenes/schoolroom/parts.h"

namespace foveola::scenes::school {
namespace {

using std::numbers::pi;

/// A ball whose uvs run over [0, 1]: longitude and, from the top, latitude.
Shape mapped_ball(double radius, int segments) {
  Shape ball = ellipsoid(DVec3(radius), segments);
  for (std::size_t i = 0; i < ball.positions.size(); ++i) {
    ball.uvs[i].y =
        std::acos(glm::clamp(ball.positions[i].y / radius, -1.0, 1.0)) / std::numbers::pi;
  }
  return ball;
}

Shape bond(const DVec3& from, const DVec3& to) { return tube({from, to}, 0.006, 10); }

/// Crumpled paper.
Shape crumpled_ball(double radius, const Seed& seed) {
  Pcg32 random = generator(seed);
  const double a = 6.0 * random.uniform();
  const double b = 6.0 * random.uniform();
  return deformed(ellipsoid(DVec3(radius), 18), [&](const DVec3& p) {
    const DVec3 q = p / radius;
    const double crease = std::sin(5.0 * q.x + 7.0 * q.y + a) * std::sin(8.0 * q.z - 4.0 * q.y + b);
    return p * (0.85 + 0.3 * std::abs(crease));
  });
}

}  // namespace

void add_globe(Model& model, const Materials& m) {
  constexpr double radius = 0.17;
  constexpr double axis_tilt_deg = -23.4;
  const DVec3 middle(0.0, 0.29, 0.0);
  const auto tilt = [&](const Shape& shape) {
    return moved(turned(shape, axis_tilt_deg, {1, 0, 0}), middle);
  };
  std::vector<DVec3> half_circle;
  for (int i = 0; i <= 30; ++i) {
    const double angle = std::numbers::pi * (i / 30.0 - 0.5);
    half_circle.push_back((radius + 0.02) * DVec3(0.0, std::sin(angle), -std::cos(angle)));
  }
  Shape meridian = tube(half_circle, 0.005, 10);
  Shape pins = cylinder(0.006, 2.0 * radius + 0.07, 12);
  pins = moved(pins, {0.0, -radius - 0.035, 0.0});
  append(meridian, pins);
  const Shape foot = lathe({{0.0, 0.0},
                            {0.11, 0.0},
                            {0.115, 0.008},
                            {0.105, 0.02},
                            {0.06, 0.03},
                            {0.03, 0.04},
                            {0.02, 0.06},
                            {0.028, 0.075},
                            {0.016, 0.09},
                            {0.0, 0.092}},
                           40);
  const DVec3 place = teacher_desk_top + DVec3(-0.1, 0.0, 0.42);
  add_object(model, "Globe",
             placed({{m.globe, tilt(turned(mapped_ball(radius, 72), 150.0)), 60.0},
                     {m.brass, tilt(meridian), 60.0},
                     {m.dark_wood, foot, 50.0}},
                    place, -100.0));
}

void add_planets(Model& model, const Materials& m) {
  const DVec3 sun(1.3, 2.52, -0.55);
  struct Planet {
    double distance;
    double radius;
    int material;
  };
  const std::vector<Planet> planets = {{0.17, 0.022, m.stone},   {0.25, 0.034, m.bone},
                                       {0.35, 0.036, m.globe},   {0.44, 0.028, m.red},
                                       {0.58, 0.085, m.plywood}, {0.76, 0.068, m.yellow}};
  Shape strings = tube({sun, {sun.x, ceiling, sun.z}}, 0.0025, 6);
  Shape rods;
  std::vector<Part> parts = {{m.yellow, moved(mapped_ball(0.11, 40), sun), 60.0}};
  for (std::size_t i = 0; i < planets.size(); ++i) {
    const auto& [distance, radius, material] = planets[i];
    const double angle = 2.4 * static_cast<double>(i) + 0.5;
    const DVec3 direction(std::sin(angle), 0.0, std::cos(angle));
    const DVec3 hub = sun + DVec3(0.0, 0.22 + 0.035 * static_cast<double>(i), 0.0);
    const DVec3 end = hub + distance * direction;
    const DVec3 middle(end.x, sun.y - 0.03 * static_cast<double>(i % 3), end.z);
    append(rods, tube({hub - 0.25 * distance * direction, end}, 0.003, 8));
    append(strings, tube({end, middle}, 0.0015, 6));
    parts.push_back({material, moved(mapped_ball(radius, 32), middle), 60.0});
    if (i + 1 == planets.size()) {
      const Shape ring = scaled(torus(1.75 * radius, 0.35 * radius, 56, 10), {1.0, 0.06, 1.0});
      parts.push_back({m.plywood, moved(turned(ring, 20.0, {0, 0, 1}), middle), 60.0});
    }
  }
  parts.push_back({m.black_plastic, strings, 60.0});
  parts.push_back({m.brass, rods, 60.0});
  add_object(model, "Planets", parts);
}

void add_microscope(Model& model, const Materials& m) {
  Shape body = moved(rounded_box({0.15, 0.03, 0.2}, 0.012, 3), {0.0, 0.015, 0.0});
  append(body,
         tube(curve({{0.0, 0.02, -0.07}, {0.0, 0.12, -0.085}, {0.0, 0.24, -0.06}, {0.0, 0.29, 0.0}},
                    6),
              0.02, 16));
  append(body, moved(rounded_box({0.12, 0.012, 0.12}, 0.004, 2), {0.0, 0.12, 0.01}));
  append(body, moved(rounded_box({0.04, 0.05, 0.1}, 0.012, 3), {0.0, 0.11, -0.05}));
  Shape tubes = lathe({{0.0, 0.0},
                       {0.012, 0.0},
                       {0.012, 0.03},
                       {0.02, 0.035},
                       {0.02, 0.14},
                       {0.017, 0.145},
                       {0.017, 0.2},
                       {0.02, 0.205},
                       {0.02, 0.225},
                       {0.0, 0.22}},
                      28);
  tubes = moved(turned(tubes, -24.0, {1, 0, 0}), {0.0, 0.24, 0.02});
  for (const double angle_deg : {0.0, 120.0, 240.0}) {
    const Shape lens =
        turned(moved(cone(0.006, 0.012, 0.05, 20), {0.0, -0.07, 0.0}), 28.0, {1, 0, 0});
    append(tubes, moved(turned(lens, angle_deg), {0.0, 0.255, 0.012}));
  }
  for (const double side : {-1.0, 1.0}) {
    append(tubes, moved(turned(cylinder(0.022, 0.018, 28), -90.0 * side, {0, 0, 1}),
                        {side * 0.017, 0.16, -0.08}));
  }
  const Shape slide = box({-0.038, 0.1262, -0.002}, {0.038, 0.1275, 0.024});
  const DVec3 place(1.45, desk_height, 2.1);
  add_object(model, "Microscope",
             placed({{m.black_plastic, body, 50.0}, {m.brass, tubes, 50.0}, {m.bone, slide}}, place,
                    -70.0));
}

void add_molecule(Model& model, const Materials& m) {
  constexpr double step = 0.075;
  Shape carbon;
  Shape hydrogen;
  Shape bonds;
  // Two rings that share a side, each carbon with a hydrogen: naphthalene, with a tail.
  const auto ring_point = [&](int i, double x) {
    const double angle = 2.0 * pi * (i + 0.5) / 6.0;
    return DVec3(x + step * std::sin(angle), 0.0, step * std::cos(angle));
  };
  const double apart = std::sqrt(3.0) * step;
  for (const double x : {-0.5 * apart, 0.5 * apart}) {
    for (int i = 0; i < 6; ++i) {
      const DVec3 here = ring_point(i, x);
      append(bonds, bond(here, ring_point(i + 1, x)));
      const bool is_shared = std::abs(here.x) < 0.2 * step;
      if (!is_shared || x < 0.0) {
        append(carbon, moved(ellipsoid(DVec3(0.022), 24), here));
      }
      if (!is_shared) {
        const DVec3 out = here + 0.75 * (here - DVec3(x, 0.0, 0.0));
        append(bonds, bond(here, out));
        append(hydrogen, moved(ellipsoid(DVec3(0.015), 20), out));
      }
    }
  }
  const auto stood = [](const Shape& shape) {
    return moved(turned(shape, 62.0, {1, 0, 0}), {0.0, 0.2, 0.0});
  };
  Shape stand = cone(0.07, 0.06, 0.02, 32);
  append(stand, cylinder(0.005, 0.2, 12));
  add_object(model, "Molecule",
             placed({{m.black_plastic, stood(carbon), 60.0},
                     {m.red, stood(hydrogen), 60.0},
                     {m.steel, stood(bonds), 60.0},
                     {m.plywood, stand, 40.0}},
                    {-half_x + 0.16, 1.945, -0.35}, 80.0));
}

void add_waste_basket(Model& model, const Materials& m) {
  const DVec3 place(2.2, 0.0, 3.15);
  constexpr int wires = 28;
  Shape basket;
  for (int i = 0; i < wires; ++i) {
    for (const double twist : {-0.5, 0.5}) {
      std::vector<DVec3> path;
      for (int k = 0; k <= 6; ++k) {
        const double t = k / 6.0;
        const double angle = 2.0 * pi * i / wires + twist * t;
        const double r = 0.11 + 0.04 * t;
        path.emplace_back(r * std::sin(angle), 0.01 + 0.33 * t, r * std::cos(angle));
      }
      append(basket, tube(path, 0.0016, 5));
    }
  }
  append(basket, moved(torus(0.15, 0.005, 48, 10), {0.0, 0.34, 0.0}));
  append(basket, cylinder(0.112, 0.01, 32));
  Shape paper;
  Pcg32 random = generator(model.stream(650));
  for (std::uint32_t i = 0; i < 14; ++i) {
    const double angle = 2.4 * i;
    const double r = 0.062 * std::sqrt(random.uniform());
    append(paper, moved(crumpled_ball(0.042, model.stream(660 + i)),
                        {r * std::sin(angle), 0.05 + 0.017 * i, r * std::cos(angle)}));
  }
  append(paper, moved(crumpled_ball(0.04, model.stream(690)), {-0.28, 0.034, -0.05}));
  add_object(model, "Waste basket",
             moved({{m.steel, basket, 60.0}, {m.paper, paper, 30.0}}, place));
}

void add_plants(Model& model, const Materials& m) {
  const double sill = window_sill + 0.0075;
  const PlantSize pot{
      .pot_radius = 0.1, .pot_height = 0.16, .stem_height = 0.3, .leaf_length = 0.17};
  add_object(model, "Window plant",
             moved(potted_plant(pot, m.plant, model.stream(700)), {2.75, sill, -half_z + 0.06}));
  std::uint32_t number = 701;
  for (const double x : {-3.6, -1.35, 0.75, 3.75}) {
    const PlantSize size{.pot_radius = 0.08 + 0.01 * (number % 3),
                         .pot_height = 0.14,
                         .stem_height = 0.18 + 0.05 * (number % 4),
                         .leaf_length = 0.13,
                         .stems = 8};
    add_object(model, "Sill plant " + std::to_string(number - 700),
               moved(potted_plant(size, m.plant, model.stream(number)), {x, sill, -half_z + 0.05}));
    ++number;
  }
  const PlantSize tall{.pot_radius = 0.24,
                       .pot_height = 0.4,
                       .stem_height = 1.1,
                       .leaf_length = 0.36,
                       .stems = 12,
                       .leaves_per_stem = 7};
  add_object(
      model, "Tall plant",
      moved(potted_plant(tall, m.plant, model.stream(710)), {-half_x + 0.55, 0.0, half_z - 0.55}));
}

}  // namespace foveola::scenes::school
