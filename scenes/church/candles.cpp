#include "scenes/church/candles.h"

#include <cmath>
#include <numbers>
#include <string>

#include "renderer/base/angles.h"
#include "renderer/base/random.h"

namespace foveola::scenes::church {
namespace {

using std::numbers::pi;

DVec3 around(double angle, double radius, double height) {
  return {radius * std::sin(angle), height, radius * std::cos(angle)};
}

/// A pan that catches wax, standing on the origin, with the socket of a candle.
Shape drip_pan(double radius) {
  return lathe({{0.0, 0.0},
                {0.25 * radius, 0.0},
                {0.9 * radius, 0.25 * radius},
                {radius, 0.45 * radius},
                {0.9 * radius, 0.4 * radius},
                {0.35 * radius, 0.15 * radius},
                {0.35 * radius, 0.7 * radius},
                {0.0, 0.7 * radius}},
               10);
}

/// One tier of a chandelier: arms that swing down and up again from a stem on the Y axis.
void add_tier(Candles& candles, const DVec3& middle, int arms, double reach, double first_deg) {
  for (int i = 0; i < arms; ++i) {
    const double angle = radians(first_deg) + 2.0 * pi * i / arms;
    std::vector<DVec3> arm;
    constexpr int steps = 10;
    for (int k = 0; k <= steps; ++k) {
      // Arms begin inside the stem, but not in one point.
      const double t = 0.02 + 0.98 * k / steps;
      const double dip = -0.2 * std::sin(2.0 * pi * 0.75 * t) + 0.02 * t;
      arm.push_back(middle + around(angle, reach * t, reach * dip));
    }
    append(candles.brass, tube(arm, 0.014, 6));
    const DVec3 end = arm.back() - DVec3(0.0, 0.01, 0.0);
    append(candles.brass, moved(drip_pan(0.07), end));
    append(candles.brass,
           moved(torus(0.05, 0.01, 10, 5), middle + around(angle, 0.45 * reach, -0.08 * reach)));
    candles.add_candle(end + DVec3(0.0, 0.045, 0.0), 0.017, 0.2);
  }
}

/// A brass chandelier of two tiers whose lower ball hangs at the origin, with its chain.
Candles chandelier(double chain_length) {
  Candles candles;
  candles.brass = lathe(
      {{0.0, -0.36}, {0.03, -0.34}, {0.05, -0.3},  {0.02, -0.26}, {0.06, -0.22}, {0.14, -0.14},
       {0.175, 0.0}, {0.14, 0.12},  {0.06, 0.19},  {0.045, 0.26}, {0.09, 0.3},   {0.045, 0.36},
       {0.035, 0.5}, {0.07, 0.56},  {0.11, 0.64},  {0.07, 0.73},  {0.035, 0.78}, {0.03, 0.98},
       {0.06, 1.03}, {0.03, 1.1},   {0.015, 1.16}, {0.0, 1.16}},
      16);
  add_tier(candles, {0.0, 0.3, 0.0}, 8, 0.95, 0.0);
  add_tier(candles, {0.0, 0.68, 0.0}, 6, 0.58, 22.5);
  append(candles.brass, tube({{0.0, 1.1, 0.0}, {0.0, 1.16 + chain_length, 0.0}}, 0.012, 6));
  return candles;
}

/// A lamp of glass in an iron crown that hangs at the origin from a chain.
struct HangingLamp {
  Shape iron;
  Shape glass;
};
HangingLamp hanging_lamp(double chain_length) {
  HangingLamp lamp;
  lamp.glass = ellipsoid({0.085, 0.11, 0.085}, 8);
  lamp.iron = moved(torus(0.1, 0.016, 12, 5), {0.0, 0.03, 0.0});
  append(lamp.iron, moved(cone(0.03, 0.06, 0.05, 8), {0.0, -0.145, 0.0}));
  for (int i = 0; i < 3; ++i) {
    append(lamp.iron, tube({around(2.0 * pi * i / 3, 0.1, 0.03), {0.0, 0.42, 0.0}}, 0.006, 4));
  }
  append(lamp.iron, moved(ellipsoid({0.03, 0.04, 0.03}, 6), {0.0, 0.42, 0.0}));
  append(lamp.iron, tube({{0.0, 0.42, 0.0}, {0.0, 0.42 + chain_length, 0.0}}, 0.007, 4));
  return lamp;
}

/// Small candles on the steps of an iron stand.
void add_votive_candles(Model& model, const Materials& m) {
  const DVec3 place(1.0, 0.0, 5.4);
  Pcg32 random = generator(model.stream(71));
  Candles candles;
  Shape iron;
  constexpr int rows = 4;
  constexpr int candles_in_row = 9;
  for (int row = 0; row < rows; ++row) {
    const DVec3 middle(0.18 * row, 0.75 + 0.13 * row, 0.0);
    append(iron, moved(box(DVec3(0.16, 0.02, 1.2)), place + middle));
    append(iron, moved(box(DVec3(0.015, 0.06, 1.2)), place + middle - DVec3(0.087, -0.01, 0.0)));
    for (int i = 0; i < candles_in_row; ++i) {
      if (random.uniform() < 0.8) {
        const DVec3 foot(0.0, 0.01, 0.13 * (i - 0.5 * (candles_in_row - 1)));
        candles.add_candle(place + middle + foot, 0.022, 0.06 + 0.1 * random.uniform());
      }
    }
  }
  for (const double side : {-0.58, 0.58}) {
    append(iron, moved(box(DVec3(0.04, 0.76, 0.04)), place + DVec3(0.0, 0.37, side)));
    append(iron, moved(box(DVec3(0.04, 1.13, 0.04)), place + DVec3(0.54, 0.565, side)));
    append(iron, moved(box(DVec3(0.6, 0.04, 0.04)), place + DVec3(0.27, 0.25, side)));
  }
  append(iron, moved(box(DVec3(0.03, 0.03, 1.16)), place + DVec3(0.54, 0.25, 0.0)));
  std::vector<Part> parts = {{m.iron, iron}};
  candles.append_to(parts, m);
  add_object(model, "Votive candles", parts);
}

}  // namespace

void Candles::add_candle(const DVec3& foot, double radius, double height) {
  append(wax, moved(lathe({{0.0, 0.0},
                           {radius, 0.0},
                           {radius, height},
                           {0.75 * radius, height + 0.003},
                           {0.5 * radius, height - 0.004},
                           {0.0, height - 0.004}},
                          8),
                    foot));
  const Shape flame = lathe({{0.0, 0.0},
                             {0.5 * radius, 0.6 * radius},
                             {0.62 * radius, 1.3 * radius},
                             {0.35 * radius, 2.6 * radius},
                             {0.0, 3.8 * radius}},
                            6);
  append(flames, moved(flame, foot + DVec3(0.0, height - 0.005, 0.0)));
}

void Candles::add_candlestick(const DVec3& foot, double height, double candle_height) {
  const double h = height;
  const Shape stick = lathe({{0.0, 0.0},
                             {0.14 * h, 0.0},
                             {0.145 * h, 0.02 * h},
                             {0.11 * h, 0.06 * h},
                             {0.05 * h, 0.12 * h},
                             {0.035 * h, 0.2 * h},
                             {0.06 * h, 0.25 * h},
                             {0.075 * h, 0.3 * h},
                             {0.04 * h, 0.37 * h},
                             {0.03 * h, 0.5 * h},
                             {0.035 * h, 0.66 * h},
                             {0.06 * h, 0.71 * h},
                             {0.03 * h, 0.76 * h},
                             {0.025 * h, 0.88 * h},
                             {0.09 * h, 0.95 * h},
                             {0.1 * h, h},
                             {0.0, h}},
                            12);
  append(brass, moved(stick, foot));
  add_candle(foot + DVec3(0.0, h, 0.0), 0.05 * h, candle_height);
}

void Candles::append_to(std::vector<Part>& parts, const Materials& m) const {
  parts.push_back({m.brass, brass, 45.0});
  parts.push_back({m.wax, wax, 45.0});
  parts.push_back({m.flame, flames, 80.0});
}

void add_chandeliers(Model& model, const Materials& m) {
  struct Place {
    const char* name;
    DVec3 position;
  };
  for (const Place& place :
       {Place{"Chandelier", {2.0, 4.4, 0.0}}, Place{"Western chandelier", {-6.0, 5.2, 0.0}}}) {
    Candles candles = chandelier(nave_springing + nave_rise - place.position.y - 1.16);
    for (Shape* shape : {&candles.brass, &candles.wax, &candles.flames}) {
      *shape = moved(*shape, place.position);
    }
    std::vector<Part> parts;
    candles.append_to(parts, m);
    add_object(model, place.name, parts);
  }
}

void add_candles(Model& model, const Materials& m) {
  add_votive_candles(model, m);
  const double height = 3.0;
  const double aisle_ceiling = 6.85;
  const HangingLamp lamp = hanging_lamp(aisle_ceiling - height - 0.42);
  Shape iron;
  Shape glass;
  for (int i = 0; i < bays; ++i) {
    for (const double side : {-1.0, 1.0}) {
      const DVec3 place(bay * (i - 0.5 * (bays - 1)), height,
                        side * 0.5 * (arcade_z + 0.5 * wall + aisle_z));
      append(iron, moved(lamp.iron, place));
      append(glass, moved(lamp.glass, place));
    }
  }
  add_object(model, "Aisle lamps", {{m.iron, iron}, {m.lamp, glass}});
  Candles paschal;
  paschal.add_candlestick({11.4, 0.32, -2.2}, 1.3, 0.9);
  std::vector<Part> parts;
  paschal.append_to(parts, m);
  add_object(model, "Paschal candle", parts);
}

}  // namespace foveola::scenes::church
