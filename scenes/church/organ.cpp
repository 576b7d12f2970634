// The west end of the church: the organ on its loft, and the door below.
#include <cmath>

#include "scenes/church/parts.h"
#include "scenes/modelling/architecture.h"
#include "scenes/modelling/props.h"

namespace foveola::scenes::church {
namespace {

constexpr double loft_half_z = arcade_z - 0.5 * wall;
constexpr double west = -half_length;

/// A pipe with its conical foot and mouth, standing on the origin; the mouth is at +Z.
Shape organ_pipe(double radius, double length) {
  const double foot = 3.2 * radius + 0.12;
  Shape pipe = lathe({{0.0, 0.0},
                      {0.25 * radius, 0.0},
                      {radius, foot},
                      {radius, foot + length},
                      {0.9 * radius, foot + length},
                      {0.9 * radius, foot + length - radius},
                      {0.0, foot + length - radius}},
                     10);
  return deformed(pipe, [&](const DVec3& p) {
    const bool at_mouth = p.z > 0.8 * radius && std::abs(p.y - foot) < 1e-9;
    return at_mouth ? DVec3(p.x, p.y, 0.75 * radius) : p;
  });
}

/// A row of pipes side by side around the origin, whose middle one is longest, and the case that
/// holds them: foot and cornice.
struct PipeField {
  Shape pipes;
  Shape wood;
};
PipeField pipe_field(int pipes, double longest, double step, double radius) {
  PipeField field;
  const double half_width = 1.05 * radius * pipes;
  for (int i = 0; i < pipes; ++i) {
    const double from_middle = std::abs(i - 0.5 * (pipes - 1));
    append(field.pipes, moved(organ_pipe(radius, longest - step * from_middle),
                              {2.1 * radius * (i - 0.5 * (pipes - 1)), 0.0, 0.0}));
  }
  const double top = longest + 3.2 * radius + 0.12 + 0.35;
  for (const double side : {-1.0, 1.0}) {
    append(field.wood,
           moved(box(DVec3(0.08, top, 0.34)), {side * (half_width + 0.04), 0.5 * top, -0.03}));
  }
  append(field.wood,
         moved(box(DVec3(2.0 * half_width + 0.02, top, 0.04)), {0.0, 0.5 * top, -0.175}));
  const double cornice = 2.0 * half_width + 0.3;
  append(field.wood, moved(box(DVec3(cornice, 0.1, 0.5)), {0.0, top + 0.05, 0.0}));
  append(field.wood, moved(box(DVec3(cornice + 0.12, 0.07, 0.6)), {0.0, top + 0.135, 0.0}));
  return field;
}

void add_loft(Model& model, const Materials& m) {
  const double middle_x = 0.5 * (west + loft_edge_x);
  const double depth = loft_edge_x - west;
  Shape wood = moved(box(DVec3(depth, 0.3, 2.0 * loft_half_z)), {middle_x, loft_floor - 0.15, 0.0});
  const double edge = loft_edge_x - 0.12;
  for (const double height : {0.06, 0.98}) {
    append(wood, moved(box(DVec3(0.2, 0.12, 2.0 * loft_half_z)), {edge, loft_floor + height, 0.0}));
  }
  constexpr int posts = 19;
  const Shape post = baluster(0.82, 8);
  for (int i = 0; i < posts; ++i) {
    append(wood, moved(post, {edge, loft_floor + 0.11, 0.32 * (i - 0.5 * (posts - 1))}));
  }
  for (const double z : {-2.4, -0.8, 0.8, 2.4}) {
    append(wood, moved(box(DVec3(depth - 0.1, 0.2, 0.2)), {middle_x, loft_floor - 0.4, z}));
  }
  Shape columns;
  for (const double z : {-2.4, 2.4}) {
    append(columns, moved(column({.radius = 0.16, .height = loft_floor - 0.5, .slab = 0.42}, 12),
                          {loft_edge_x - 0.35, 0.0, z}));
  }
  add_object(model, "Organ loft", {{m.dark_oak, wood}, {m.red_marble, columns, 30.0}});
}

}  // namespace

void add_organ(Model& model, const Materials& m) {
  add_loft(model, m);
  const double case_x = west + 0.75;
  Shape pipes;
  Shape wood = box({west + 0.25, loft_floor, -2.75}, {west + 1.2, loft_floor + 1.3, 2.75});
  append(wood, box({west + 0.2, loft_floor + 1.3, -2.85}, {west + 1.3, loft_floor + 1.38, 2.85}));
  const auto put = [&](const PipeField& field, double z) {
    const DVec3 place(case_x, loft_floor + 1.38, z);
    append(pipes, moved(turned(field.pipes, 90.0), place));
    append(wood, moved(turned(field.wood, 90.0), place));
  };
  for (const double side : {-1.0, 1.0}) {
    put(pipe_field(7, 2.3, 0.12, 0.075), side * 2.15);
    put(pipe_field(9, 1.15, 0.05, 0.042), side * 1.0);
  }
  put(pipe_field(7, 0.95, -0.05, 0.05), 0.0);
  // The console: keys, and a bench before them.
  Shape keys;
  for (int row = 0; row < 2; ++row) {
    append(wood, moved(box(DVec3(0.2, 0.05, 1.1)),
                       {west + 1.3 - 0.12 * row, loft_floor + 0.72 + 0.12 * row, 0.0}));
    append(keys, moved(box(DVec3(0.14, 0.02, 1.0)),
                       {west + 1.33 - 0.12 * row, loft_floor + 0.755 + 0.12 * row, 0.0}));
  }
  append(wood, box({west + 1.6, loft_floor, -0.6}, {west + 1.95, loft_floor + 0.5, 0.6}));
  add_object(model, "Organ", {{m.oak, wood}, {m.tin, pipes, 45.0}, {m.linen, keys}});
}

void add_west_door(Model& model, const Materials& m) {
  const double x = west - 0.35;
  const double radius = 1.1;
  const double springing = 2.1;
  // The leaves reach behind the round arch; the wall hides their corners.
  Shape wood = moved(box(DVec3(0.08, springing + radius + 0.05, 2.0 * radius + 0.1)),
                     {x, 0.5 * (springing + radius + 0.05), 0.0});
  Shape iron;
  for (const double side : {-1.0, 1.0}) {
    for (int i = 0; i < 5; ++i) {
      append(wood, moved(box(DVec3(0.05, springing + radius, 0.03)),
                         {x + 0.05, 0.5 * (springing + radius), side * (0.02 + 0.24 * i)}));
    }
    for (const double y : {0.5, 1.4, 2.2}) {
      append(iron, moved(box(DVec3(0.03, 0.07, 0.95)), {x + 0.085, y, side * 0.6}));
      append(iron, moved(ellipsoid({0.03, 0.09, 0.09}, 12), {x + 0.085, y, side * 0.2}));
    }
  }
  append(iron, moved(turned(torus(0.08, 0.014, 20, 8), 90.0, {0, 0, 1}), {x + 0.1, 1.1, -0.12}));
  add_object(model, "West door", {{m.dark_oak, wood}, {m.iron, iron}});
  Shape surround = box({west - wall, -0.2, -radius - 0.1}, {west + 0.02, 0.02, radius + 0.1});
  for (const double out : {0.0, 0.16, 0.32}) {
    const auto path = round_arch_path(radius + out, springing + 0.02, 18);
    append(surround, moved(turned(swept(path, rib_profile(0.16, 0.13), {0, 0, 1}), 90.0),
                           {west, springing, 0.0}));
  }
  add_object(model, "West door, surround", {{m.limestone, surround, 30.0}});
}

}  // namespace foveola::scenes::church
