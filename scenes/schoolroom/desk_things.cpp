// What pupils bring: books, paper, pencils, bags and coats.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "renderer/base/random.h"
#include "scenes/modelling/curve.h"
#include "scenes/schoolroom/layout.h"
#include "scenes/schoolroom/parts.h"
#include "scenes/schoolroom/patterns.h"

namespace foveola::scenes::school {
namespace {

using std::numbers::pi;

/// uvs in the plain part of a spine's strip.
Shape plainly_covered(Shape shape, int spine) {
  for (DVec2& uv : shape.uvs) {
    const DVec2 within(0.4 + 0.2 * std::fmod(std::abs(uv.x), 1.0),
                       0.4 + 0.2 * std::fmod(std::abs(uv.y), 1.0));
    uv = {(spine + within.x) / spines_in_image, std::lerp(plain_cover_from_v, 1.0, within.y)};
  }
  return shape;
}

std::vector<Part> pencil_case(const Materials& m, int cloth) {
  const Shape body = deformed(rounded_box({0.2, 0.055, 0.075}, 0.024, 4, 5), [](const DVec3& p) {
    const double dent = 0.004 * std::sin(40.0 * p.x) * std::cos(30.0 * p.z);
    return DVec3(p.x, (p.y + dent) * (1.0 - 6.0 * p.x * p.x), p.z);
  });
  Shape zip =
      tube(curve({{-0.085, 0.045, 0.0}, {0.0, 0.0565, 0.0}, {0.085, 0.045, 0.0}}, 6), 0.003, 8);
  append(zip, moved(rounded_box({0.022, 0.004, 0.008}, 0.0018, 1), {0.06, 0.056, 0.004}));
  return {{cloth, with_uv_scale(moved(body, {0.0, 0.028, 0.0}), 6.0), 60.0}, {m.brass, zip, 60.0}};
}

/// A closed school bag, on the origin and facing +Z.
std::vector<Part> school_bag(const Materials& m, int cloth) {
  const auto sag = [](const DVec3& p) {
    const double crumple = 0.006 * std::sin(28.0 * p.x + 9.0 * p.y) * std::cos(22.0 * p.y);
    const double belly = 1.0 + 0.12 * std::cos(6.0 * (p.y + 0.08));
    return DVec3(p.x * (1.0 - 0.35 * std::max(0.0, p.y)), p.y, p.z * belly + crumple);
  };
  Shape body = moved(deformed(rounded_box({0.3, 0.4, 0.15}, 0.055, 3, 6), sag), {0.0, 0.2, 0.0});
  const Shape pocket = deformed(rounded_box({0.24, 0.18, 0.07}, 0.03, 3, 5), sag);
  append(body, moved(pocket, {0.0, 0.12, 0.085}));
  Shape straps;
  for (const double side : {-1.0, 1.0}) {
    append(straps, tube(curve({{side * 0.09, 0.37, -0.06},
                               {side * 0.1, 0.34, -0.13},
                               {side * 0.12, 0.2, -0.15},
                               {side * 0.12, 0.06, -0.08}},
                              5),
                        0.013, 10));
    append(straps, moved(rounded_box({0.03, 0.16, 0.008}, 0.003, 2), {side * 0.08, 0.3, 0.082}));
  }
  append(straps, tube(curve({{-0.04, 0.39, -0.04},
                             {-0.035, 0.44, -0.05},
                             {0.035, 0.44, -0.05},
                             {0.04, 0.39, -0.04}},
                            5),
                      0.009, 10));
  Shape buckles;
  for (const double side : {-1.0, 1.0}) {
    append(buckles,
           moved(turned(torus(0.016, 0.003, 20, 8), 90.0, {1, 0, 0}), {side * 0.08, 0.24, 0.09}));
  }
  return {{cloth, with_uv_scale(body, 4.0), 60.0},
          {m.black_plastic, straps, 50.0},
          {m.brass, buckles, 60.0}};
}

/// A coat that hangs from the origin, its back towards -Z.
Shape coat(const Seed& seed) {
  Pcg32 random = generator(seed);
  const double phase = 2.0 * pi * random.uniform();
  const double length = 0.75 + 0.2 * random.uniform();
  const auto folded = [&](const DVec3& p) {
    const double angle = std::atan2(p.x, p.z);
    const double fall = std::clamp(-p.y / length, 0.0, 1.0);
    const double fold = 1.0 + 0.16 * fall * std::sin(7.0 * angle + phase + 2.0 * fall) +
                        0.05 * std::sin(13.0 * angle - 3.0 * fall);
    return DVec3(p.x * fold, p.y, 0.42 * p.z * fold);
  };
  std::vector<DVec2> outline = {{0.0, 0.0},   {0.2, 0.0},  {0.205, 0.15}, {0.195, 0.35},
                                {0.18, 0.55}, {0.16, 0.7}, {0.135, 0.82}, {0.1, 0.9},
                                {0.06, 0.96}, {0.035, 1.0}};
  for (DVec2& point : outline) {
    point.y = (point.y - 1.0) * length;
  }
  outline.emplace_back(0.0, 0.005);
  Shape shape = deformed(lathe(outline, 56), folded);
  for (const double side : {-1.0, 1.0}) {
    append(shape, tube(curve({{side * 0.09, -0.1, 0.0},
                              {side * 0.145, -0.24, 0.02},
                              {side * 0.165, -0.42, 0.035},
                              {side * 0.155, -0.6, 0.05}},
                             4),
                       0.045, 16));
  }
  const Shape collar = scaled(torus(0.055, 0.018, 32, 12), {1.0, 1.3, 0.75});
  append(shape, moved(turned(collar, 12.0, {1, 0, 0}), {0.0, -0.045, 0.01}));
  return shape;
}

void add_pupils_things(std::vector<Part>& things, const Materials& m, const DVec3& seat,
                       Pcg32& random) {
  const std::array<int, 5> paints = {m.red, m.blue, m.yellow, m.green, m.black_plastic};
  const auto any_paint = [&] { return paints[random.below(paints.size())]; };
  const auto lay = [&](const std::vector<Part>& parts, const DVec3& offset, double turn_deg) {
    append(things, placed(parts, seat + offset, turn_deg));
  };
  // A draw a statement: compilers disagree on the order of a call's arguments.
  const int page = random.uniform() < 0.5 ? m.page : m.other_page;
  const int cloth = random.uniform() < 0.5 ? m.red_cloth : m.blue_cloth;
  // Turned by -90 degrees, what lies along Z can be read from the chair.
  lay(open_book(m, page), {-0.06, 0.0005, 0.0}, -90.0 + 16.0 * (random.uniform() - 0.5));
  lay(pencil_case(m, cloth), {0.17, 0.0, 0.06}, 90.0 + 30.0 * (random.uniform() - 0.5));
  for (int i = 0; i < 4; ++i) {
    const int paint = any_paint();
    const DVec3 offset{0.09 + 0.02 * random.uniform() + 0.012 * i, 0.0,
                       -0.16 - 0.02 * random.uniform()};
    lay(pencil(m, paint), offset, 90.0 + 25.0 * (random.uniform() - 0.5));
  }
  if (random.uniform() < 0.6) {
    double height = 0.0;
    for (std::uint32_t i = 0, count = 1 + random.below(3); i < count; ++i) {
      const BookSize size{
          .thickness = 0.014 + 0.02 * random.uniform(), .height = 0.22, .depth = 0.16};
      const int spine = static_cast<int>(random.below(spines_in_image));
      lay(lying_book(size, m, spine), {0.13, height, -0.02 * i},
          180.0 + 40.0 * (random.uniform() - 0.5));
      height += size.thickness;
    }
  }
}

}  // namespace

std::vector<Part> book(const BookSize& size, const Materials& m, int spine) {
  constexpr double board = 0.0025;
  const double half_thickness = 0.5 * size.thickness;
  Shape cover;
  for (const double side : {-1.0, 1.0}) {
    append(cover, moved(rounded_box({board, size.height, size.depth - 0.004}, 0.0012, 1),
                        {side * (half_thickness - 0.5 * board), 0.5 * size.height,
                         -0.5 * size.depth - 0.002}));
  }
  cover = plainly_covered(std::move(cover), spine);
  const auto round_back = [&](double u) {
    return 0.22 * size.thickness * std::sin(std::numbers::pi * u) - 0.004;
  };
  Shape back = patch(8, 1, [&](double u, double v) {
    return DVec3((u - 0.5) * size.thickness, v * size.height, round_back(u));
  });
  for (DVec2& uv : back.uvs) {
    uv = {(spine + 0.04 + 0.92 * uv.x) / spines_in_image, 1.0 - uv.y};
  }
  append(cover, back);
  const double page_half = half_thickness - board;
  Shape pages = moved(box(DVec3(2.0 * page_half, size.height - 0.008, size.depth - 0.012)),
                      {0.0, 0.5 * size.height, -0.5 * size.depth});
  return {{m.spines, cover, 40.0}, {m.paper, pages}};
}

std::vector<Part> lying_book(const BookSize& size, const Materials& m, int spine) {
  std::vector<Part> lying = book(size, m, spine);
  for (Part& part : lying) {
    part.shape = moved(turned(std::move(part.shape), 90.0, {0, 0, 1}),
                       {0.5 * size.height, 0.5 * size.thickness, 0.0});
  }
  return lying;
}

std::vector<Part> open_book(const Materials& m, int page) {
  constexpr double width = 0.15;
  constexpr double height = 0.21;
  Shape pages;
  Shape block;
  for (const double side : {-1.0, 1.0}) {
    const auto rise = [](double t) { return 0.004 + 0.012 * std::sin(2.6 * std::sqrt(t) + 0.1); };
    const auto across = [&](double u) { return side > 0.0 ? u : 1.0 - u; };
    Shape sheet = patch(10, 1, [&](double u, double v) {
      return DVec3(side * width * across(u), rise(across(u)), height * (0.5 - v));
    });
    for (DVec2& uv : sheet.uvs) {
      uv.y = 1.0 - uv.y;
    }
    append(pages, sheet);
    for (const double end : {0.0, 1.0}) {
      const Shape edge = patch(10, 1, [&](double u, double v) {
        const double t = across(end > 0.5 ? u : 1.0 - u);
        return DVec3(side * width * t, rise(t) * v, height * (end - 0.5));
      });
      append(block, edge);
    }
    append(block, side > 0.0
                      ? rectangle({width, 0, 0.5 * height}, {0, 0, -height}, {0, rise(1.0), 0})
                      : rectangle({-width, 0, -0.5 * height}, {0, 0, height}, {0, rise(1.0), 0}));
  }
  append(block, rectangle({-width, 0, -0.5 * height}, {2.0 * width, 0, 0}, {0, 0, height}));
  return {{page, pages, 60.0}, {m.paper, block, 60.0}};
}

std::vector<Part> pencil(const Materials& m, int paint) {
  const Shape shaft = lathe({{0.0, 0.0}, {0.0037, 0.0}, {0.0037, 0.14}}, 6);
  const Shape wood = lathe({{0.0037, 0.14}, {0.0012, 0.158}}, 12);
  const Shape lead = lathe({{0.0012, 0.158}, {0.0, 0.163}}, 12);
  const auto laid = [](const Shape& shape) {
    return moved(turned(shape, -90.0, {0, 0, 1}), {-0.08, 0.0035, 0.0});
  };
  return {{paint, laid(shaft), 20.0},
          {m.plywood, laid(wood), 60.0},
          {m.black_plastic, laid(lead), 60.0}};
}

void add_desk_things(Model& model, const Materials& m) {
  Pcg32 random = generator(model.stream(610));
  std::vector<Part> things;
  for (const DVec3& place : desk_places()) {
    for (const double side : {-1.0, 1.0}) {
      if (random.uniform() < 0.85) {
        add_pupils_things(things, m, place + DVec3(0.0, desk_height, side * 0.32), random);
      }
    }
  }
  add_object(model, "Pupils' things", things);
}

void add_bags(Model& model, const Materials& m) {
  const std::vector<DVec3> places = desk_places();
  std::vector<Part> others;
  int bag = 0;
  for (const std::size_t desk : {1U, 3U, 5U, 6U, 8U, 9U, 10U}) {
    const double side = bag % 2 == 0 ? 1.0 : -1.0;
    const int cloth = bag % 3 == 0 ? m.blue_cloth : m.grey_cloth;
    const DVec3 beside(0.05, 0.0, side * (0.5 * desk_width + 0.12));
    append(others, placed(school_bag(m, cloth), places[desk] + beside, 90.0 - 60.0 * side));
    ++bag;
  }
  add_object(model, "School bags", others);
  add_object(model, "Red school bag",
             placed(school_bag(m, m.red_cloth), places[4] + DVec3(-0.02, 0.0, 0.8), -60.0));
}

void add_coats(Model& model, const Materials& m) {
  constexpr double rail_y = 1.62;
  const std::array<int, 4> cloths = {m.blue_cloth, m.red_cloth, m.grey_cloth, m.blue_cloth};
  std::vector<Part> coats;
  Shape hooks;
  const double first_x = -2.25;
  for (int i = 0; i < 6; ++i) {
    const DVec3 hook(first_x + 0.42 * i, rail_y, half_z - 0.025);
    append(hooks, moved(tube(curve({{0, 0, 0},
                                    {0, 0.0, -0.05},
                                    {0, -0.02, -0.075},
                                    {0, 0.0, -0.095},
                                    {0, 0.03, -0.1}},
                                   3),
                             0.007, 10),
                        hook));
    append(hooks, moved(turned(cylinder(0.018, 0.006, 16), -90.0, {1, 0, 0}), hook));
    if (i != 2) {
      const Shape one = turned(coat(model.stream(620 + i)), 180.0);
      append(coats, {{cloths[i % cloths.size()],
                      with_uv_scale(moved(one, hook + DVec3(0.0, -0.015, -0.085)), 3.0), 70.0}});
    }
  }
  const Shape board =
      moved(rounded_box({2.5, 0.1, 0.025}, 0.008, 2), {first_x + 1.05, rail_y, half_z - 0.0125});
  add_object(model, "Coat rack", {{m.dark_wood, board}, {m.brass, hooks, 60.0}});
  add_object(model, "Coats", coats);
}

}  // namespace foveola::scenes::school
