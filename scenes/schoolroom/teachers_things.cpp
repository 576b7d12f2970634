// What lies on the teacher's desk.
#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/base/random.h"
#include "scenes/modelling/curve.h"
#include "scenes/schoolroom/parts.h"
#include "scenes/schoolroom/patterns.h"

namespace foveola::scenes::school {
namespace {

/// Marked and not yet handed back: exercise books in a leaning pile.
std::vector<Part> pile_of_books(const Materials& m, const Seed& seed) {
  Pcg32 random = generator(seed);
  std::vector<Part> pile;
  double height = 0.0;
  for (int i = 0; i < 13; ++i) {
    const BookSize size{
        .thickness = 0.007 + 0.004 * random.uniform(), .height = 0.21, .depth = 0.15};
    const int spine = static_cast<int>(random.below(spines_in_image));
    const DVec3 slipped{0.014 * (random.uniform() - 0.5), height, 0.014 * (random.uniform() - 0.5)};
    append(pile, placed(lying_book(size, m, spine), slipped, 9.0 * (random.uniform() - 0.5)));
    height += size.thickness;
  }
  return pile;
}

/// A mug with its handle, and pencils that lean against its rim.
std::vector<Part> mug_of_pencils(const Materials& m) {
  constexpr double radius = 0.039;
  constexpr double height = 0.096;
  Shape mug = lathe({{0.0, 0.0},
                     {radius - 0.004, 0.0},
                     {radius, 0.004},
                     {radius, height - 0.002},
                     {radius - 0.0015, height},
                     {radius - 0.003, height - 0.002},
                     {radius - 0.003, 0.006},
                     {0.0, 0.005}},
                    48);
  append(mug, tube(curve({{radius - 0.002, 0.076, 0.0},
                          {radius + 0.018, 0.074, 0.0},
                          {radius + 0.026, 0.05, 0.0},
                          {radius + 0.016, 0.026, 0.0},
                          {radius - 0.002, 0.022, 0.0}},
                         6),
                   0.0045, 14));
  std::vector<Part> parts = {{m.blue, mug, 50.0}};
  constexpr int pencils = 6;
  const std::array<int, pencils> paints = {m.red,           m.yellow, m.green,
                                           m.black_plastic, m.red,    m.yellow};
  for (int i = 0; i < pencils; ++i) {
    const double lean_deg = 9.0 + 1.5 * (i % 3);
    // Pencils lie along X, their middle near the origin; stood up, they have their points on top.
    for (Part& part : pencil(m, paints[i])) {
      const Shape upright =
          moved(turned(std::move(part.shape), 90.0, {0, 0, 1}), {0.0035, 0.08 + 0.0085, 0.0});
      const Shape leaning = moved(turned(upright, -lean_deg, {0, 0, 1}), {0.01, 0.0, 0.0});
      append(parts,
             {{part.material, turned(leaning, 360.0 * i / pencils + 20.0), part.crease_deg}});
    }
  }
  return parts;
}

/// With a dimple at its stalk and another below, a little lopsided.
std::vector<Part> apple(const Materials& m) {
  constexpr double radius = 0.037;
  const Shape body = deformed(ellipsoid(DVec3(radius), 48), [](const DVec3& p) {
    const DVec3 q = p / radius;
    const double from_axis = std::hypot(q.x, q.z);
    const double dimple = 0.34 * std::exp(-from_axis * from_axis / 0.07);
    const double shoulder = 1.0 + 0.1 * q.y + 0.02 * std::sin(5.0 * std::atan2(q.x, q.z));
    return DVec3(p.x * shoulder + 0.03 * p.y, p.y * (0.94 - dimple), p.z * shoulder);
  });
  const Shape stalk =
      tube(curve({{0.0, 0.019, 0.0}, {0.001, 0.032, 0.0}, {0.006, 0.044, 0.002}}, 5), 0.0015, 10);
  const DVec3 up(0.0, 0.832 * radius, 0.0);
  return moved({{m.red, body, 80.0}, {m.dark_wood, stalk, 60.0}}, up);
}

/// The bell that ends the break.
std::vector<Part> hand_bell(const Materials& m) {
  const Shape bell = lathe({{0.0, 0.0},
                            {0.041, 0.0},
                            {0.043, 0.003},
                            {0.036, 0.014},
                            {0.03, 0.03},
                            {0.028, 0.044},
                            {0.022, 0.054},
                            {0.01, 0.059},
                            {0.007, 0.066},
                            {0.0, 0.066}},
                           56);
  const Shape grip = lathe({{0.0, 0.062},
                            {0.007, 0.064},
                            {0.01, 0.075},
                            {0.008, 0.088},
                            {0.012, 0.108},
                            {0.013, 0.126},
                            {0.009, 0.14},
                            {0.0, 0.144}},
                           32);
  return {{m.brass, bell, 50.0}, {m.dark_wood, grip, 60.0}};
}

/// An open box of chalk.
std::vector<Part> chalk_box(const Materials& m) {
  constexpr double length = 0.11;
  constexpr double width = 0.075;
  constexpr double height = 0.03;
  constexpr double wall = 0.0025;
  Shape box_walls = box({-0.5 * length, 0.0, -0.5 * width}, {0.5 * length, wall, 0.5 * width});
  for (const double side : {-1.0, 1.0}) {
    append(box_walls, moved(box(DVec3(length, height - wall, wall)),
                            {0.0, 0.5 * (height + wall), side * 0.5 * (width - wall)}));
    append(box_walls, moved(box(DVec3(wall, height - wall, width - 2.0 * wall)),
                            {side * 0.5 * (length - wall), 0.5 * (height + wall), 0.0}));
  }
  Shape white;
  Shape coloured;
  constexpr double thickness = 0.0055;
  for (int layer = 0; layer < 2; ++layer) {
    for (int i = 0; i < 6; ++i) {
      const double z = (i - 2.5) * 2.0 * thickness + (layer == 1 ? 0.4 * thickness : 0.0);
      const DVec3 end(-0.045 + 0.005 * ((3 * i + layer) % 4),
                      wall + thickness * (1.0 + 1.96 * layer), z);
      const Shape stick =
          moved(turned(cone(thickness, 0.9 * thickness, 0.08, 20), -90.0, {0, 0, 1}), end);
      append((i + layer) % 5 == 1 ? coloured : white, stick);
    }
  }
  return {{m.paper, box_walls}, {m.chalk, white, 50.0}, {m.yellow, coloured, 50.0}};
}

/// A loose written sheet whose corner lifts, to be read from +Z.
std::vector<Part> loose_sheet(const Materials& m) {
  constexpr double width = 0.21;
  constexpr double length = 0.28;
  Shape sheet = patch(8, 8, [](double u, double v) {
    const double lift = std::max(0.0, u + v - 1.3);
    return DVec3(width * (u - 0.5), 0.0012 + 0.05 * lift * lift, length * (0.5 - v));
  });
  for (DVec2& uv : sheet.uvs) {
    uv.y = 1.0 - uv.y;
  }
  const Shape back = inside_out(moved(sheet, {0.0, -0.0003, 0.0}));
  return {{m.page, sheet, 60.0}, {m.paper, back, 60.0}};
}

}  // namespace

void add_teachers_things(Model& model, const Materials& m) {
  const auto put = [&](const char* name, const std::vector<Part>& parts, const DVec3& on_desk,
                       double turn_deg) {
    add_object(model, name, placed(parts, teacher_desk_top + on_desk, turn_deg));
  };
  // Turned by 90 degrees, what lies along Z can be read from the teacher's chair.
  put("Register", open_book(m, m.other_page), {0.14, 0.0005, -0.08}, 84.0);
  put("Exercise books", pile_of_books(m, model.stream(670)), {-0.1, 0.0, -0.42}, 78.0);
  put("Mug with pencils", mug_of_pencils(m), {-0.19, 0.0, -0.16}, 130.0);
  put("Apple", apple(m), {-0.16, 0.0, 0.03}, 25.0);
  put("Hand bell", hand_bell(m), {0.2, 0.0, 0.3}, 0.0);
  put("Box of chalk", chalk_box(m), {-0.06, 0.0, -0.16}, 65.0);
  std::vector<Part> sheets = loose_sheet(m);
  append(sheets, placed(loose_sheet(m), {0.03, 0.0012, 0.05}, -14.0));
  put("Loose sheets", sheets, {0.19, 0.0, -0.44}, 97.0);
}

}  // namespace foveola::scenes::school
