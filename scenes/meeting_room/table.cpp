// The table and what lies and stands on it.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "scenes/meeting_room/parts.h"

namespace foveola::scenes::meeting {
namespace {

using std::numbers::pi;

struct LaptopPlace {
  double x;
  double z;
  double turn_deg;
  double port_x;  ///< where the plug of its cable is
};
constexpr std::array<LaptopPlace, 4> laptop_places = {{{-2.35, 0.1, -60.0, -1.88},
                                                       {-0.85, -0.5, 185.0, -0.4},
                                                       {0.8, 0.52, 8.0, 1.05},
                                                       {1.7, -0.5, 172.0, 2.18}}};
constexpr DVec3 phone_place(-0.6, table_height, 0.35);

/// Whether something of that radius would touch a laptop or the telephone.
bool is_taken(double x, double z, double radius) {
  const auto near = [&](double other_x, double other_z, double reach) {
    return std::hypot(x - other_x, z - other_z) < radius + reach;
  };
  return near(phone_place.x, phone_place.z, 0.16) ||
         std::any_of(laptop_places.begin(), laptop_places.end(),
                     [&](const LaptopPlace& laptop) { return near(laptop.x, laptop.z, 0.21); });
}

/// The table's outline: a rectangle with bowed sides.
DVec3 on_table(const DVec3& p) {
  const double radius = std::hypot(p.x, p.z);
  if (radius < 1e-9) {
    return p;
  }
  const double exponent = 5.0;
  const double stretch = std::pow(
      std::pow(std::abs(p.x) / radius, exponent) + std::pow(std::abs(p.z) / radius, exponent),
      -1.0 / exponent);
  const double x = p.x * stretch;
  const double bow = 1.0 - 0.18 * x * x;
  return {x * table_half_length, p.y, p.z * stretch * table_half_width * bow};
}

/// A tapered key of a keyboard about the origin.
Shape key_cap(double width, double depth) {
  return deformed(box(DVec3(width, 0.003, depth)), [](const DVec3& p) {
    const double taper = p.y > 0.0 ? 0.86 : 1.0;
    return DVec3(p.x * taper, p.y, p.z * taper);
  });
}

Shape keyboard() {
  constexpr double pitch = 0.0195;
  Shape keys;
  for (int row = 0; row < 5; ++row) {
    const double z = pitch * (row - 2);
    for (int column = 0; column < 14; ++column) {
      append(keys,
             moved(key_cap(0.0165, row == 0 ? 0.011 : 0.0165), {pitch * (column - 6.5), 0.0, z}));
    }
  }
  for (int column = 0; column < 14; ++column) {
    if (column < 4 || column > 8) {
      append(keys, moved(key_cap(0.0165, 0.0165), {pitch * (column - 6.5), 0.0, pitch * 3.0}));
    }
  }
  append(keys, moved(key_cap(0.0945, 0.0165), {pitch * -0.5, 0.0, pitch * 3.0}));
  return keys;
}

Shape with_open_lid(const Shape& lid) {
  return moved(turned(lid, -15.0, {1, 0, 0}), {0.0, 0.016, -0.118});
}

/// A laptop that stands on the origin, its keyboard towards +Z.
std::vector<Part> laptop(const Materials& m) {
  Shape body = moved(rounded_box({0.34, 0.017, 0.24}, 0.006, 3), {0.0, 0.0085, 0.0});
  append(body,
         with_open_lid(moved(rounded_box({0.34, 0.222, 0.008}, 0.0035, 2), {0.0, 0.111, 0.0})));
  Shape dark = moved(turned(cylinder(0.006, 0.24, 12), 90.0, {0, 0, 1}), {0.12, 0.017, -0.119});
  append(dark, moved(keyboard(), {0.0, 0.0182, -0.035}));
  append(dark, with_open_lid(moved(box(DVec3(0.332, 0.212, 0.001)), {0.0, 0.111, 0.0043})));
  Shape pad = moved(box(DVec3(0.1, 0.0012, 0.062)), {0.0, 0.0172, 0.078});
  const Shape mark = with_open_lid(
      moved(turned(lathe({{0.018, 0.0}, {0.016, 0.001}, {0.0, 0.001}}, 24), -90.0, {1, 0, 0}),
            {0.0, 0.115, -0.004}));
  append(pad, mark);
  const Shape screen = with_open_lid(picture({-0.155, 0.016, 0.0052}, {0.31, 0, 0}, {0, 0.194, 0}));
  return {{m.aluminium, body},
          {m.black_plastic, dark, 20.0},
          {m.grey_plastic, pad},
          {m.screen, screen}};
}

Shape tumbler() {
  return lathe({{0.0, 0.004}, {0.026, 0.003}, {0.029, 0.008}, {0.035, 0.11}, {0.0352, 0.112}}, 32);
}

Shape carafe() {
  std::vector<DVec2> outline = {{0.0, 0.004}, {0.05, 0.003}, {0.058, 0.012}};
  for (int i = 0; i <= 14; ++i) {
    const double t = i / 14.0;
    outline.emplace_back(0.059 - 0.032 * std::pow(std::sin(0.5 * pi * t), 3.0) +
                             0.012 * std::max(0.0, t - 0.75) * 4.0,
                         0.02 + 0.23 * t);
  }
  return lathe(outline, 48);
}

/// A pen that lies along X about the origin on y = 0.
Shape pen() {
  const Shape upright = lathe({{0.0, 0.0},
                               {0.001, 0.001},
                               {0.0045, 0.014},
                               {0.005, 0.02},
                               {0.005, 0.128},
                               {0.0043, 0.132},
                               {0.0043, 0.14},
                               {0.0, 0.1405}},
                              12);
  Shape shape = moved(turned(upright, 90.0, {0, 0, 1}), {0.07, 0.005, 0.0});
  append(shape, moved(box(DVec3(0.04, 0.0015, 0.003)), {-0.042, 0.0108, 0.0}));
  return shape;
}

}  // namespace

void add_table(Model& model, const Materials& m) {
  const double h = table_height;
  Shape top = deformed(lathe({{0.0, h - 0.05},
                              {0.5, h - 0.05},
                              {0.97, h - 0.05},
                              {0.985, h - 0.042},
                              {0.995, h - 0.028},
                              {1.0, h - 0.014},
                              {0.998, h - 0.005},
                              {0.994, h - 0.001},
                              {0.988, h},
                              {0.5, h},
                              {0.0, h}},
                             192),
                       on_table);
  top = with_uv_scale(with_projected_uvs(top, {0, 0, 1}, {1, 0, 0}), 0.5);
  Shape legs;
  for (const double x : {-2.3, 0.0, 2.3}) {
    append(legs, moved(rounded_box({0.1, h - 0.08, 0.9}, 0.012, 2), {x, 0.5 * (h - 0.05), 0.0}));
    append(legs, moved(rounded_box({0.18, 0.03, 1.0}, 0.01, 2), {x, 0.015, 0.0}));
  }
  append(legs, moved(rounded_box({4.6, 0.3, 0.05}, 0.01, 2), {0.0, 0.45, 0.0}));
  // Boxes for plugs, let into the top, their lids a little open.
  Shape ports;
  for (const double x : {-1.75, -0.3, 1.15, 2.3}) {
    append(ports, moved(rounded_box({0.26, 0.008, 0.13}, 0.003, 1), {x, h + 0.001, 0.0}));
    append(ports, moved(turned(rounded_box({0.23, 0.006, 0.1}, 0.0025, 1), 6.0, {1, 0, 0}),
                        {x, h + 0.011, 0.0}));
  }
  add_object(model, "Table", {{m.table, top, 30.0}, {m.dark_wood, legs}, {m.aluminium, ports}});
}

void add_laptops(Model& model, const Materials& m) {
  const std::vector<Part> parts = laptop(m);
  int number = 1;
  for (const LaptopPlace& place : laptop_places) {
    std::vector<Part> one = parts;
    for (Part& part : one) {
      part.shape = moved(turned(part.shape, place.turn_deg), {place.x, table_height, place.z});
    }
    // The cable leaves at the laptop's side and winds to the next plug.
    const double angle = radians(place.turn_deg);
    const DVec3 side(std::cos(angle), 0.0, -std::sin(angle));
    const DVec3 from = DVec3(place.x, table_height + 0.009, place.z) + 0.165 * side;
    const DVec3 to(place.port_x, table_height + 0.009, place.z > 0.0 ? 0.05 : -0.05);
    const DVec3 out = from + 0.12 * side;
    std::vector<DVec3> cable;
    for (int i = 0; i <= 24; ++i) {
      const double t = i / 24.0;
      const DVec3 bent = (1 - t) * (1 - t) * (1 - t) * from + 3 * t * (1 - t) * (1 - t) * out +
                         3 * t * t * (1 - t) * (to + DVec3(0.05, 0.0, place.z > 0.0 ? 0.2 : -0.2)) +
                         t * t * t * to;
      const double lying = table_height + 0.0035 + 0.0055 * (std::pow(2.0 * t - 1.0, 6.0));
      cable.emplace_back(bent.x, lying, bent.z);
    }
    one.push_back({m.black_plastic, tube(cable, 0.0028, 7), 60.0});
    add_object(model, fmt::format("Laptop {}", number++), one);
  }
}

Cup make_cup() {
  Cup cup;
  cup.porcelain = lathe({{0.0, 0.0},
                         {0.03, 0.001},
                         {0.05, 0.008},
                         {0.072, 0.016},
                         {0.074, 0.018},
                         {0.072, 0.02},
                         {0.05, 0.0125},
                         {0.03, 0.006},
                         {0.0, 0.005}},
                        32);
  append(cup.porcelain, moved(lathe({{0.0, 0.006},
                                     {0.023, 0.006},
                                     {0.0235, 0.01},
                                     {0.034, 0.025},
                                     {0.04, 0.045},
                                     {0.042, 0.07},
                                     {0.0415, 0.0715},
                                     {0.04, 0.07},
                                     {0.038, 0.045},
                                     {0.032, 0.027},
                                     {0.0, 0.012}},
                                    32),
                              {0.0, 0.0, 0.0}));
  std::vector<DVec3> handle;
  for (int i = 0; i <= 10; ++i) {
    const double angle = pi * (i / 10.0 - 0.5);
    handle.emplace_back(0.036 + 0.026 * std::cos(angle), 0.042 + 0.019 * std::sin(angle), 0.0);
  }
  append(cup.porcelain, scaled(tube(handle, 0.0042, 8), {1.0, 1.0, 1.4}));
  cup.coffee = lathe({{0.0392, 0.058}, {0.0, 0.058}}, 24);
  return cup;
}

Shape make_jug() {
  Shape jug = lathe({{0.0, 0.0},
                     {0.068, 0.0},
                     {0.073, 0.004},
                     {0.085, 0.02},
                     {0.091, 0.06},
                     {0.089, 0.1},
                     {0.078, 0.145},
                     {0.064, 0.18},
                     {0.056, 0.205},
                     {0.055, 0.22},
                     {0.06, 0.235},
                     {0.06, 0.25},
                     {0.05, 0.262},
                     {0.02, 0.268},
                     {0.018, 0.28},
                     {0.0, 0.282}},
                    48);
  std::vector<DVec3> handle;
  for (int i = 0; i <= 14; ++i) {
    const double angle = pi * (i / 14.0 - 0.5);
    handle.emplace_back(0.055 + 0.07 * std::cos(angle), 0.145 + 0.085 * std::sin(angle), 0.0);
  }
  append(jug, tube(handle, 0.009, 10));
  append(jug, moved(turned(cone(0.018, 0.006, 0.05, 14), 62.0, {0, 0, 1}), {-0.045, 0.225, 0.0}));
  return jug;
}

void add_tableware(Model& model, const Materials& m) {
  const Cup cup = make_cup();
  Shape cups;
  Shape coffee;
  Shape glasses;
  for (int i = 0; i < seats_along_table; ++i) {
    for (const double side : {-1.0, 1.0}) {
      const double edge = 0.45 - 0.03 * std::abs(i - 3);
      const double turn_deg = 50.0 * std::sin(3.3 * i + side);
      const DVec3 place(seat_x(i) + 0.22, table_height, side * edge);
      if (!is_taken(place.x, place.z, 0.08)) {
        append(cups, moved(turned(cup.porcelain, turn_deg), place));
        append(coffee, moved(cup.coffee, place));
      }
      if (!is_taken(seat_x(i) + 0.06, side * (edge - 0.13), 0.04)) {
        append(glasses, moved(tumbler(), {seat_x(i) + 0.06, table_height, side * (edge - 0.13)}));
      }
    }
  }
  add_object(model, "Cups", {{m.porcelain, cups, 50.0}, {m.coffee, coffee}});
  add_object(model, "Glasses", {{m.glass, glasses, 50.0}});
  const Shape jug = make_jug();
  add_object(model, "Jugs",
             {{m.chrome, moved(turned(jug, 40.0), {-1.2, table_height, 0.0}), 50.0},
              {m.chrome, moved(turned(jug, 200.0), {1.5, table_height, 0.05}), 50.0}});
  const Shape water = lathe({{0.0575, 0.12}, {0.0, 0.12}}, 40);
  Shape vessels;
  Shape surfaces;
  for (const double x : {-1.45, 0.55, 1.95}) {
    append(vessels, moved(carafe(), {x, table_height, -0.12}));
    append(surfaces, moved(scaled(water, {0.86, 1.0, 0.86}), {x, table_height, -0.12}));
  }
  add_object(model, "Carafes", {{m.glass, vessels, 50.0}, {m.glass, surfaces}});
}

void add_papers(Model& model, const Materials& m) {
  Shape blocks;
  Shape wires;
  Shape pages;
  Shape pens;
  const Shape block = moved(box(DVec3(0.21, 0.009, 0.297)), {0.0, 0.0045, 0.0});
  Shape wire;
  for (int i = 0; i < 16; ++i) {
    append(wire, moved(turned(torus(0.0075, 0.0009, 10, 4), 90.0, {0, 0, 1}),
                       {0.0125 * (i - 7.5), 0.006, -0.147}));
  }
  const auto sheet = [](double y) {
    return picture({-0.105, y, 0.1485}, {0.21, 0, 0}, {0, 0, -0.297});
  };
  for (int i = 0; i < seats_along_table; ++i) {
    for (const double side : {-1.0, 1.0}) {
      const double turn_deg = 10.0 * std::sin(4.1 * i + side) + (side > 0.0 ? 0.0 : 180.0);
      const auto put = [&](const Shape& shape, const DVec3& offset) {
        return moved(turned(moved(shape, offset), turn_deg),
                     {seat_x(i) - 0.1, table_height, side * 0.58});
      };
      if (is_taken(seat_x(i) - 0.1, side * 0.58, 0.18)) {
        continue;
      }
      append(blocks, put(block, DVec3(0.0)));
      append(wires, put(wire, DVec3(0.0)));
      append(pages, put(sheet(0.0094), DVec3(0.0)));
      append(pens, put(turned(pen(), 70.0 + 25.0 * std::sin(5.0 * i + side)),
                       {0.03 * std::sin(2.0 * i), 0.0095, 0.02}));
    }
  }
  // Loose sheets that were handed round.
  constexpr double thickness = 0.0006;
  Shape loose;
  for (int i = 0; i < 9; ++i) {
    const double turn_deg = 25.0 * std::sin(3.9 * i);
    const DVec3 place(-2.9 + 0.6 * i + 0.1 * std::sin(5.0 * i),
                      table_height + 0.0015 + 3.0 * thickness * (i % 2),
                      (i % 2 == 0 ? 0.2 : -0.25) + 0.04 * std::sin(2.2 * i));
    append(pages, moved(turned(sheet(thickness), turn_deg), place));
    append(loose,
           moved(turned(moved(box(DVec3(0.21, thickness, 0.297)), {0.0, 0.4 * thickness, 0.0}),
                        turn_deg),
                 place));
  }
  append(blocks, loose);
  add_object(model, "Notepads", {{m.paper, blocks}, {m.page, pages}, {m.chrome, wires, 60.0}});
  add_object(model, "Pens", {{m.blue, pens, 40.0}});
}

void add_conference_phone(Model& model, const Materials& m) {
  // Three arms that swell out of a round body.
  std::vector<DVec2> outline = {{0.0, 0.0}, {0.92, 0.0}, {0.98, 0.006}, {1.0, 0.014}};
  for (int i = 1; i <= 10; ++i) {
    const double angle = 0.5 * pi * i / 10.0;
    outline.emplace_back(std::cos(angle), 0.014 + 0.042 * std::sin(angle));
  }
  const Shape body = deformed(lathe(outline, 72), [](const DVec3& p) {
    const double arms =
        0.105 + 0.05 * std::pow(std::abs(std::cos(1.5 * std::atan2(p.x, p.z))), 1.6);
    return DVec3(p.x * arms, p.y, p.z * arms);
  });
  Shape keys;
  for (int row = 0; row < 4; ++row) {
    for (int column = -1; column <= 1; ++column) {
      append(keys, moved(rounded_box({0.013, 0.006, 0.009}, 0.0025, 2),
                         {0.018 * column, 0.054 - 0.001 * row, 0.012 * row}));
    }
  }
  const Shape display = moved(turned(rounded_box({0.062, 0.005, 0.028}, 0.002, 1), 6.0, {1, 0, 0}),
                              {0.0, 0.054, -0.028});

  std::vector<DVec3> cable;
  for (int i = 0; i <= 20; ++i) {
    const double t = i / 20.0;
    cable.emplace_back(0.02 + 0.18 * t, 0.0035, -0.1 - 0.2 * t + 0.03 * std::sin(6.0 * t));
  }
  add_object(model, "Conference phone",
             moved({{m.black_plastic, body, 50.0},
                    {m.grey_plastic, keys},
                    {m.screen, with_uv_scale(display, 4.0)},
                    {m.black_plastic, tube(cable, 0.003, 7), 60.0}},
                   phone_place));
}

}  // namespace foveola::scenes::meeting
