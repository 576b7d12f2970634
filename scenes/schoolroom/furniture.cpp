// Desks, chairs, the teacher's desk and the bookshelves.
#include <cmath>

#include <fmt/format.h>

#include "renderer/base/random.h"
#include "scenes/modelling/curve.h"
#include "scenes/schoolroom/layout.h"
#include "scenes/schoolroom/parts.h"
#include "scenes/schoolroom/patterns.h"

namespace foveola::scenes::school {
namespace {

constexpr double seat_height = 0.44;

/// Stands on the origin, its pupils' side towards -X, long along Z.
std::vector<Part> pupils_desk(const Materials& m) {
  const double half_width = 0.5 * desk_width;
  Shape top = moved(rounded_box({desk_depth, 0.028, desk_width}, 0.012, 3),
                    {0.0, desk_height - 0.014, 0.0});
  top = with_uv_scale(with_projected_uvs(top, {1, 0, 0}, {0, 0, 1}), 0.8);
  Shape frame;
  Shape feet;
  Shape shelf;
  for (const double side : {-1.0, 1.0}) {
    const double z = side * (half_width - 0.09);
    for (const double x : {-0.2, 0.2}) {
      append(frame, tube({{x, 0.02, z}, {x, desk_height - 0.03, z}}, 0.016, 14));
      append(feet, moved(cone(0.021, 0.018, 0.035, 14), {x, 0.0, z}));
    }
    append(frame, tube(curve({{-0.2, 0.12, z}, {-0.18, 0.1, z}, {0.18, 0.1, z}, {0.2, 0.12, z}}, 4),
                       0.013, 12));
    append(frame, tube({{-0.22, desk_height - 0.04, z}, {0.22, desk_height - 0.04, z}}, 0.013, 12));
    // A hook for the bag.
    const double out = z + side * 0.02;
    append(frame, tube(curve({{0.0, desk_height - 0.05, z},
                              {0.0, desk_height - 0.11, out},
                              {0.0, desk_height - 0.12, out + side * 0.03},
                              {0.0, desk_height - 0.09, out + side * 0.045}},
                             3),
                       0.005, 8));
  }
  append(frame, tube({{0.2, 0.3, -half_width + 0.09}, {0.2, 0.3, half_width - 0.09}}, 0.014, 12));
  constexpr int wires = 12;
  for (int i = 0; i <= wires; ++i) {
    const double z = (half_width - 0.1) * (2.0 * i / wires - 1.0);
    append(shelf, tube(curve({{-0.16, desk_height - 0.13, z},
                              {0.14, desk_height - 0.145, z},
                              {0.19, desk_height - 0.14, z},
                              {0.2, desk_height - 0.04, z}},
                             3),
                       0.003, 6));
  }
  for (const double x : {-0.16, 0.0, 0.16}) {
    append(shelf, tube({{x, desk_height - 0.139, -half_width + 0.09},
                        {x, desk_height - 0.139, half_width - 0.09}},
                       0.004, 6));
  }
  return {{m.desk_top, top, 50.0},
          {m.green_steel, frame, 50.0},
          {m.black_plastic, feet, 50.0},
          {m.steel, shelf, 60.0}};
}

/// A plywood chair on bent tubes, on the origin and facing +X.
std::vector<Part> pupils_chair(const Materials& m) {
  Shape seat = deformed(rounded_box({0.4, 0.014, 0.4}, 0.006, 2, 8), [](const DVec3& p) {
    // Hollowed for the sitter, its front edge bent down and its corners cut round.
    const double hollow = -0.012 * std::cos(4.0 * p.x) * std::cos(5.0 * p.z);
    const double front = p.x > 0.1 ? -1.6 * (p.x - 0.1) * (p.x - 0.1) : 0.0;
    const double narrower = 1.0 - 1.2 * p.x * p.x - (p.x < 0.0 ? -0.25 * p.x : 0.0);
    return DVec3(p.x, p.y + hollow + front, p.z * narrower);
  });
  seat = moved(seat, {0.0, seat_height, 0.0});
  Shape back = deformed(rounded_box({0.013, 0.2, 0.4}, 0.006, 2, 8), [](const DVec3& p) {
    const double bow = 1.1 * p.z * p.z;
    const double lower = 1.0 - 6.0 * p.z * p.z * std::abs(p.y);
    return DVec3(p.x + bow - 0.3 * p.y, p.y * lower, p.z);
  });
  back = moved(back, {-0.235, seat_height + 0.31, 0.0});
  Shape wood = with_projected_uvs(seat, {1, 0, 0}, {0, 0, 1});
  append(wood, with_projected_uvs(back, {0, 1, 0}, {0, 0, 1}));
  Shape frame;
  Shape feet;
  for (const double side : {-1.0, 1.0}) {
    const double z = side * 0.17;
    append(frame, tube(curve({{0.19, 0.02, side * 0.2},
                              {0.17, seat_height - 0.06, z},
                              {0.12, seat_height - 0.02, z},
                              {-0.14, seat_height - 0.02, z},
                              {-0.19, seat_height + 0.02, z},
                              {-0.225, seat_height + 0.22, z},
                              {-0.25, seat_height + 0.37, z}},
                             3),
                       0.0115, 12));
    append(
        frame,
        tube(curve({{-0.25, 0.02, side * 0.2}, {-0.19, 0.3, z}, {-0.14, seat_height - 0.03, z}}, 3),
             0.0115, 12));
    append(frame, tube({{0.178, 0.2, side * 0.186}, {-0.208, 0.2, side * 0.183}}, 0.009, 10));
    append(feet, moved(cone(0.016, 0.013, 0.03, 12), {0.19, 0.0, side * 0.2}));
    append(feet, moved(cone(0.016, 0.013, 0.03, 12), {-0.25, 0.0, side * 0.2}));
    for (const double y : {0.26, 0.35}) {
      append(frame, moved(ellipsoid({0.006, 0.008, 0.008}, 8),
                          {-0.197 - 0.3 * (y - 0.31), seat_height + y, z}));
    }
  }
  append(frame,
         tube({{-0.02, seat_height - 0.025, -0.17}, {-0.02, seat_height - 0.025, 0.17}}, 0.01, 10));
  return {{m.plywood, with_uv_scale(wood, 1.5), 50.0},
          {m.green_steel, frame, 50.0},
          {m.black_plastic, feet, 50.0}};
}

Shape turned_leg(double height) {
  const std::vector<DVec2> outline = {
      {0.0, 0.0},    {0.02, 0.0},   {0.026, 0.02}, {0.022, 0.05}, {0.03, 0.09}, {0.022, 0.12},
      {0.02, 0.15},  {0.026, 0.3},  {0.033, 0.45}, {0.036, 0.55}, {0.03, 0.63}, {0.024, 0.66},
      {0.035, 0.69}, {0.035, 0.71}, {0.024, 0.74}, {0.03, 0.76},  {0.0, 0.76}};
  Shape leg = scaled(lathe(outline, 24), {1.0, height, 1.0});
  append(leg, box({-0.036, 0.76 * height, -0.036}, {0.036, height, 0.036}));
  return leg;
}

std::vector<Part> teachers_desk(const Materials& m) {
  constexpr double half_depth = 0.38;
  constexpr double half_width = 0.75;
  constexpr double h = teacher_desk_height;
  Shape wood =
      with_projected_uvs(moved(rounded_box({2.0 * half_depth, 0.035, 2.0 * half_width}, 0.014, 3),
                               {0.0, h - 0.0175, 0.0}),
                         {1, 0, 0}, {0, 0, 1});
  const Shape leg = turned_leg(h - 0.035);
  for (const double x : {-half_depth + 0.07, half_depth - 0.07}) {
    for (const double z : {-half_width + 0.07, half_width - 0.07}) {
      append(wood, moved(leg, {x, 0.0, z}));
    }
  }
  for (const double side : {-1.0, 1.0}) {
    append(wood, moved(box(DVec3(2.0 * half_depth - 0.22, 0.13, 0.022)),
                       {0.0, h - 0.1, side * (half_width - 0.07)}));
  }
  append(wood, moved(box(DVec3(0.022, 0.13, 2.0 * half_width - 0.22)),
                     {-half_depth + 0.07, h - 0.1, 0.0}));
  append(wood,
         moved(box(DVec3(0.02, 0.13, 2.0 * half_width - 0.22)), {half_depth - 0.07, h - 0.1, 0.0}));
  Shape knobs;
  for (const double z : {-0.4, 0.0, 0.4}) {
    append(wood,
           moved(rounded_box({0.022, 0.1, 0.36}, 0.008, 2), {half_depth - 0.058, h - 0.1, z}));
    const Shape knob = lathe(
        {{0.0, 0.0}, {0.006, 0.0}, {0.006, 0.012}, {0.015, 0.018}, {0.013, 0.027}, {0.0, 0.03}},
        18);
    append(knobs, moved(turned(knob, -90.0, {0, 0, 1}), {half_depth - 0.048, h - 0.1, z}));
  }
  return {{m.dark_wood, wood}, {m.brass, knobs, 50.0}};
}

Shape teachers_chair() {
  Shape shape = moved(rounded_box({0.44, 0.04, 0.44}, 0.016, 3), {0.0, 0.45, 0.0});
  const Shape leg = scaled(turned_leg(0.43), {0.75, 1.0, 0.75});
  for (const double x : {-0.17, 0.17}) {
    for (const double z : {-0.17, 0.17}) {
      append(shape, moved(leg, {x, 0.0, z}));
    }
  }
  for (const double z : {-0.18, 0.18}) {
    append(shape, tube({{0.19, 0.46, z}, {0.21, 0.7, z}, {0.26, 0.98, z}}, 0.017, 14));
  }
  for (int i = 0; i < 5; ++i) {
    const double z = 0.065 * (i - 2);
    append(shape, tube({{0.195, 0.47, z}, {0.215, 0.7, z}, {0.245, 0.92, z}}, 0.009, 10));
  }
  const Shape crest = deformed(rounded_box({0.022, 0.09, 0.42}, 0.01, 3, 6), [](const DVec3& p) {
    return DVec3(p.x + 0.03 - 0.7 * p.z * p.z, p.y * (1.0 - 4.0 * p.z * p.z), p.z);
  });
  append(shape, moved(crest, {0.245, 0.95, 0.0}));
  return shape;
}

/// Fills one shelf with books from z = 0 to `length`, their spines towards +X.
void fill_shelf(std::vector<Part>& books, const Materials& m, const DVec3& left_end, double length,
                Pcg32& random) {
  double along = 0.0;
  while (true) {
    const BookSize size{.thickness = 0.018 + 0.03 * random.uniform(),
                        .height = 0.2 + 0.09 * random.uniform(),
                        .depth = 0.15 + 0.04 * random.uniform()};
    if (along + size.thickness > length) {
      return;
    }
    const int spine = static_cast<int>(random.below(spines_in_image));
    const bool is_gap = random.uniform() < 0.03;
    const DVec3 place =
        left_end + DVec3(-0.01 * random.uniform(), 0.0, -along - 0.5 * size.thickness);
    if (!is_gap) {
      append(books, placed(book(size, m, spine), place, 90.0));
    }
    along += size.thickness + 0.001;
  }
}

}  // namespace

void add_desks_and_chairs(Model& model, const Materials& m) {
  const std::vector<Part> desk = pupils_desk(m);
  const std::vector<Part> chair = pupils_chair(m);
  Pcg32 random = generator(model.stream(600));
  int number = 1;
  for (const DVec3& place : desk_places()) {
    const double askew_deg = 3.0 * (random.uniform() - 0.5);
    add_object(model, fmt::format("Desk {}", number), placed(desk, place, askew_deg));
    std::vector<Part> chairs;
    for (const double side : {-1.0, 1.0}) {
      // Pushed back and turned as their pupils left them.
      const DVec3 behind(-0.36 - 0.16 * random.uniform(), 0.0, side * 0.33);
      append(chairs, placed(chair, place + behind, 26.0 * (random.uniform() - 0.5)));
    }
    add_object(model, fmt::format("Chairs {}", number), chairs);
    ++number;
  }
}

void add_teachers_place(Model& model, const Materials& m) {
  const Shape platform = box({2.45, 0.0, -2.55}, {half_x, platform_height, 2.75});
  add_object(model, "Platform", {{m.dark_wood, with_uv_scale(platform, 0.6)}});
  const DVec3 place = teacher_desk_place + DVec3(0.0, platform_height, 0.0);
  add_object(model, "Teacher's desk", moved(teachers_desk(m), place));
  add_object(model, "Teacher's chair",
             placed({{m.dark_wood, teachers_chair(), 50.0}}, place + DVec3(0.72, 0.0, -0.1), 18.0));
}

void add_shelves(Model& model, const Materials& m) {
  constexpr double depth = 0.26;
  constexpr double height = 1.95;
  constexpr double width = 1.1;
  constexpr int shelves = 5;
  constexpr double board = 0.022;
  Pcg32 random = generator(model.stream(601));
  Shape wood;
  std::vector<Part> books;
  for (const double middle : {-2.2, -1.08, 0.04}) {
    const DVec3 foot(-half_x + 0.025, 0.0, middle);
    for (const double side : {-1.0, 1.0}) {
      append(wood, moved(rounded_box({depth, height, board}, 0.004, 1),
                         foot + DVec3(0.5 * depth, 0.5 * height, side * 0.5 * (width - board))));
    }
    append(wood, moved(box(DVec3(0.008, height - 0.05, width - 2.0 * board)),
                       foot + DVec3(0.006, 0.5 * height, 0.0)));
    for (int i = 0; i <= shelves; ++i) {
      const double y = 0.08 + i * (height - 0.1) / shelves;
      append(wood, moved(rounded_box({depth - 0.012, board, width - 2.0 * board}, 0.004, 1),
                         foot + DVec3(0.5 * depth + 0.002, y, 0.0)));
      if (i < shelves) {
        const double filled = (width - 2.0 * board) * (0.62 + 0.36 * random.uniform());
        fill_shelf(books, m, foot + DVec3(depth - 0.03, y + 0.5 * board, 0.5 * width - board),
                   filled, random);
      }
    }
  }
  add_object(model, "Bookshelves", {{m.plywood, with_uv_scale(wood, 0.8)}});
  add_object(model, "Books", books);
}

}  // namespace foveola::scenes::school
