#include <cmath>
#include <numbers>

#include "scenes/studio_car/panels.h"
#include "scenes/studio_car/studio.h"

namespace foveola::scenes::studio {
namespace {

constexpr double backdrop_turn_deg = 50.0;  ///< the backdrop stands across the camera's view

/// A bar whose ends lie inside the chords, but not in their middle, where other bars end too.
Shape strut(const DVec3& from, const DVec3& to) {
  const DVec3 end = 0.012 * glm::normalize(to - from);
  return tube({from + end, to - end}, 0.01, 6);
}

/// Bars along two chords with a zigzag between them, along X through `z`.
Shape truss_bay(double z) {
  Shape truss;
  constexpr double height = 0.3;
  for (const double side : {-0.15, 0.15}) {
    for (const double y : {lower_chord, lower_chord + height}) {
      append(truss, tube({{-half_room, y, z + side}, {half_room, y, z + side}}, 0.025, 14));
    }
    for (int k = 0; k < 32; ++k) {
      const double from = -half_room + 0.5 * k;
      const DVec3 top(from + 0.25, lower_chord + height, z + side);
      append(truss, strut({from, lower_chord, z + side}, top));
      append(truss, strut(top, {from + 0.5, lower_chord, z + side}));
    }
  }
  for (int k = 0; k < 32; ++k) {
    const double from = -half_room + 0.25 + 0.5 * k;
    const double lean = k % 2 == 0 ? 0.15 : -0.15;
    append(truss,
           strut({from - 0.25, lower_chord, z - lean}, {from + 0.25, lower_chord, z + lean}));
  }
  return truss;
}

/// A round duct of rolled sheet with seams, along X under the ceiling.
Shape duct() {
  constexpr double radius = 0.28;
  const double length = 2.0 * half_room;
  const int rings = 16;
  std::vector<DVec2> outline;
  for (int i = 0; i <= rings; ++i) {
    const double at = length * i / rings;
    outline.insert(outline.end(), {{radius, at - 0.03},
                                   {radius + 0.012, at - 0.02},
                                   {radius + 0.012, at + 0.02},
                                   {radius, at + 0.03}});
  }
  return moved(turned(lathe(outline, 48), 90.0, {0, 0, 1}), {half_room, 0.0, 0.0});
}

void add_wall_things(Model& model, const Materials& m) {
  const auto framed = [&](const char* name, int picture_material, const DVec3& size,
                          double turn_deg, const DVec3& place) {
    const Shape face = picture({-0.5 * size.x + 0.04, -0.5 * size.y + 0.04, 0.012},
                               {size.x - 0.08, 0, 0}, {0, size.y - 0.08, 0});
    Shape frame = box({-0.5 * size.x, -0.5 * size.y, -0.01}, {0.5 * size.x, 0.5 * size.y, 0.01});
    for (const double side : {-1.0, 1.0}) {
      append(frame, moved(rounded_box({size.x, 0.04, 0.05}, 0.008, 2),
                          {0.0, side * (0.5 * size.y - 0.02), 0.01}));
      append(frame, moved(rounded_box({0.04, size.y - 0.079, 0.046}, 0.008, 2),
                          {side * (0.5 * size.x - 0.02), 0.0, 0.01}));
    }
    add_object(model, name,
               placed({{picture_material, face}, {m.black_steel, frame, 40.0}}, turn_deg, place));
  };
  framed("Poster 1", m.poster, {1.5, 1.0, 0.0}, -90.0, {half_room - 0.02, 2.1, 0.6});
  framed("Poster 2", m.poster, {1.5, 1.0, 0.0}, 180.0, {4.9, 2.1, half_room - 0.02});
  Shape rim = turned(
      lathe({{0.17, 0.0}, {0.21, 0.0}, {0.215, 0.03}, {0.2, 0.045}, {0.19, 0.03}, {0.17, 0.012}},
            64),
      90.0, {1, 0, 0});
  Shape face;
  for (int i = 0; i <= 64; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 64.0;
    const DVec2 at(std::cos(angle), std::sin(angle));
    face.positions.emplace_back(0.195 * at.x, 0.195 * at.y, 0.014);
    face.uvs.emplace_back(0.5 + 0.5 * at.x, 0.5 - 0.5 * at.y);
    if (i > 0) {
      face.triangles.push_back(
          {static_cast<std::uint32_t>(i - 1), static_cast<std::uint32_t>(i), 65});
    }
  }
  face.positions.emplace_back(0.0, 0.0, 0.014);
  face.uvs.emplace_back(0.5, 0.5);
  add_object(
      model, "Wall clock",
      placed({{m.clock, face}, {m.black_steel, rim, 45.0}}, 180.0, {0.2, 3.0, half_room - 0.001}));
}

/// Slats of a roller door in guides, on the wall at -X.
void add_rolling_door(Model& model, const Materials& m) {
  const DVec3 door(-half_room, 0.0, 3.5);
  Shape slats;
  for (int i = 0; i < 28; ++i) {
    const Shape slat = rounded_box({0.05, 0.107, 3.4}, 0.018, 2);
    append(slats, moved(slat, door + DVec3(0.03, 0.06 + 0.107 * i, 1.7)));
  }
  Shape frame;
  for (const double z : {-0.05, 3.45}) {
    append(frame, moved(rounded_box({0.14, 3.1, 0.1}, 0.01, 2), door + DVec3(0.07, 1.55, z)));
  }
  append(frame, moved(rounded_box({0.4, 0.42, 3.7}, 0.03, 3), door + DVec3(0.2, 3.25, 1.7)));
  append(frame, moved(rounded_box({0.03, 0.04, 0.3}, 0.01, 3), door + DVec3(0.07, 0.9, 1.7)));
  add_object(model, "Rolling door", {{m.aluminium, slats, 40.0}, {m.galvanised, frame, 40.0}});
}

/// The roof light's opening in the ceiling, between two trusses.
constexpr DVec2 roof_light_lower(-4.0, -5.4);  ///< x and z
constexpr DVec2 roof_light_upper(4.0, -3.6);

/// The ceiling around the roof light, seen from below.
Shape ceiling_with_opening() {
  const auto piece = [](double x0, double z0, double x1, double z1) {
    return rectangle({x0, ceiling, z0}, {x1 - x0, 0.0, 0.0}, {0.0, 0.0, z1 - z0});
  };
  const DVec2& lower = roof_light_lower;
  const DVec2& upper = roof_light_upper;
  Shape shape = piece(-half_room, -half_room, half_room, lower.y);
  append(shape, piece(-half_room, upper.y, half_room, half_room));
  append(shape, piece(-half_room, lower.y, lower.x, upper.y));
  append(shape, piece(upper.x, lower.y, half_room, upper.y));
  return shape;
}

/// The sides of the opening and the bars across it, without panes.
void add_roof_light(Model& model, const Materials& m) {
  constexpr double depth = 0.3;
  const DVec2& lower = roof_light_lower;
  const DVec3 x(roof_light_upper.x - lower.x, 0.0, 0.0);
  const DVec3 y(0.0, depth, 0.0);
  const DVec3 z(0.0, 0.0, roof_light_upper.y - lower.y);
  const DVec3 corner(lower.x, ceiling, lower.y);
  Shape sides = rectangle(corner, x, y);
  append(sides, rectangle(corner + x + z, -x, y));
  append(sides, rectangle(corner + z, -z, y));
  append(sides, rectangle(corner + x, z, y));
  Shape bars;
  constexpr int panes = 8;
  for (int i = 1; i < panes; ++i) {
    append(bars, moved(rounded_box({0.05, 0.09, z.z + 0.02}, 0.01, 2),
                       corner + (1.0 * i / panes) * x + 0.7 * y + 0.5 * z));
  }
  append(bars, moved(rounded_box({x.x + 0.02, 0.07, 0.05}, 0.01, 2),
                     corner + 0.5 * x + 0.7 * y + 0.5 * z));
  add_object(model, "Roof light", {{m.white_paint, sides}, {m.black_steel, bars, 40.0}});
}

}  // namespace

void add_room(Model& model, const Materials& m) {
  const DVec3 x(2.0 * half_room, 0.0, 0.0);
  const DVec3 y(0.0, ceiling, 0.0);
  const DVec3 z(0.0, 0.0, 2.0 * half_room);
  const DVec3 corner(-half_room, 0.0, -half_room);
  add_object(model, "Floor", {{m.concrete, with_uv_scale(rectangle(corner + z, x, -z), 0.3)}});
  add_object(model, "Ceiling", {{m.ceiling, with_uv_scale(ceiling_with_opening(), 0.25)}});
  Shape walls = rectangle(corner, x, y);
  append(walls, rectangle(corner + x + z, -x, y));
  append(walls, rectangle(corner + z, -z, y));
  append(walls, rectangle(corner + x, z, y));
  add_object(model, "Walls", {{m.brick, with_uv_scale(walls, 0.8)}});
  Shape skirting;
  for (const double side : {-1.0, 1.0}) {
    append(skirting, moved(rounded_box({2.0 * half_room, 0.12, 0.03}, 0.01, 3),
                           {0.0, 0.06, side * (half_room - 0.014)}));
    append(skirting, moved(rounded_box({0.03, 0.12, 2.0 * half_room - 0.06}, 0.01, 3),
                           {side * (half_room - 0.014), 0.06, 0.0}));
  }
  // Conduits down the walls to socket boxes.
  Shape conduits;
  for (const double at : {-4.0, 2.6, 6.0}) {
    append(conduits,
           tube({{half_room - 0.03, 1.1, at}, {half_room - 0.03, ceiling, at}}, 0.014, 12));
    append(conduits,
           tube({{at, 0.4, half_room - 0.03}, {at, ceiling, half_room - 0.03}}, 0.014, 12));
    append(conduits,
           moved(rounded_box({0.06, 0.16, 0.12}, 0.012, 3), {half_room - 0.03, 1.05, at}));
    append(conduits, moved(rounded_box({0.12, 0.16, 0.06}, 0.012, 3), {at, 0.4, half_room - 0.03}));
  }
  add_object(model, "Skirting and conduits",
             {{m.black_steel, skirting, 40.0}, {m.galvanised, conduits, 45.0}});
  add_roof_light(model, m);
  add_wall_things(model, m);
  add_rolling_door(model, m);
}

void add_ceiling_rig(Model& model, const Materials& m) {
  Shape truss;
  for (int i = -2; i <= 2; ++i) {
    append(truss, truss_bay(3.0 * i));
  }
  add_object(model, "Truss", {{m.aluminium, truss, 45.0}});
  add_object(model, "Ventilation duct",
             {{m.galvanised, moved(duct(), {0.0, ceiling - 0.36, 4.5}), 40.0}});
  Shape housings;
  Shape tubes;
  for (const double x : {-4.5, 4.5}) {
    for (const double z : {-1.5, 1.5}) {
      append(housings, moved(rounded_box({1.5, 0.06, 0.24}, 0.02, 3), {x, ceiling - 0.03, z}));
      for (const double side : {-0.05, 0.05}) {
        append(tubes,
               tube({{x - 0.7, ceiling - 0.075, z + side}, {x + 0.7, ceiling - 0.075, z + side}},
                    0.013, 16));
      }
    }
  }
  add_object(model, "Work lights", {{m.white_paint, housings, 45.0}, {m.work_light, tubes, 50.0}});
}

void add_backdrop(Model& model, const Materials& m) {
  constexpr double width = 9.0;
  constexpr double near_edge = 3.1;
  constexpr double bend_from = -3.0;
  constexpr double bend_radius = 1.6;
  constexpr double height = 4.2;
  std::vector<DVec2> profile = {{near_edge, 0.004}};
  constexpr int steps = 48;
  for (int i = 0; i <= steps; ++i) {
    const double angle = 0.5 * std::numbers::pi * i / steps;
    profile.emplace_back(bend_from - bend_radius * std::sin(angle),
                         0.004 + bend_radius * (1.0 - std::cos(angle)));
  }
  profile.emplace_back(bend_from - bend_radius, height);
  const int rows = static_cast<int>(profile.size()) - 1;
  const Shape sheet = patch(1, rows, [&](double u, double v) {
    const DVec2& at = profile[static_cast<std::size_t>(std::lround(v * rows))];
    return DVec3((u - 0.5) * width, at.y, at.x);
  });
  const double behind = bend_from - bend_radius - 0.1;
  const Shape roll =
      moved(tube({{-0.5 * width - 0.1, height, 0.0}, {0.5 * width + 0.1, height, 0.0}}, 0.095, 40),
            {0.0, 0.0, behind});
  Shape hangers =
      tube({{-0.5 * width - 0.35, height, behind}, {0.5 * width + 0.35, height, behind}}, 0.03, 16);
  for (const double x : {-0.5 * width - 0.25, 0.5 * width + 0.25}) {
    append(hangers, moved(rounded_box({0.04, 0.2, 0.2}, 0.015, 3), {x, height, behind}));
    append(hangers, tube({{x, height + 0.1, behind}, {x, ceiling, behind}}, 0.008, 8));
  }
  add_object(model, "Backdrop",
             {{m.backdrop, turned(sheet, backdrop_turn_deg), 40.0},
              {m.white_paint, turned(roll, backdrop_turn_deg), 50.0},
              {m.black_steel, turned(hangers, backdrop_turn_deg), 50.0}});
  const Shape disc = lathe({{2.95, 0.0},
                            {2.95, turntable_height - 0.008},
                            {2.948, turntable_height - 0.003},
                            {2.942, turntable_height},
                            {0.0, turntable_height}},
                           192);
  const Shape strip = lathe({{2.952, 0.012}, {2.96, 0.014}, {2.96, 0.04}, {2.952, 0.042}}, 192);
  add_object(model, "Turntable", {{m.turntable, disc, 30.0}, {m.aluminium, strip, 45.0}});
}

}  // namespace foveola::scenes::studio
