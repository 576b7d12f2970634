#include "scenes/studio_car/car.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "scenes/modelling/props.h"

namespace foveola::scenes {
namespace {

constexpr double half_length = 2.2;
constexpr double half_width = 0.9;
constexpr double underside = 0.17;
constexpr double sill = 0.23;
constexpr double wheel_radius = 0.33;
constexpr double wheel_arch_radius = 0.385;
constexpr double front_axle = 1.36;
constexpr double rear_axle = -1.32;
constexpr double wheel_middle_z = 0.775;
constexpr double tyre_half_width = 0.105;

/// sign(x) |x|^exponent.
double signed_power(double x, double exponent) {
  return std::copysign(std::pow(std::abs(x), exponent), x);
}

/// How much a superellipse of unit radii and `exponent` has left across at x.
double superellipse(double x, double exponent) {
  return std::pow(std::max(0.0, 1.0 - std::pow(std::abs(x), exponent)), 1.0 / exponent);
}

double smooth_step(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// The height of bonnet, shoulder and boot along the middle of the car.
double top_line(double x) {
  const double bonnet = std::lerp(0.9, 0.68, smooth_step(0.7, 2.3, x));
  const double boot = 0.06 * smooth_step(0.5, -1.3, x) - 0.1 * smooth_step(-1.7, -2.3, x);
  return bonnet + boot;
}

/// The body's cross-section at x: a superellipse about (y = middle, z = 0).
struct Section {
  double middle;
  double half_height;
  double half_width;
};

Section section_at(double x) {
  const double q = x / half_length;
  const double height_left = superellipse(q, 7.0);
  const double bottom = underside + 0.33 * (1.0 - height_left);
  const double top = 0.5 + (top_line(x) - 0.5) * height_left;
  return {.middle = 0.5 * (top + bottom),
          .half_height = 0.5 * (top - bottom),
          .half_width = half_width * superellipse(q, 4.5)};
}

constexpr double section_exponent = 2.0 / 3.4;

/// A point of the body: angle 0 is the widest point at +Z, a quarter turn the top.
DVec3 body_point(double x, double angle) {
  const Section section = section_at(x);
  return {x, section.middle + section.half_height * signed_power(std::sin(angle), section_exponent),
          section.half_width * signed_power(std::cos(angle), section_exponent)};
}

/// The angle at which the section at x is `height` high on its +Z side.
double angle_at_height(double x, double height) {
  const Section section = section_at(x);
  const double relative =
      section.half_height > 0.0 ? (height - section.middle) / section.half_height : 0.0;
  return std::asin(signed_power(std::clamp(relative, -1.0, 1.0), 1.0 / section_exponent));
}

/// The lower edge of the body's side: the sill, and the arches over the wheels.
double lower_edge(double x) {
  for (const double axle : {front_axle, rear_axle}) {
    const double from_axle = std::abs(x - axle);
    if (from_axle < wheel_arch_radius) {
      return wheel_radius +
             std::sqrt(wheel_arch_radius * wheel_arch_radius - from_axle * from_axle);
    }
  }
  return sill;
}

/// Stations along the car: dense at its round ends and around the wheel arches, whose ends they
/// hit.
std::vector<double> stations() {
  std::vector<double> result;
  constexpr int steps = 120;
  for (int i = 0; i <= steps; ++i) {
    const double angle = std::numbers::pi * (static_cast<double>(i) / steps - 0.5);
    result.push_back(half_length * std::sin(angle));
  }
  constexpr int arch_steps = 24;
  for (const double axle : {front_axle, rear_axle}) {
    for (int i = 0; i <= arch_steps; ++i) {
      const double angle = std::numbers::pi * (static_cast<double>(i) / arch_steps - 0.5);
      result.push_back(axle + 0.9999 * wheel_arch_radius * std::sin(angle));
    }
    result.push_back(axle - 1.001 * wheel_arch_radius);
    result.push_back(axle + 1.001 * wheel_arch_radius);
  }
  std::sort(result.begin(), result.end());
  return result;
}

Shape body() {
  const std::vector<double> xs = stations();
  const int columns = static_cast<int>(xs.size()) - 1;
  return patch(columns, 64, [&](double u, double v) {
    const double x = xs[static_cast<std::size_t>(std::lround(u * columns))];
    const double from = angle_at_height(x, lower_edge(x));
    return body_point(x, std::lerp(from, std::numbers::pi - from, v));
  });
}

/// The shape's triangles for whose middle `is_inside` holds, and the others.
std::pair<Shape, Shape> split(const Shape& shape,
                              const std::function<bool(const DVec2& uv)>& is_inside) {
  Shape inside = shape;
  Shape outside = shape;
  inside.triangles.clear();
  outside.triangles.clear();
  for (const auto& triangle : shape.triangles) {
    const DVec2 middle =
        (shape.uvs[triangle[0]] + shape.uvs[triangle[1]] + shape.uvs[triangle[2]]) / 3.0;
    (is_inside(middle) ? inside : outside).triangles.push_back(triangle);
  }
  return {inside, outside};
}

constexpr int cabin_wall_rows = 20;
constexpr int cabin_roof_rows = 16;
constexpr int cabin_rows = cabin_wall_rows + cabin_roof_rows;

/// A point of the cabin's ring at height fraction t of its walls, shrunk by `scale` about its
/// middle; angle 0 is +X, a quarter turn +Z.
DVec3 cabin_point(double angle, double t, double scale) {
  const double lean = std::pow(t, 1.25);
  const double front = std::lerp(1.12, 0.3, lean);
  const double rear = std::lerp(-1.8, -1.0, lean);
  const double width = std::lerp(0.78, 0.57, lean);
  const double radius =
      std::pow(std::pow(std::abs(std::cos(angle)), 4.5) + std::pow(std::abs(std::sin(angle)), 4.5),
               -1.0 / 4.5);
  const double roof = 0.1 * (1.0 - scale * scale * scale);
  return {0.5 * (front + rear) + 0.5 * (front - rear) * radius * scale * std::cos(angle),
          std::lerp(0.82, 1.3, t) + roof, width * radius * scale * std::sin(angle)};
}

Shape cabin() {
  return patch(120, cabin_rows, [](double u, double v) {
    const double row = v * cabin_rows;
    const double t = std::min(1.0, row / cabin_wall_rows);
    const double scale = std::min(1.0, (cabin_rows - row) / cabin_roof_rows);
    return cabin_point(-2.0 * std::numbers::pi * u, t, scale);
  });
}

bool is_window(const DVec2& uv) {
  const double row = uv.y * cabin_rows;
  if (row < 0.15 * cabin_wall_rows || row > 0.9 * cabin_wall_rows) {
    return false;
  }
  // Degrees from the nose, the same on both sides of the car.
  const double angle_deg = 180.0 - std::abs(180.0 - 360.0 * uv.x);
  const bool windscreen = angle_deg < 39.0;
  const bool front_window = angle_deg > 51.0 && angle_deg < 87.0;
  const bool rear_window = angle_deg > 93.0 && angle_deg < 129.0;
  const bool back_window = angle_deg > 144.0;
  return windscreen || front_window || rear_window || back_window;
}

Shape on_both_sides(const Shape& shape) {
  Shape both = shape;
  append(both, scaled(shape, {1.0, 1.0, -1.0}));
  return both;
}

/// Gaps around the door, as thin dark lines sunk into the body.
Shape door_lines() {
  Shape lines;
  for (const double x : {0.8, -0.2, -0.86}) {
    std::vector<DVec3> path;
    for (int i = 0; i <= 12; ++i) {
      path.push_back(body_point(x, angle_at_height(x, std::lerp(0.26, 0.82, i / 12.0))));
    }
    append(lines, tube(path, 0.004, 6));
  }
  return on_both_sides(lines);
}

Shape rim() {
  Shape shape = lathe({{0.24, 0.1},
                       {0.225, 0.108},
                       {0.21, 0.1},
                       {0.2, 0.06},
                       {0.195, -0.05},
                       {0.16, -0.055},
                       {0.0, -0.055}},
                      64);
  for (int i = 0; i < 5; ++i) {
    for (const double side : {-1.0, 1.0}) {
      const Shape spoke = moved(turned(rounded_box({0.032, 0.03, 0.19}, 0.012, 2), 8.0 * side),
                                {side * 0.022, 0.07, 0.115});
      append(shape, turned(spoke, 72.0 * i));
    }
  }
  append(shape, moved(cylinder(0.05, 0.05, 32), {0.0, 0.04, 0.0}));
  return shape;
}

void add_wheels(Model& model, const CarMaterials& m, double ground) {
  const Shape brake = moved(cylinder(0.14, 0.02, 40), {0.0, -0.03, 0.0});
  struct Wheel {
    const char* name;
    double x;
    double side;
  };
  for (const Wheel& wheel :
       {Wheel{"Front wheel", front_axle, 1.0}, Wheel{"Rear wheel", rear_axle, 1.0},
        Wheel{"Far front wheel", front_axle, -1.0}, Wheel{"Far rear wheel", rear_axle, -1.0}}) {
    const auto put = [&](const Shape& shape) {
      return moved(turned(shape, 90.0 * wheel.side, {1, 0, 0}),
                   {wheel.x, ground + wheel_radius, wheel.side * wheel_middle_z});
    };
    const Shape standing_tyre = moved(tyre(), {0.0, -tyre_half_width, 0.0});
    add_object(model, wheel.name,
               {{m.rubber, put(standing_tyre), 35.0},
                {m.alloy, put(rim()), 40.0},
                {m.chrome, put(brake)}});
  }
}

void add_fittings(Model& model, const CarMaterials& m, const DVec3& place) {
  Shape black = moved(rounded_box({3.9, 0.5, 1.3}, 0.1, 3), {0.0, 0.45, 0.0});
  append(black, moved(rounded_box({0.12, 0.15, 0.76}, 0.04, 3), {2.155, 0.47, 0.0}));
  append(black, moved(rounded_box({0.12, 0.1, 1.1}, 0.04, 3), {2.12, 0.3, 0.0}));
  append(black, moved(rounded_box({0.12, 0.16, 1.0}, 0.04, 3), {-2.13, 0.36, 0.0}));
  append(black, door_lines());
  add_object(model, "Car underbody and grille", moved({{m.black_plastic, black, 50.0}}, place));
  Shape chrome;
  for (int i = 0; i < 5; ++i) {
    append(chrome, moved(box(DVec3(0.03, 0.008, 0.7)), {2.21, 0.42 + 0.025 * i, 0.0}));
  }
  append(chrome, moved(box(DVec3(0.02, 0.11, 0.5)), {-2.195, 0.55, 0.0}));
  for (const double x : {-0.08, -0.75}) {
    append(chrome, on_both_sides(moved(ellipsoid({0.1, 0.016, 0.02}, 20), {x, 0.74, 0.9})));
  }
  add_object(model, "Car trim", moved({{m.chrome, chrome, 50.0}}, place));
  const Shape headlight =
      moved(turned(ellipsoid({0.12, 0.075, 0.19}, 40), 32.0), {1.98, 0.58, 0.6});
  add_object(model, "Headlights", moved({{m.headlight, on_both_sides(headlight), 60.0}}, place));
  const Shape tail_light =
      moved(turned(ellipsoid({0.1, 0.07, 0.2}, 32), -28.0), {-2.05, 0.72, 0.58});
  add_object(model, "Tail lights", moved({{m.tail_light, on_both_sides(tail_light), 60.0}}, place));
  Shape mirrors = moved(ellipsoid({0.07, 0.065, 0.115}, 32), {0.78, 0.97, 0.93});
  append(mirrors, tube({{0.78, 0.88, 0.76}, {0.78, 0.94, 0.88}}, 0.02, 10));
  add_object(model, "Car mirrors", moved({{m.paint, on_both_sides(mirrors), 60.0}}, place));
}

}  // namespace

Shape tyre() {
  constexpr double w = tyre_half_width;
  const std::vector<DVec2> side = {{0.215, 0.0},   {0.23, -0.003}, {0.25, -0.005}, {0.28, -0.004},
                                   {0.305, 0.006}, {0.32, 0.018},  {0.328, 0.035}, {0.33, 0.05}};
  std::vector<DVec2> outline = side;
  // Three grooves around the tread.
  for (int i = -1; i <= 1; ++i) {
    const double groove = w + 0.03 * i;
    outline.insert(outline.end(), {{0.33, groove - 0.006},
                                   {0.322, groove - 0.005},
                                   {0.322, groove + 0.005},
                                   {0.33, groove + 0.006}});
  }
  for (auto point = side.rbegin(); point != side.rend(); ++point) {
    outline.emplace_back(point->x, 2.0 * w - point->y);
  }
  outline.push_back(side.front());
  return lathe(outline, 64);
}

void add_car(Model& model, const CarMaterials& materials, double ground) {
  const DVec3 place(0.0, ground, 0.0);
  const auto [windows, roof_and_pillars] = split(cabin(), is_window);
  add_object(
      model, "Car body",
      moved({{materials.paint, body(), 50.0}, {materials.paint, roof_and_pillars, 60.0}}, place));
  add_object(model, "Car windows", moved({{materials.glass, windows, 60.0}}, place));
  add_wheels(model, materials, ground);
  add_fittings(model, materials, place);
}

}  // namespace foveola::scenes
