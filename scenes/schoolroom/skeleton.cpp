// The biology class's skeleton, 1.7 m tall, on a stand.
#include <cmath>
#include <numbers>

#include "scenes/modelling/curve.h"
#include "scenes/schoolroom/layout.h"
#include "scenes/schoolroom/parts.h"

namespace foveola::scenes::school {
namespace {

/// A long bone with thickened ends between two joints.
Shape bone(const DVec3& from, const DVec3& to, double radius, int segments = 16) {
  const double length = glm::distance(from, to);
  std::vector<DVec2> outline;
  const int steps = segments < 16 ? 8 : 14;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const double from_end = std::min(t, 1.0 - t) * length / radius;
    const double head = 1.1 * std::exp(-0.25 * from_end);
    const double tip = std::sqrt(std::min(1.0, 0.55 * from_end));
    outline.emplace_back(radius * (0.75 + head) * tip, t * length);
  }
  const DVec3 direction = (to - from) / length;
  const DVec3 axis = glm::cross(DVec3(0, 1, 0), direction);
  const double sine = glm::length(axis);
  const double angle_deg = std::atan2(sine, direction.y) * 180.0 / std::numbers::pi;
  const Shape upright = lathe(outline, segments);
  return moved(sine > 1e-6 ? turned(upright, angle_deg, axis / sine)
                           : (direction.y > 0.0 ? upright : turned(upright, 180.0, {1, 0, 0})),
               from);
}

/// A finger's or toe's bones through the points.
void add_digit(Shape& to, const std::vector<DVec3>& joints, double radius) {
  for (std::size_t i = 1; i < joints.size(); ++i) {
    append(to, bone(joints[i - 1], joints[i], radius * (1.0 - 0.12 * static_cast<double>(i)), 10));
  }
}

struct Skull {
  Shape bone;
  Shape hollows;
};

Skull skull() {
  Skull result;
  const Shape cranium = deformed(ellipsoid({0.074, 0.085, 0.096}, 40), [](const DVec3& p) {
    // Narrower towards the face, with a brow over the orbits.
    const double front = std::max(0.0, p.z / 0.096);
    const double brow = 0.006 * std::exp(-std::pow((p.y + 0.002) / 0.014, 2.0)) * front;
    const double cheeks = p.y < -0.02 ? 1.0 - 0.5 * (-p.y - 0.02) / 0.065 : 1.0;
    return DVec3(p.x * (1.0 - 0.12 * front) * cheeks, p.y, p.z + brow);
  });
  append(result.bone, cranium);
  const Shape face = moved(rounded_box({0.084, 0.085, 0.06}, 0.028, 5), {0.0, -0.055, 0.058});
  append(result.bone, face);
  for (const double side : {-1.0, 1.0}) {
    append(result.bone, tube(curve({{side * 0.038, -0.04, 0.078},
                                    {side * 0.062, -0.042, 0.055},
                                    {side * 0.066, -0.04, 0.0}},
                                   5),
                             0.008, 12));
    append(result.hollows,
           moved(ellipsoid({0.019, 0.017, 0.012}, 24), {side * 0.026, -0.022, 0.086}));
    append(result.bone, tube(curve({{side * 0.056, -0.05, -0.005},
                                    {side * 0.054, -0.105, 0.01},
                                    {side * 0.036, -0.125, 0.06},
                                    {0.0, -0.128, 0.078}},
                                   5),
                             0.011, 12));
  }
  append(result.hollows, moved(cone(0.013, 0.004, 0.032, 16), {0.0, -0.07, 0.083}));
  for (int row = 0; row < 2; ++row) {
    for (int i = 0; i < 10; ++i) {
      const double angle = 0.19 * (i - 4.5);
      append(result.bone, moved(rounded_box({0.0075, 0.014, 0.007}, 0.0025, 2),
                                {0.042 * std::sin(angle), -0.098 - 0.015 * row,
                                 0.044 + 0.046 * std::cos(angle)}));
    }
  }
  return result;
}

/// Heights along the spine: it curves like an S.
DVec3 spine_point(double y) {
  const double t = (y - 0.95) / 0.6;
  return {0.0, y, -0.03 + 0.03 * std::sin(5.5 * t + 0.6)};
}

Shape spine() {
  Shape shape;
  constexpr int vertebrae = 24;
  for (int i = 0; i < vertebrae; ++i) {
    const double t = i / (vertebrae - 1.0);
    const DVec3 place = spine_point(0.95 + 0.56 * t);
    const double size = 1.0 - 0.45 * t;
    append(shape,
           moved(scaled(rounded_box({0.046, 0.018, 0.038}, 0.008, 3), {size, 1.0, size}), place));
    append(shape, moved(turned(rounded_box({0.009, 0.012, 0.05}, 0.004, 2), 25.0, {1, 0, 0}),
                        place + DVec3(0.0, -0.005, -0.038 * size)));
    append(shape, moved(rounded_box({0.09 * size, 0.009, 0.012}, 0.004, 2),
                        place - DVec3(0.0, 0.0, 0.018)));
  }
  return shape;
}

Shape rib_cage() {
  Shape shape = moved(turned(rounded_box({0.034, 0.17, 0.012}, 0.005, 3), -12.0, {1, 0, 0}),
                      {0.0, 1.29, 0.105});
  constexpr int ribs = 11;
  for (int i = 0; i < ribs; ++i) {
    const double t = i / (ribs - 1.0);
    const double top = 1.41 - 0.3 * t;
    const double half_width = 0.075 + 0.075 * std::sin(0.35 + 2.1 * std::min(1.0, 1.1 * t));
    const double depth = 0.085 + 0.04 * std::sin(2.4 * t + 0.3);
    // The lowest ribs end before they reach the breastbone.
    const double reach = i < 7 ? 1.0 : 0.86 - 0.13 * (i - 7);
    for (const double side : {-1.0, 1.0}) {
      std::vector<DVec3> path;
      constexpr int steps = 18;
      for (int k = 0; k <= steps; ++k) {
        const double s = reach * k / steps;
        const double angle = std::numbers::pi * s;
        const double drop =
            0.1 * std::sin(0.5 * std::numbers::pi * s) - 0.03 * s * s * (i < 7 ? t : 0.0);
        path.emplace_back(side * (0.015 + half_width * std::sin(angle)), top - drop,
                          spine_point(top).z + depth * (1.0 - std::cos(angle)) * 0.68);
      }
      append(shape, tube(path, 0.006, 8));
    }
  }
  return shape;
}

Shape pelvis() {
  Shape shape = moved(cone(0.012, 0.045, 0.1, 20), {0.0, 0.86, -0.045});
  for (const double side : {-1.0, 1.0}) {
    const Shape wing = deformed(ellipsoid({0.02, 0.075, 0.065}, 28), [&](const DVec3& p) {
      return DVec3(p.x + side * (3.0 * p.y * p.y + 0.25 * p.y), p.y, p.z);
    });
    append(shape, moved(wing, {side * 0.085, 0.95, -0.02}));
    append(
        shape,
        tube(curve({{side * 0.1, 0.9, 0.02}, {side * 0.06, 0.865, 0.06}, {0.0, 0.855, 0.075}}, 5),
             0.014, 12));
    append(shape, tube(curve({{side * 0.1, 0.88, -0.01},
                              {side * 0.07, 0.81, 0.0},
                              {side * 0.04, 0.825, 0.05},
                              {side * 0.01, 0.85, 0.07}},
                             5),
                       0.013, 12));
    append(shape, moved(ellipsoid(DVec3(0.03), 20), {side * 0.105, 0.885, 0.0}));
  }
  return shape;
}

Shape arm(double side) {
  const DVec3 shoulder(side * 0.18, 1.4, -0.02);
  const DVec3 elbow(side * 0.215, 1.1, -0.03);
  const DVec3 wrist(side * 0.235, 0.86, 0.02);
  Shape shape = bone(shoulder, elbow, 0.013);
  append(shape, bone(elbow + DVec3(0.009, 0, 0), wrist + DVec3(0.012, 0, 0), 0.008));
  append(shape, bone(elbow - DVec3(0.009, 0, 0), wrist - DVec3(0.012, 0, 0), 0.008));
  append(shape, tube(curve({shoulder + DVec3(0, 0.02, 0.01),
                            {side * 0.1, 1.44, 0.05},
                            {side * 0.015, 1.4, 0.095}},
                           6),
                     0.008, 12));
  const Shape blade = deformed(ellipsoid({0.05, 0.08, 0.007}, 24), [](const DVec3& p) {
    return DVec3(p.x * (1.0 + 6.0 * p.y), p.y, p.z - 3.0 * p.x * p.x);
  });
  append(shape, moved(turned(blade, side * 15.0), {side * 0.115, 1.34, -0.09}));
  for (int i = 0; i < 7; ++i) {
    append(shape, moved(ellipsoid(DVec3(0.009), 10),
                        wrist + DVec3(0.012 * (i % 4 - 1.5), -0.012 - 0.014 * (i / 4), 0.0)));
  }
  for (int finger = 0; finger < 5; ++finger) {
    const bool is_thumb = finger == 4;
    const double spread = is_thumb ? 2.6 : finger - 1.5;
    const double length = is_thumb ? 0.7 : 1.0 - 0.06 * std::abs(finger - 1.0);
    const DVec3 root = wrist + DVec3(0.009 * spread, -0.035, 0.0);
    const auto down = [&](double y) {
      return root + DVec3(0.25 * spread * y, -length * y, 1.2 * y * y + (is_thumb ? 0.4 * y : 0.0));
    };
    add_digit(shape, {root, down(0.06), down(0.1), down(0.13), down(0.15)}, 0.0045);
  }
  return shape;
}

Shape leg(double side) {
  const DVec3 hip(side * 0.11, 0.885, 0.0);
  const DVec3 knee(side * 0.095, 0.48, 0.01);
  const DVec3 ankle(side * 0.09, 0.09, -0.02);
  Shape shape = bone(hip + DVec3(side * 0.03, -0.03, 0.0), knee, 0.017);
  append(shape, bone(hip, hip + DVec3(side * 0.045, -0.035, 0.0), 0.012));
  append(shape, bone(knee - DVec3(0.0, 0.015, 0.0), ankle, 0.015));
  append(shape, bone(knee + DVec3(side * 0.028, -0.03, -0.01),
                     ankle + DVec3(side * 0.022, 0.0, 0.0), 0.007));
  append(shape, moved(ellipsoid({0.02, 0.024, 0.012}, 18), knee + DVec3(0.0, 0.0, 0.035)));
  append(shape, moved(ellipsoid({0.024, 0.028, 0.04}, 20), ankle + DVec3(0.0, -0.035, -0.02)));
  append(shape, moved(ellipsoid({0.026, 0.02, 0.045}, 20), ankle + DVec3(0.0, -0.022, 0.04)));
  for (int toe = 0; toe < 5; ++toe) {
    const double spread = toe - 2.0;
    const double length = 1.0 - 0.06 * std::abs(side * spread + 2.0);
    const DVec3 root = ankle + DVec3(0.01 * spread, -0.03, 0.07);
    const auto ahead = [&](double z) {
      return root + DVec3(0.12 * spread * z, -0.35 * z, length * z);
    };
    add_digit(shape, {root, ahead(0.06), ahead(0.09), ahead(0.11)}, 0.006);
  }
  return shape;
}

Shape stand() {
  Shape shape = tube({{0.0, 0.05, -0.16}, {0.0, 1.72, -0.16}}, 0.011, 14);
  append(
      shape,
      tube(curve({{0.0, 1.72, -0.16}, {0.0, 1.78, -0.15}, {0.0, 1.79, -0.06}, {0.0, 1.74, 0.0}}, 5),
           0.007, 12));
  append(shape, tube({{0.0, 0.95, -0.16}, {0.0, 0.95, -0.04}}, 0.007, 10));
  for (int i = 0; i < 5; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 5.0;
    const DVec3 out(std::sin(angle), 0.0, std::cos(angle));
    const DVec3 hub(0.0, 0.0, -0.16);
    append(shape, tube({hub + DVec3(0.0, 0.09, 0.0), hub + 0.26 * out + DVec3(0.0, 0.06, 0.0)},
                       0.012, 12));
    append(shape, moved(turned(torus(0.018, 0.011, 20, 10), 90.0, {0, 0, 1}),
                        hub + 0.26 * out + DVec3(0.0, 0.029, 0.0)));
  }
  return shape;
}

}  // namespace

void add_skeleton(Model& model, const Materials& m) {
  Skull head = skull();
  const DVec3 head_place(0.0, 1.645, 0.02);
  Shape bones = moved(head.bone, head_place);
  for (const Shape& part :
       {spine(), rib_cage(), pelvis(), arm(-1.0), arm(1.0), leg(-1.0), leg(1.0)}) {
    append(bones, part);
  }
  add_object(
      model, "Skeleton",
      placed({{m.bone, moved(bones, {0.0, 0.04, 0.0}), 60.0},
              {m.black_plastic, moved(moved(head.hollows, head_place), {0.0, 0.04, 0.0}), 60.0},
              {m.steel, stand(), 60.0}},
             {3.75, 0.0, -2.95}, -55.0));
}

}  // namespace foveola::scenes::school
