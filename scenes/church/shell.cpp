// The church's floor and walls.
#include <cmath>
#include <numbers>

#include "renderer/base/angles.h"
#include "scenes/church/parts.h"
#include "scenes/modelling/architecture.h"

namespace foveola::scenes::church {
namespace {

constexpr double masonry_repeats_per_metre = 0.4;
constexpr double window_wall = 0.7;  ///< thickness of the apse's walls too
constexpr double rosette_x = -4.0;
constexpr double rosette_half = 1.9;
constexpr double band_half = 0.5;
constexpr double end_height = 7.5;  ///< height of the walls that end the aisles

/// A horizontal piece of floor between two corners.
Shape floor_piece(const DVec2& lower, const DVec2& upper) {
  return rectangle({lower.x, 0.0, upper.y}, {upper.x - lower.x, 0.0, 0.0},
                   {0.0, 0.0, lower.y - upper.y});
}

Shape window_wall_shape(const WindowPlace& place) {
  const Shape shape = arch({.bay_width = place.wall_width,
                            .opening_width = place.width,
                            .springing_height = place.jamb,
                            .height = place.wall_height,
                            .thickness = window_wall},
                           16);
  return moved(turned(shape, place.turn_deg), place.sill);
}

/// The wall across the nave at x = `middle_x`, with an arch at `foot`.
Shape cross_wall(const ArchBay& opening, double middle_x, double foot) {
  return moved(turned(arch(opening, 24), 90.0), {middle_x, foot, 0.0});
}

Shape west_wall() {
  const double middle_x = -half_length - 0.5 * wall;
  const double below_rose = 5.5;
  Shape shape = cross_wall({.bay_width = 2.0 * arcade_z,
                            .opening_width = 2.2,
                            .springing_height = 2.1,
                            .height = below_rose,
                            .thickness = wall},
                           middle_x, 0.0);
  const double height = nave_top - below_rose;
  const Shape rose = wall_with_round_hole(2.0 * arcade_z, height, rose_radius, wall);
  append(shape, moved(turned(rose, 90.0), {-half_length, rose_height, 0.0}));
  for (const double side : {-1.0, 1.0}) {
    append(shape, moved(box(DVec3(wall, end_height, 4.3)),
                        {middle_x, 0.5 * end_height, side * (arcade_z + 2.15)}));
  }
  return shape;
}

Shape east_walls() {
  const double middle_x = half_length + 0.5 * wall;
  Shape shape = cross_wall({.bay_width = 2.0 * arcade_z + 0.4,
                            .opening_width = 5.3,
                            .springing_height = 4.7,
                            .height = nave_top,
                            .thickness = wall},
                           middle_x, 0.0);
  for (const double side : {-1.0, 1.0}) {
    append(shape, moved(box(DVec3(wall, end_height, 4.1)),
                        {middle_x, 0.5 * end_height, side * (arcade_z + 2.25)}));
  }
  return shape;
}

}  // namespace

DVec3 apse_corner(int number) {
  const double angle = radians(-90.0 + 36.0 * number);
  return {apse_x + apse_radius * std::cos(angle), choir_floor, apse_radius * std::sin(angle)};
}

std::vector<WindowPlace> aisle_windows() {
  std::vector<WindowPlace> places;
  for (int i = 0; i < bays; ++i) {
    const double x = bay * (i - 0.5 * (bays - 1));
    for (const double side : {-1.0, 1.0}) {
      places.push_back({.sill = {x, 1.9, side * (aisle_z + 0.5 * wall)},
                        .turn_deg = side < 0.0 ? 0.0 : 180.0,
                        .width = 1.25,
                        .jamb = 2.5,
                        .wall_width = bay,
                        .wall_height = 5.6});
    }
  }
  return places;
}

std::vector<WindowPlace> clerestory_windows() {
  std::vector<WindowPlace> places;
  for (int i = 0; i < bays; ++i) {
    const double x = bay * (i - 0.5 * (bays - 1));
    for (const double side : {-1.0, 1.0}) {
      places.push_back({.sill = {x, gallery + 0.3, side * arcade_z},
                        .turn_deg = side < 0.0 ? 0.0 : 180.0,
                        .width = 1.9,
                        .jamb = 2.0,
                        .wall_width = bay,
                        .wall_height = nave_top - gallery - 0.3});
    }
  }
  return places;
}

std::vector<WindowPlace> apse_windows() {
  std::vector<WindowPlace> places;
  for (int i = 0; i < 5; ++i) {
    const DVec3 middle = 0.5 * (apse_corner(i) + apse_corner(i + 1));
    const DVec3 inwards = glm::normalize(DVec3(apse_x, choir_floor, 0.0) - middle);
    places.push_back({.sill = middle - 0.5 * window_wall * inwards + DVec3(0.0, 1.6, 0.0),
                      .turn_deg = degrees(std::atan2(inwards.x, inwards.z)),
                      .width = 0.95,
                      .jamb = 2.55,
                      .wall_width = glm::distance(apse_corner(i), apse_corner(i + 1)),
                      .wall_height = 3.6});
  }
  return places;
}

void add_floor(Model& model, const Materials& m) {
  const double x0 = rosette_x - rosette_half;
  const double x1 = rosette_x + rosette_half;
  Shape slabs = floor_piece({-half_length, -aisle_z}, {half_length, -rosette_half});
  append(slabs, floor_piece({-half_length, rosette_half}, {half_length, aisle_z}));
  for (const double side : {-1.0, 1.0}) {
    const double near = std::min(side * band_half, side * rosette_half);
    const double far = std::max(side * band_half, side * rosette_half);
    append(slabs, floor_piece({-half_length, near}, {x0, far}));
    append(slabs, floor_piece({x1, near}, {half_length, far}));
  }
  slabs = with_projected_uvs(slabs, {0.3, 0, 0}, {0, 0, 0.3});
  Shape band = floor_piece({-half_length, -band_half}, {x0, band_half});
  append(band, floor_piece({x1, -band_half}, {half_length, band_half}));
  const DVec3 corner(x0, 0.0, rosette_half);
  const Shape rosette = picture(corner, {2.0 * rosette_half, 0, 0}, {0, 0, -2.0 * rosette_half});
  add_object(model, "Floor", {{m.slabs, slabs}});
  // One disc a metre, and the band's two edges at v = 0 and 1.
  band = with_projected_uvs(band, {1, 0, 0}, {0, 0, 0.5 / band_half});
  for (DVec2& uv : band.uvs) {
    uv.y += 0.5;
  }
  add_object(model, "Inlaid path", {{m.band, band}});
  add_object(model, "Rosette pavement", {{m.rosette, rosette}});
  Shape steps;
  for (int i = 0; i < 3; ++i) {
    const double height = choir_floor / 3.0;
    const double inside_the_next = 0.02 * (2 - i);
    append(steps, box({half_length - 1.05 + 0.35 * i, i * height, -2.68},
                      {half_length + 0.3 + inside_the_next, (i + 1) * height, 2.6}));
  }
  append(steps, box({half_length + 0.3, 0.0, -2.68}, {half_length + wall, choir_floor, 2.64}));
  append(steps, box({half_length + wall, 0.0, -apse_radius - 0.2},
                    {apse_x + apse_radius + 0.3, choir_floor, apse_radius + 0.2}));
  add_object(model, "Choir steps", {{m.white_marble, with_uv_scale(steps, 0.5)}});
}

void add_walls(Model& model, const Materials& m) {
  Shape arcade;
  for (int i = 0; i < bays; ++i) {
    for (const double side : {-1.0, 1.0}) {
      const Shape span = arch({.bay_width = bay,
                               .opening_width = arcade_opening,
                               .height = gallery - column_height,
                               .thickness = wall},
                              24);
      append(arcade, moved(span, {bay * (i - 0.5 * (bays - 1)), column_height, side * arcade_z}));
    }
  }
  Shape outer = west_wall();
  append(outer, east_walls());
  for (const double side : {-1.0, 1.0}) {
    append(arcade,
           moved(box(DVec3(2.0 * half_length, 0.3, wall)), {0.0, gallery + 0.15, side * arcade_z}));
    append(outer, moved(box(DVec3(2.0 * half_length + 2.0 * wall, 1.9, wall)),
                        {0.0, 0.95, side * (aisle_z + 0.5 * wall)}));
  }
  for (const WindowPlace& place : clerestory_windows()) {
    append(arcade, window_wall_shape(place));
  }
  for (const WindowPlace& place : aisle_windows()) {
    append(outer, window_wall_shape(place));
  }
  add_object(model, "Nave walls", {{m.masonry, with_uv_scale(arcade, masonry_repeats_per_metre)}});
  add_object(model, "Outer walls", {{m.masonry, with_uv_scale(outer, masonry_repeats_per_metre)}});
}

void add_apse_walls(Model& model, const Materials& m) {
  Shape shape;
  for (const WindowPlace& place : apse_windows()) {
    append(shape, window_wall_shape(place));
    const Shape below = moved(box(DVec3(place.wall_width, 1.6, window_wall)), {0.0, -0.8, 0.0});
    append(shape, moved(turned(below, place.turn_deg), place.sill));
  }
  for (const double side : {-1.0, 1.0}) {
    append(shape,
           moved(box(DVec3(apse_x - half_length - 0.3, 5.4, wall)),
                 {0.5 * (apse_x + half_length + 0.3), 2.7, side * (apse_radius + 0.5 * wall)}));
  }
  add_object(model, "Apse walls", {{m.masonry, with_uv_scale(shape, masonry_repeats_per_metre)}});
}

}  // namespace foveola::scenes::church
