#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "scenes/modelling/curve.h"
#include "scenes/studio_car/pose.h"
#include "scenes/studio_car/studio.h"

namespace foveola::scenes::studio {
namespace {

constexpr double softbox_depth = 0.5;

struct Softbox {
  const char* name;
  int material;
  double width;
  double height;
  DVec3 position;
  DVec3 target;
};

/// The cloth from a softbox's rectangular front to the round mount behind it, seen from outside.
Shape softbox_cloth(double half_width, double half_height) {
  constexpr int around = 96;
  constexpr double mount_radius = 0.09;
  const auto rim = [&](double turn) {
    const double angle = 2.0 * std::numbers::pi * turn;
    const DVec2 round(std::cos(angle), std::sin(angle));
    const double to_square = 1.0 / std::max(std::abs(round.x), std::abs(round.y));
    return std::pair(round * to_square * DVec2(half_width, half_height), mount_radius * round);
  };
  return patch(around, 16, [&](double u, double v) {
    const auto [square, round] = rim(1.0 - u);
    // Rods bow the cloth outwards.
    const double bow = std::pow(1.0 - v, 0.75);
    const DVec2 at = bow * square + (1.0 - bow) * round;
    return DVec3(at, -softbox_depth * v);
  });
}

void add_softbox(Model& model, const Materials& m, const Softbox& softbox) {
  const double w = 0.5 * softbox.width;
  const double h = 0.5 * softbox.height;
  const Shape glow = rectangle({-w, -h, -0.03}, {2.0 * w, 0.0, 0.0}, {0.0, 2.0 * h, 0.0});
  Shape cloth = softbox_cloth(w + 0.021, h + 0.021);
  for (const double side : {-1.0, 1.0}) {
    append(cloth, moved(rounded_box({2.0 * w + 0.045, 0.02, 0.1}, 0.006, 3),
                        {0.0, side * (h + 0.01), 0.0}));
    append(cloth,
           moved(rounded_box({0.02, 2.0 * h, 0.098}, 0.006, 3), {side * (w + 0.01), 0.0, 0.0}));
  }
  const Shape ring = lathe(
      {{0.09, -0.03}, {0.11, -0.03}, {0.115, -0.02}, {0.115, 0.02}, {0.11, 0.03}, {0.09, 0.03}},
      48);
  Shape head = lathe({{0.0, -0.42},
                      {0.05, -0.42},
                      {0.062, -0.41},
                      {0.066, -0.38},
                      {0.066, -0.06},
                      {0.078, -0.05},
                      {0.08, -0.01},
                      {0.0, -0.01}},
                     48);
  append(head, moved(rounded_box({0.05, 0.1, 0.06}, 0.012, 3), {0.0, -0.2, 0.07}));
  const auto behind = [](const Shape& shape) {
    return moved(turned(shape, 90.0, {1, 0, 0}), {0.0, 0.0, -softbox_depth});
  };
  const DMat4 pose = facing(softbox.position, softbox.target - softbox.position);
  add_object(model, softbox.name,
             {{softbox.material, transformed(glow, pose)},
              {m.black_cloth, transformed(cloth, pose), 60.0},
              {m.aluminium, transformed(behind(ring), pose), 45.0},
              {m.black_steel, transformed(behind(head), pose), 45.0}});
}

/// A light stand whose column ends at `top`.
void add_stand(Model& model, const Materials& m, const char* name, const DVec3& top) {
  const DVec3 foot(top.x, 0.0, top.z);
  Shape stand = tube({foot + DVec3(0, 0.28, 0), foot + DVec3(0, 0.5 * top.y, 0)}, 0.02, 20);
  append(stand,
         tube({foot + DVec3(0, 0.5 * top.y, 0), foot + DVec3(0, 0.8 * top.y, 0)}, 0.016, 20));
  append(stand, tube({foot + DVec3(0, 0.8 * top.y, 0), top}, 0.0125, 20));
  Shape clamps;
  for (const double height : {0.3, 0.72, 0.5 * top.y, 0.8 * top.y}) {
    append(clamps, moved(lathe({{0.0, -0.03},
                                {0.026, -0.03},
                                {0.029, -0.024},
                                {0.029, 0.024},
                                {0.026, 0.03},
                                {0.0, 0.03}},
                               24),
                         foot + DVec3(0, height, 0)));
    append(clamps,
           tube({foot + DVec3(0.02, height, 0), foot + DVec3(0.065, height, 0)}, 0.008, 10));
    append(clamps, moved(ellipsoid({0.012, 0.02, 0.02}, 16), foot + DVec3(0.07, height, 0)));
  }
  Shape bag;
  for (int i = 0; i < 3; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 3.0;
    const DVec3 out(std::sin(angle), 0.0, std::cos(angle));
    append(stand,
           tube({foot + DVec3(0, 0.72, 0) + 0.02 * out, foot + 0.55 * out + DVec3(0, 0.03, 0)},
                0.0115, 12));
    append(stand,
           tube({foot + DVec3(0, 0.3, 0) + 0.02 * out, foot + 0.32 * out + DVec3(0, 0.33, 0)},
                0.007, 10));
    append(clamps,
           moved(ellipsoid({0.02, 0.026, 0.02}, 16), foot + 0.555 * out + DVec3(0, 0.026, 0)));
  }
  for (const double side : {-1.0, 1.0}) {
    append(bag, moved(ellipsoid({0.1, 0.16, 0.07}, 32), foot + DVec3(0.1 * side, 0.17, 0.28)));
  }
  append(bag, tube({foot + DVec3(-0.06, 0.3, 0.28), foot + DVec3(0.0, 0.335, 0.28),
                    foot + DVec3(0.06, 0.3, 0.28)},
                   0.025, 12));
  add_object(model, name,
             {{m.black_steel, stand, 45.0}, {m.car.rubber, clamps, 45.0}, {m.sandbag, bag, 50.0}});
}

/// Where the stand carries a softbox's head.
DVec3 mount(const Softbox& softbox) {
  const DVec3 ahead = glm::normalize(softbox.target - softbox.position);
  return softbox.position - (softbox_depth + 0.2) * ahead - DVec3(0.0, 0.08, 0.0);
}

std::vector<Softbox> standing_softboxes(const Materials& m) {
  const DVec3 car(0.0, 0.7, 0.0);
  return {{"Key softbox", m.softbox, 1.3, 2.2, {5.0, 2.4, -2.4}, car},
          {"Fill softbox", m.warm_softbox, 1.6, 2.2, {-3.6, 2.2, 4.8}, car},
          {"Room softbox", m.warm_softbox, 1.4, 1.4, {5.5, 3.0, 6.2}, {1.0, 0.3, 1.0}}};
}

}  // namespace

void add_softboxes(Model& model, const Materials& m) {
  add_softbox(model, m,
              {"Overhead softbox", m.softbox, 1.7, 4.4, {0.0, 4.4, 0.0}, {0.0, 0.0, 0.0}});
  Shape suspension;
  for (const double x : {-0.85, 0.85}) {
    for (const double z : {-2.2, 2.2}) {
      append(suspension, tube({{x, 4.44, z}, {x, ceiling, z}}, 0.004, 8));
    }
  }
  add_object(model, "Suspension", {{m.steel, suspension, 50.0}});
  for (const Softbox& softbox : standing_softboxes(m)) {
    add_softbox(model, m, softbox);
    const std::string name(softbox.name);
    const std::string stand = fmt::format("{} stand", name.substr(0, name.find(' ')));
    add_stand(model, m, stand.c_str(), mount(softbox));
  }
}

void add_cables(Model& model, const Materials& m) {
  Shape cables;
  const auto lay = [&](const std::vector<DVec3>& points) {
    append(cables, tube(curve(points, 12), 0.006, 10));
  };
  constexpr double floor = 0.0065;
  for (const Softbox& softbox : standing_softboxes(m)) {
    const DVec3 top = mount(softbox);
    const double side = top.z > 0.0 ? 1.0 : -1.0;
    lay({top + DVec3(0.0, 0.0, 0.03 * side),
         {top.x + 0.05, 0.6 * top.y, top.z + 0.12 * side},
         {top.x + 0.1, 0.25, top.z + 0.2 * side},
         {top.x + 0.3, floor, top.z + 0.4 * side},
         {0.5 * (top.x + half_room), floor, top.z + 0.9 * side},
         {half_room - 0.6, floor, top.z + 0.5 * side},
         {half_room - 0.05, floor, top.z + 0.7 * side}});
  }
  // A coil left lying beside the photographer.
  std::vector<DVec3> coil;
  for (int i = 0; i <= 180; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 36.0;
    const double radius = 0.2 + 0.012 * std::sin(1.7 * angle);
    coil.emplace_back(5.0 + radius * std::sin(angle), floor + 0.0128 * i / 36.0,
                      4.3 + radius * std::cos(angle));
  }
  append(cables, tube(coil, 0.006, 10));
  add_object(model, "Cables", {{m.cable, cables, 60.0}});
}

}  // namespace foveola::scenes::studio
