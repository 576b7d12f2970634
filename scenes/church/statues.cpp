// The church's figures: saints on pedestals, a tomb, the cross under the choir's arch, a lectern.
#include <string>

#include "scenes/church/parts.h"
#include "scenes/modelling/architecture.h"
#include "scenes/modelling/props.h"

namespace foveola::scenes::church {
namespace {

/// A pedestal of `height` on the origin, as wide as a figure's cloak.
Shape pedestal(double height) {
  const double h = height;
  Shape shape = box({-0.34, 0.0, -0.34}, {0.34, 0.16, 0.34});
  append(shape, moved(lathe({{0.3, 0.0},
                             {0.3, 0.06},
                             {0.22, 0.14},
                             {0.2, 0.2},
                             {0.2, h - 0.42},
                             {0.24, h - 0.36},
                             {0.22, h - 0.32},
                             {0.3, h - 0.24}},
                            24),
                      {0.0, 0.16, 0.0}));
  append(shape, box({-0.32, h - 0.1, -0.32}, {0.32, h, 0.32}));
  return scaled(shape, {1.45, 1.0, 1.45});
}

/// A saint with a halo on a pedestal, facing +Z.
std::vector<Part> saint(const Materials& m, int stone, double height) {
  constexpr double foot = 1.25;
  Shape gold = turned(torus(0.13 * height, 0.012, 28, 8), 90.0, {1, 0, 0});
  gold = moved(gold, {0.0, foot + 0.95 * height, -0.06});
  append(gold, tube({{0.16, foot, 0.3}, {0.16, foot + 0.95 * height, 0.3}}, 0.014, 8));
  append(gold, moved(ellipsoid({0.035, 0.05, 0.035}, 10), {0.16, foot + 0.97 * height, 0.3}));
  const Shape figure = moved(robed_figure(height), {0.0, foot, 0.0});
  return {{m.dark_stone, pedestal(foot), 35.0}, {stone, figure, 50.0}, {m.gold, gold, 60.0}};
}

/// A dark corner with a floor and a roof, against which a saint of pale stone stands out; open to
/// -X and -Z, its middle over the origin.
std::vector<Part> niche(const Materials& m) {
  constexpr double half = 0.56;
  constexpr double floor = 1.262;  // just above the pedestal's top
  constexpr double height = 2.1;
  constexpr double board = 0.06;
  Shape wood = box({-half, floor - 0.08, -half}, {half, floor, half});
  append(wood, box({-half, floor, half - board}, {half, floor + height, half}));
  append(wood, box({half - board, floor, -half}, {half, floor + height, half - board}));
  append(wood, box({-half, floor + height, -half}, {half, floor + height + 0.06, half}));
  const double roof = floor + height + 0.06;
  append(wood, box({-half - 0.06, roof, -half - 0.06}, {half + 0.06, roof + 0.07, half + 0.04}));
  Shape gold = moved(turned(cone(0.62, 0.0, 0.55, 4), 45.0), {0.0, roof + 0.06, 0.0});
  append(gold, moved(ellipsoid({0.07, 0.09, 0.07}, 12), {0.0, roof + 0.63, 0.0}));
  return {{m.dark_oak, with_projected_uvs(wood, {0.7, 0, 0.7}, {0, 0.7, 0})}, {m.gold, gold}};
}

std::vector<Part> turned_parts(std::vector<Part> parts, double turn_deg) {
  for (Part& part : parts) {
    part.shape = turned(part.shape, turn_deg);
  }
  return parts;
}

/// A lying figure on a moulded chest.
void add_tomb(Model& model, const Materials& m) {
  const DVec3 place(-2.0, 0.0, -6.3);
  Shape chest = box({-1.15, 0.0, -0.5}, {1.15, 0.14, 0.5});
  append(chest, box({-1.0, 0.14, -0.4}, {1.0, 0.72, 0.4}));
  append(chest, box({-1.12, 0.72, -0.48}, {1.12, 0.84, 0.48}));
  Shape shafts;
  for (int i = 0; i < 7; ++i) {
    append(shafts, moved(shaft(0.04, 0.58, 10), {0.3 * (i - 3), 0.14, 0.42}));
  }
  Shape figure = turned(robed_figure(1.75), -90.0, {1, 0, 0});
  figure = moved(turned(figure, 90.0), {0.85, 1.04, 0.0});
  Shape pillow = moved(rounded_box({0.4, 0.12, 0.5}, 0.05, 3), {-0.8, 0.9, 0.0});
  add_object(model, "Tomb",
             moved({{m.red_marble, with_uv_scale(chest, 0.7)},
                    {m.white_marble, shafts, 40.0},
                    {m.white_marble, figure, 50.0},
                    {m.white_marble, pillow, 50.0}},
                   place));
}

/// The cross that hangs in the arch between nave and choir.
void add_rood(Model& model, const Materials& m) {
  const double x = half_length - 0.2;
  const double foot = 4.6;
  Shape wood = moved(box(DVec3(0.08, 2.0, 0.16)), {x, foot + 1.0, 0.0});
  append(wood, moved(box(DVec3(0.078, 0.16, 1.3)), {x, foot + 1.4, 0.0}));
  Shape gold;
  for (const DVec3& end : {DVec3(x, foot, 0.0), DVec3(x, foot + 2.0, 0.0),
                           DVec3(x, foot + 1.4, -0.65), DVec3(x, foot + 1.4, 0.65)}) {
    append(gold, moved(ellipsoid({0.07, 0.13, 0.13}, 14), end));
  }
  const double front = x - 0.1;
  append(gold, tube({{front, foot + 1.3, 0.0},
                     {front - 0.04, foot + 0.9, 0.03},
                     {front - 0.06, foot + 0.6, -0.02},
                     {front, foot + 0.25, 0.0}},
                    0.07, 12));
  append(gold,
         tube({{front, foot + 1.42, -0.55}, {front, foot + 1.22, 0.0}, {front, foot + 1.42, 0.55}},
              0.035, 10));
  append(gold, moved(ellipsoid({0.08, 0.11, 0.08}, 14), {front - 0.03, foot + 1.45, 0.03}));
  for (const double side : {-0.5, 0.5}) {
    append(gold, tube({{x, foot + 1.45, side}, {x, nave_springing + 3.85, 2.0 * side}}, 0.008, 5));
  }
  add_object(model, "Rood cross", {{m.dark_oak, wood}, {m.gold, gold, 60.0}});
}

/// A brass desk with an open book, at the choir's steps.
void add_lectern(Model& model, const Materials& m) {
  const Shape post = lathe({{0.0, 0.0},
                            {0.3, 0.0},
                            {0.3, 0.05},
                            {0.12, 0.12},
                            {0.06, 0.25},
                            {0.09, 0.4},
                            {0.05, 0.55},
                            {0.05, 0.85},
                            {0.1, 0.95},
                            {0.04, 1.05},
                            {0.04, 1.2},
                            {0.0, 1.2}},
                           24);
  const auto tilt = [](const Shape& shape) {
    return moved(turned(turned(shape, 35.0, {1, 0, 0}), -90.0), {0.0, 1.2, 0.0});
  };
  Shape brass = post;
  append(brass, tilt(box({-0.36, -0.02, -0.26}, {0.36, 0.0, 0.26})));
  append(brass, tilt(box({-0.36, 0.0, 0.24}, {0.36, 0.05, 0.26})));
  const Shape pages = tilt(box({-0.31, 0.0, -0.22}, {0.31, 0.035, 0.22}));
  const Shape book = tilt(picture({-0.3, 0.038, 0.21}, {0.6, 0, 0}, {0, 0, -0.42}));
  add_object(model, "Lectern",
             moved({{m.brass, brass, 45.0}, {m.linen, pages}, {m.book, book}}, {-1.2, 0.0, 2.6}));
}

}  // namespace

void add_statues(Model& model, const Materials& m) {
  struct Place {
    const char* name;
    DVec3 position;
    double turn_deg;
    int stone;
  };
  const Place marble{"Marble saint", {4.0, 0.0, 2.45}, 225.0, m.white_marble};
  const Place gilded{"Gilded saint", {-8.0, 0.0, -2.53}, 0.0, m.gold};
  for (const Place& place : {marble, gilded}) {
    add_object(model, place.name,
               moved(turned_parts(saint(m, place.stone, 1.75), place.turn_deg), place.position));
  }
  add_object(model, "Niche", moved(niche(m), marble.position));
  add_tomb(model, m);
  add_rood(model, m);
  add_lectern(model, m);
}

}  // namespace foveola::scenes::church
