#include <cmath>

#include <fmt/format.h>

#include "scenes/studio_car/studio.h"

namespace foveola::scenes::studio {
namespace {

/// A combination spanner lying along X.
Shape spanner(double length) {
  Shape shape = rounded_box({length - 0.04, 0.005, 0.011}, 0.002, 1);
  append(shape, moved(torus(0.011, 0.0042, 20, 6), {0.5 * length - 0.012, 0.0, 0.0}));
  for (const double side : {-1.0, 1.0}) {
    const Shape jaw = turned(rounded_box({0.026, 0.006, 0.008}, 0.002, 1), 14.0 * side);
    append(shape, moved(jaw, {-0.5 * length + 0.012, 0.0, 0.0095 * side}));
  }
  return shape;
}

Shape screwdriver_handle() {
  return turned(lathe({{0.0, 0.0},
                       {0.011, 0.001},
                       {0.015, 0.012},
                       {0.016, 0.06},
                       {0.012, 0.075},
                       {0.015, 0.09},
                       {0.01, 0.1},
                       {0.0, 0.1}},
                      20),
                90.0, {0, 0, 1});
}

Shape can(double radius, double height) {
  return lathe({{0.0, 0.0},
                {radius * 0.94, 0.0},
                {radius, 0.006},
                {radius, height - 0.03},
                {radius * 0.8, height - 0.008},
                {radius * 0.45, height},
                {radius * 0.4, height + 0.03},
                {0.0, height + 0.032}},
               36);
}

struct CaseParts {
  Shape panels;
  Shape edges;
  Shape wheels;
};

/// A flight case that stands on castors over the origin.
CaseParts flight_case(const DVec3& size) {
  constexpr double castor_height = 0.11;
  const double middle = castor_height + 0.5 * size.y;
  CaseParts parts;
  parts.panels = moved(rounded_box(size, 0.008, 2), {0.0, middle, 0.0});
  const DVec3 half = 0.5 * size;
  constexpr double edge = 0.032;
  for (const double a : {-1.0, 1.0}) {
    for (const double b : {-1.0, 1.0}) {
      const auto rail = [&](const DVec3& length, const DVec3& at) {
        append(parts.edges, moved(rounded_box(length, 0.006, 1), at + DVec3(0.0, middle, 0.0)));
      };
      rail({size.x - 0.06, edge, edge}, {0.0, a * (half.y - 0.011), b * (half.z - 0.011)});
      rail({edge, size.y - 0.06, edge}, {a * (half.x - 0.011), 0.0, b * (half.z - 0.011)});
      rail({edge, edge, size.z - 0.06}, {a * (half.x - 0.011), b * (half.y - 0.011), 0.0});
      for (const double c : {-1.0, 1.0}) {
        append(parts.edges, moved(ellipsoid(DVec3(0.04), 16),
                                  DVec3(a, b, c) * (half - 0.022) + DVec3(0.0, middle, 0.0)));
      }
      const Castor wheel = castor(castor_height);
      const DVec3 foot(a * (half.x - 0.09), 0.0, b * (half.z - 0.09));
      append(parts.edges, moved(wheel.fork, foot));
      append(parts.wheels, moved(wheel.wheel, foot));
    }
    // The lid's seam, two catches and a handle on each long side.
    append(parts.edges, moved(rounded_box({0.012, 0.024, size.z - 0.07}, 0.004, 2),
                              {a * (half.x + 0.001), middle + 0.25 * size.y, 0.0}));
    for (const double at : {-0.3, 0.3}) {
      append(parts.edges, moved(rounded_box({0.02, 0.11, 0.1}, 0.006, 2),
                                {a * (half.x + 0.006), middle + 0.25 * size.y, at * size.z}));
      append(
          parts.edges,
          moved(turned(lathe({{0.0, 0.0}, {0.03, 0.0}, {0.03, 0.008}, {0.025, 0.011}, {0.0, 0.011}},
                             28),
                       -90.0 * a, {0, 0, 1}),
                {a * (half.x + 0.015), middle + 0.25 * size.y - 0.01, at * size.z}));
    }
    append(parts.edges, moved(rounded_box({0.012, 0.12, 0.17}, 0.005, 2),
                              {a * (half.x + 0.003), middle - 0.08, 0.0}));
    append(parts.wheels, tube({{a * (half.x + 0.01), middle - 0.05, -0.055},
                               {a * (half.x + 0.025), middle - 0.1, -0.05},
                               {a * (half.x + 0.025), middle - 0.1, 0.05},
                               {a * (half.x + 0.01), middle - 0.05, 0.055}},
                              0.009, 10));
  }
  return parts;
}

}  // namespace

std::vector<Part> placed(std::vector<Part> parts, double turn_deg, const DVec3& place) {
  for (Part& part : parts) {
    part.shape = moved(turned(std::move(part.shape), turn_deg), place);
  }
  return parts;
}

Castor castor(double height) {
  const double radius = 0.42 * height;
  Castor result;
  result.wheel = moved(turned(lathe({{0.0, -0.016},
                                     {0.7 * radius, -0.016},
                                     {0.92 * radius, -0.014},
                                     {radius, -0.007},
                                     {radius, 0.007},
                                     {0.92 * radius, 0.014},
                                     {0.7 * radius, 0.016},
                                     {0.0, 0.016}},
                                    24),
                              90.0, {1, 0, 0}),
                       {0.0, radius, 0.0});
  for (const double z : {-0.021, 0.021}) {
    append(result.fork, moved(rounded_box({0.03, height - radius + 0.01, 0.004}, 0.0018, 1),
                              {0.0, 0.5 * (height + radius) - 0.005, z}));
  }
  append(result.fork,
         moved(rounded_box({0.07, 0.008, 0.06}, 0.003, 2), {0.0, height - 0.004, 0.0}));
  append(result.fork, tube({{0.0, radius, -0.026}, {0.0, radius, 0.026}}, 0.006, 12));
  return result;
}

void add_tool_trolley(Model& model, const Materials& m, const DVec3& place, double turn_deg) {
  Shape lacquer = moved(rounded_box({0.76, 0.74, 0.44}, 0.012, 3), {0.0, 0.5, 0.0});
  Shape metal;
  Shape dark;
  double y = 0.16;
  for (const double height : {0.17, 0.14, 0.11, 0.09, 0.09, 0.08}) {
    append(lacquer, moved(rounded_box({0.7, height - 0.008, 0.03}, 0.008, 2),
                          {0.0, y + 0.5 * height, 0.222}));
    append(metal,
           moved(rounded_box({0.62, 0.014, 0.022}, 0.006, 2), {0.0, y + height - 0.022, 0.246}));
    append(dark,
           moved(rounded_box({0.09, 0.022, 0.003}, 0.001, 1), {-0.24, y + 0.45 * height, 0.2385}));
    y += height;
  }
  for (const double x : {-0.3, 0.3}) {
    for (const double z : {-0.15, 0.15}) {
      const Castor wheel = castor(0.132);
      append(metal, moved(wheel.fork, {x, 0.0, z}));
      append(dark, moved(wheel.wheel, {x, 0.0, z}));
    }
  }
  append(metal, tube({{-0.375, 0.8, -0.15},
                      {-0.43, 0.83, -0.15},
                      {-0.45, 0.84, -0.13},
                      {-0.45, 0.84, 0.13},
                      {-0.43, 0.83, 0.15},
                      {-0.375, 0.8, 0.15}},
                     0.012, 14));
  // The tray on top: a mat within a rim.
  constexpr double top = 0.87;
  append(dark, moved(rounded_box({0.7, 0.006, 0.38}, 0.002, 2), {0.0, top + 0.003, 0.0}));
  for (const double side : {-1.0, 1.0}) {
    append(lacquer,
           moved(rounded_box({0.76, 0.03, 0.02}, 0.006, 2), {0.0, top + 0.01, 0.21 * side}));
    append(lacquer,
           moved(rounded_box({0.02, 0.03, 0.41}, 0.006, 2), {0.37 * side, top + 0.01, 0.0}));
  }
  for (int i = 0; i < 6; ++i) {
    append(metal, moved(turned(spanner(0.15 + 0.02 * i), 86.0 + 2.0 * i),
                        {-0.3 + 0.045 * i, top + 0.01, 0.02}));
  }
  for (int i = 0; i < 3; ++i) {
    const DVec3 at(0.1, top + 0.022, -0.11 + 0.06 * i);
    append(lacquer, moved(screwdriver_handle(), at));
    append(metal, tube({at, at + DVec3(0.14, 0.0, 0.0)}, 0.0035, 10));
  }
  append(metal, moved(can(0.032, 0.17), {0.3, top + 0.006, -0.12}));
  append(dark, moved(can(0.034, 0.2), {0.29, top + 0.006, 0.12}));
  add_object(
      model, "Tool trolley",
      placed(
          {{m.red_lacquer, lacquer, 45.0}, {m.aluminium, metal, 45.0}, {m.car.rubber, dark, 45.0}},
          turn_deg, place));
}

void add_workbench(Model& model, const Materials& m) {
  const DVec3 place(1.5, 0.0, half_room - 0.5);
  Shape board = moved(rounded_box({3.0, 0.05, 0.8}, 0.01, 3), {0.0, 0.885, 0.0});
  append(board, moved(rounded_box({2.8, 0.025, 0.6}, 0.006, 2), {0.0, 0.28, 0.05}));
  append(board, moved(rounded_box({2.8, 0.9, 0.02}, 0.004, 2), {0.0, 1.55, 0.46}));
  Shape legs;
  for (const double x : {-1.4, 0.0, 1.4}) {
    for (const double z : {-0.34, 0.34}) {
      append(legs, moved(rounded_box({0.06, 0.86, 0.06}, 0.006, 2), {x, 0.43, z}));
    }
    append(legs, moved(rounded_box({0.04, 0.04, 0.64}, 0.006, 2), {x, 0.245, 0.0}));
  }
  Shape tools;
  Shape handles;
  for (int i = 0; i < 12; ++i) {
    const double x = -1.2 + 0.13 * i;
    append(tools, moved(turned(turned(spanner(0.16 + 0.015 * i), 90.0, {1, 0, 0}), 90.0, {0, 0, 1}),
                        {x, 1.7, 0.445}));
  }
  for (int i = 0; i < 8; ++i) {
    const DVec3 at(0.5 + 0.1 * i, 1.75, 0.43);
    append(handles, moved(turned(screwdriver_handle(), -90.0, {0, 0, 1}), at));
    append(tools, tube({at, at - DVec3(0.0, 0.12, 0.0)}, 0.004, 10));
  }
  // A vice, cans and two crates.
  append(tools, moved(rounded_box({0.16, 0.1, 0.2}, 0.02, 3), {-1.2, 0.96, -0.2}));
  append(tools, moved(rounded_box({0.18, 0.07, 0.05}, 0.01, 3), {-1.2, 1.035, -0.33}));
  append(tools, tube({{-1.2, 0.96, -0.28}, {-1.2, 0.96, -0.46}}, 0.018, 20));
  append(tools, tube({{-1.3, 0.96, -0.45}, {-1.1, 0.96, -0.45}}, 0.008, 12));
  for (int i = 0; i < 5; ++i) {
    append(tools,
           moved(can(0.035 + 0.006 * (i % 3), 0.14 + 0.03 * (i % 2)), {0.3 + 0.12 * i, 0.91, 0.2}));
  }
  append(handles, moved(rounded_box({0.5, 0.24, 0.26}, 0.02, 4), {1.0, 1.031, -0.05}));
  append(handles, moved(rounded_box({0.6, 0.3, 0.4}, 0.02, 4), {-0.6, 0.443, 0.05}));
  append(tools,
         tube({{0.86, 1.15, -0.05}, {0.88, 1.2, -0.05}, {1.12, 1.2, -0.05}, {1.14, 1.15, -0.05}},
              0.01, 12));
  add_object(model, "Workbench",
             moved({{m.wood, with_uv_scale(board, 0.7), 45.0},
                    {m.black_steel, legs, 45.0},
                    {m.steel, tools, 45.0},
                    {m.red_lacquer, handles, 45.0}},
                   place));
}

void add_flight_cases(Model& model, const Materials& m) {
  for (int i = 0; i < 3; ++i) {
    const CaseParts parts = flight_case({0.7, 0.42 + 0.2 * i, 1.0});
    add_object(model, fmt::format("Flight case {}", i + 1),
               placed({{m.black_laminate, with_uv_scale(parts.panels, 2.0), 45.0},
                       {m.aluminium, parts.edges, 45.0},
                       {m.car.rubber, parts.wheels, 50.0}},
                      4.0 * i - 5.0, {6.9, 0.0, -1.0 + 1.3 * i}));
  }
}

}  // namespace foveola::scenes::studio
