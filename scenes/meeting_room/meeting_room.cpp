#include <cmath>
#include <numbers>

#include "scenes/builtin.h"
#include "scenes/modelling/patterns.h"
#include "scenes/modelling/props.h"

namespace foveola::scenes {
namespace {

constexpr double half_x = 6.0;
constexpr double half_z = 3.75;
constexpr double ceiling = 3.0;
constexpr double table_half_length = 3.3;
constexpr double table_half_width = 0.85;
constexpr double table_height = 0.75;
constexpr double seat_height = 0.46;

struct Materials {
  int floor = 0;
  int ceiling = 0;
  int wall = 0;
  int accent_wall = 0;
  int table = 0;
  int dark_wood = 0;
  int fabric = 0;
  int red_fabric = 0;
  int chrome = 0;
  int white_plastic = 0;
  int black_plastic = 0;
  int porcelain = 0;
  int paper = 0;
  int board = 0;
  int picture = 0;
  int clock = 0;
  int screen = 0;
  int lamp = 0;
  int daylight = 0;
  PlantMaterials plant;
};

Materials add_materials(Model& model) {
  Materials m;
  m.floor = add_textured_material(
      model, "floor boards", wood(512, 12, {0.42F, 0.26F, 0.13F}, {0.24F, 0.13F, 0.06F}, 21), 0.4F);
  m.ceiling = add_textured_material(model, "ceiling panels", ceiling_panels(512, 2, 22), 0.95F);
  m.wall =
      add_textured_material(model, "wall", plaster(512, {0.68F, 0.65F, 0.58F}, 0.06, 23), 0.95F);
  m.accent_wall = add_textured_material(model, "accent wall",
                                        plaster(512, {0.2F, 0.33F, 0.36F}, 0.08, 24), 0.95F);
  m.table = add_textured_material(
      model, "table top", wood(512, 6, {0.36F, 0.17F, 0.07F}, {0.17F, 0.07F, 0.03F}, 25), 0.25F);
  m.dark_wood = add_textured_material(
      model, "dark wood", wood(256, 2, {0.11F, 0.06F, 0.035F}, {0.05F, 0.03F, 0.02F}, 26), 0.5F);
  m.fabric = add_textured_material(
      model, "fabric", cloth(256, 1, {0.1F, 0.16F, 0.28F}, {0.1F, 0.16F, 0.28F}, 27), 0.95F);
  m.red_fabric = add_textured_material(
      model, "red fabric", cloth(256, 1, {0.5F, 0.06F, 0.04F}, {0.5F, 0.06F, 0.04F}, 28), 0.95F);
  m.chrome = add_material(
      model, {.name = "chrome", .base_color = Rgb(0.75F), .metallic = 1.0F, .roughness = 0.25F});
  m.white_plastic =
      add_material(model, {.name = "white plastic", .base_color = Rgb(0.7F), .roughness = 0.4F});
  m.black_plastic =
      add_material(model, {.name = "black plastic", .base_color = Rgb(0.03F), .roughness = 0.45F});
  m.porcelain = add_material(
      model, {.name = "porcelain", .base_color = {0.7F, 0.68F, 0.62F}, .roughness = 0.2F});
  m.paper = add_material(model, {.name = "paper", .base_color = {0.75F, 0.73F, 0.66F}});
  m.board = add_textured_material(model, "whiteboard", written_board(512, 29), 0.35F);
  m.picture = add_textured_material(model, "picture", landscape(256, 30), 0.6F);
  m.clock = add_textured_material(model, "clock face", clock_face(256), 0.5F);
  m.screen = add_material(model, {.name = "screen", .emission = {0.35F, 0.5F, 0.8F}});
  m.lamp = add_material(model, {.name = "lamp", .emission = {4.6F, 4.3F, 3.9F}});
  m.daylight = add_material(model, {.name = "daylight", .emission = {2.6F, 3.1F, 3.8F}});
  m.plant = add_plant_materials(model);
  return m;
}

void add_shell(Model& model, const Materials& m) {
  const DVec3 x(2.0 * half_x, 0.0, 0.0);
  const DVec3 y(0.0, ceiling, 0.0);
  const DVec3 z(0.0, 0.0, 2.0 * half_z);
  const DVec3 corner(-half_x, 0.0, -half_z);
  add_object(model, "Floor", {{m.floor, with_uv_scale(rectangle(corner + z, x, -z), 0.5)}});
  add_object(model, "Ceiling",
             {{m.ceiling, with_uv_scale(rectangle(corner + y, x, z), 1.0 / 1.2)}});
  Shape walls = rectangle(corner, x, y);
  append(walls, rectangle(corner + x + z, -x, y));
  append(walls, rectangle(corner + z, -z, y));
  add_object(model, "Walls", {{m.wall, with_uv_scale(walls, 0.4)}});
  add_object(model, "End wall", {{m.accent_wall, with_uv_scale(rectangle(corner + x, z, y), 0.4)}});
  Shape skirting;
  for (const double side : {-1.0, 1.0}) {
    append(skirting,
           moved(box(DVec3(2.0 * half_x, 0.1, 0.03)), {0.0, 0.05, side * (half_z - 0.015)}));
    append(skirting,
           moved(box(DVec3(0.03, 0.1, 2.0 * half_z)), {side * (half_x - 0.015), 0.05, 0.0}));
  }
  add_object(model, "Skirting", {{m.dark_wood, skirting}});
}

void add_lamps(Model& model, const Materials& m) {
  constexpr int rows = 3;
  constexpr int lamps_in_row = 6;
  const double half_long = 0.59;
  const double half_short = 0.29;
  Shape glow;
  Shape frames;
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < lamps_in_row; ++i) {
      const DVec3 middle(1.8 * (i - 0.5 * (lamps_in_row - 1)), ceiling, 2.4 * (row - 1));
      append(glow, moved(rectangle({-half_long, -0.02, -half_short}, {2.0 * half_long, 0.0, 0.0},
                                   {0.0, 0.0, 2.0 * half_short}),
                         middle));
      for (const double side : {-1.0, 1.0}) {
        append(frames, moved(box(DVec3(2.0 * half_long + 0.06, 0.05, 0.03)),
                             middle + DVec3(0.0, -0.025, side * (half_short + 0.015))));
        append(frames, moved(box(DVec3(0.03, 0.05, 2.0 * half_short)),
                             middle + DVec3(side * (half_long + 0.015), -0.025, 0.0)));
      }
    }
  }
  add_object(model, "Ceiling lamps", {{m.lamp, glow}, {m.white_plastic, frames}});
}

void add_windows(Model& model, const Materials& m) {
  constexpr int windows = 4;
  constexpr double half_width = 1.1;
  constexpr double sill = 0.9;
  constexpr double height = 1.6;
  constexpr double slat_spacing = 0.06;
  Shape panes;
  Shape frames;
  Shape slats;
  for (int i = 0; i < windows; ++i) {
    const double x = 2.8 * (i - 0.5 * (windows - 1));
    const DVec3 corner(x + half_width, sill, half_z - 0.02);
    append(panes, rectangle(corner, {-2.0 * half_width, 0.0, 0.0}, {0.0, height, 0.0}));
    for (const double side : {-1.0, 0.0, 1.0}) {
      append(frames, moved(box(DVec3(0.06, height, 0.06)),
                           {x + side * half_width, sill + 0.5 * height, half_z - 0.03}));
    }
    append(frames, moved(box(DVec3(2.0 * half_width + 0.3, 0.04, 0.2)), {x, sill, half_z - 0.1}));
    append(frames,
           moved(box(DVec3(2.0 * half_width + 0.1, 0.08, 0.1)), {x, sill + height, half_z - 0.05}));
    for (double y = sill + 0.1; y < sill + height - 0.05; y += slat_spacing) {
      const Shape slat = turned(box(DVec3(2.0 * half_width - 0.04, 0.003, 0.05)), 40.0, {1, 0, 0});
      append(slats, moved(slat, {x, y, half_z - 0.11}));
    }
  }
  add_object(model, "Windows", {{m.daylight, panes}, {m.white_plastic, frames}});
  add_object(model, "Blinds", {{m.white_plastic, slats}});
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

void add_table(Model& model, const Materials& m) {
  const double h = table_height;
  Shape top = deformed(lathe({{0.0, h - 0.05},
                              {0.5, h - 0.05},
                              {0.97, h - 0.05},
                              {0.985, h - 0.04},
                              {1.0, h - 0.015},
                              {0.998, h - 0.004},
                              {0.99, h},
                              {0.5, h},
                              {0.0, h}},
                             96),
                       on_table);
  top = with_uv_scale(with_projected_uvs(top, {0, 0, 1}, {1, 0, 0}), 0.5);
  Shape legs;
  for (const double x : {-2.3, 0.0, 2.3}) {
    append(legs, moved(box(DVec3(0.1, h - 0.05, 0.9)), {x, 0.5 * (h - 0.05), 0.0}));
  }
  append(legs, moved(box(DVec3(4.6, 0.3, 0.05)), {0.0, 0.45, 0.0}));
  add_object(model, "Table", {{m.table, top, 30.0}, {m.dark_wood, legs}});
}

/// A cushioned chair on four tube legs that stands on the origin and faces +Z.
struct Chair {
  Shape cushions;
  Shape frame;
  Shape rests;
};

Chair make_chair() {
  Chair chair;
  chair.cushions = moved(rounded_box({0.47, 0.08, 0.46}, 0.035, 3), {0.0, seat_height, 0.0});
  const Shape back = deformed(rounded_box({0.45, 0.44, 0.06}, 0.028, 3, 5), [](const DVec3& p) {
    return DVec3(p.x, p.y, p.z + 1.0 * p.x * p.x);
  });
  append(chair.cushions, moved(turned(back, -10.0, {1, 0, 0}), {0.0, seat_height + 0.33, -0.26}));
  for (const double side : {-1.0, 1.0}) {
    const double x = side * 0.23;
    append(chair.frame,
           tube({{x, 0.0, 0.24}, {x, 0.3, 0.22}, {x, seat_height + 0.2, 0.2}}, 0.013, 8));
    append(chair.frame, tube({{x, 0.0, -0.27},
                              {x, 0.3, -0.23},
                              {x, seat_height + 0.1, -0.22},
                              {x, seat_height + 0.3, -0.26}},
                             0.013, 8));
    append(chair.frame,
           tube({{x, seat_height - 0.02, 0.2}, {x, seat_height - 0.02, -0.22}}, 0.012, 8));
    append(chair.rests,
           moved(rounded_box({0.05, 0.03, 0.4}, 0.014, 2), {x, seat_height + 0.21, 0.02}));
  }
  append(chair.frame,
         tube({{-0.23, seat_height - 0.05, 0.0}, {0.23, seat_height - 0.05, 0.0}}, 0.012, 8));
  return chair;
}

std::vector<Part> placed(const Chair& chair, const Materials& m, int fabric, const DVec3& place,
                         double turn_deg) {
  const auto put = [&](const Shape& shape) { return moved(turned(shape, turn_deg), place); };
  return {{fabric, with_uv_scale(put(chair.cushions), 4.0), 50.0},
          {m.chrome, put(chair.frame), 50.0},
          {m.black_plastic, put(chair.rests), 50.0}};
}

void add_chairs(Model& model, const Materials& m) {
  const Chair chair = make_chair();
  int number = 1;
  const auto add = [&](double x, double z, double turn_deg) {
    add_object(model, "Chair " + std::to_string(number++),
               placed(chair, m, m.fabric, {x, 0.0, z}, turn_deg));
  };
  for (int i = 0; i < 7; ++i) {
    // Nobody leaves chairs in a straight line.
    const double askew_deg = 14.0 * std::sin(2.3 * i + 0.4);
    const double x = 0.82 * (i - 3);
    add(x, -1.22 - 0.05 * std::sin(1.7 * i), askew_deg);
    add(x, 1.22 + 0.06 * std::sin(2.9 * i), 180.0 - askew_deg);
  }
  add(table_half_length + 0.35, 0.05, -95.0);
  add(-table_half_length - 0.35, -0.1, 80.0);
  for (int i = 0; i < 6; ++i) {
    add(0.2 + 0.85 * i, -half_z + 0.42, 0.0);
  }
  for (int i = 0; i < 4; ++i) {
    add(2.4 + 0.85 * i, half_z - 0.55, 180.0);
  }
  add_object(model, "Red chair", placed(chair, m, m.red_fabric, {-0.3, 0.0, 2.75}, -130.0));
}

Shape laptop_body() {
  Shape shape = moved(rounded_box({0.34, 0.018, 0.24}, 0.006, 2), {0.0, 0.009, 0.0});
  const Shape lid = moved(box(DVec3(0.34, 0.22, 0.008)), {0.0, 0.11, 0.0});
  append(shape, moved(turned(lid, -15.0, {1, 0, 0}), {0.0, 0.015, -0.12}));
  return shape;
}

Shape laptop_screen() {
  const Shape screen = picture({-0.155, 0.015, 0.005}, {0.31, 0.0, 0.0}, {0.0, 0.19, 0.0});
  return moved(turned(screen, -15.0, {1, 0, 0}), {0.0, 0.015, -0.12});
}

void add_laptops(Model& model, const Materials& m) {
  struct Place {
    double x;
    double z;
    double turn_deg;
  };
  int number = 1;
  for (const Place& place : {Place{-2.35, 0.1, -60.0}, Place{-0.85, -0.5, 185.0},
                             Place{0.8, 0.52, 8.0}, Place{1.7, -0.5, 172.0}}) {
    const auto put = [&](const Shape& shape) {
      return moved(turned(shape, place.turn_deg), {place.x, table_height, place.z});
    };
    add_object(model, "Laptop " + std::to_string(number++),
               {{m.black_plastic, put(laptop_body())}, {m.screen, put(laptop_screen())}});
  }
}

void add_tableware(Model& model, const Materials& m) {
  const Shape jug = lathe({{0.0, 0.0},
                           {0.07, 0.0},
                           {0.085, 0.02},
                           {0.09, 0.09},
                           {0.06, 0.19},
                           {0.055, 0.22},
                           {0.075, 0.26},
                           {0.068, 0.26},
                           {0.048, 0.22},
                           {0.0, 0.2}},
                          32);
  const Shape cup = lathe({{0.0, 0.0},
                           {0.028, 0.0},
                           {0.04, 0.03},
                           {0.043, 0.085},
                           {0.039, 0.085},
                           {0.036, 0.03},
                           {0.0, 0.012}},
                          24);
  const Shape pad = box({-0.105, 0.0, -0.15}, {0.105, 0.008, 0.15});
  Shape cups;
  Shape pads;
  for (int i = 0; i < 7; ++i) {
    const double x = 0.82 * (i - 3);
    for (const double side : {-1.0, 1.0}) {
      append(cups, moved(cup, {x + 0.22, table_height, side * (0.45 - 0.03 * std::abs(i - 3))}));
      const double turn_deg = 10.0 * std::sin(4.1 * i + side);
      append(pads, moved(turned(pad, turn_deg), {x - 0.1, table_height, side * 0.58}));
    }
  }
  add_object(model, "Cups", {{m.porcelain, cups, 60.0}});
  add_object(model, "Notepads", {{m.paper, pads}});
  add_object(model, "Jugs",
             {{m.chrome, moved(jug, {-1.2, table_height, 0.0}), 50.0},
              {m.chrome, moved(jug, {1.5, table_height, 0.05}), 50.0}});
}

void add_walls_things(Model& model, const Materials& m) {
  constexpr double board_width = 3.2;
  const DVec3 board_corner(half_x - 0.05, 0.95, -0.5 * board_width);
  add_object(model, "Whiteboard",
             {{m.board, picture(board_corner, {0.0, 0.0, board_width}, {0.0, 1.6, 0.0})},
              {m.chrome, box({half_x - 0.045, 0.9, -0.5 * board_width - 0.05},
                             {half_x, 2.6, 0.5 * board_width + 0.05})}});
  const double wall = -half_z;
  add_object(model, "Clock",
             {{m.clock, picture({-4.0, 1.75, wall + 0.05}, {0.7, 0.0, 0.0}, {0.0, 0.7, 0.0})},
              {m.black_plastic, box({-4.05, 1.7, wall}, {-3.25, 2.5, wall + 0.045})}});
  int number = 1;
  for (const double x : {1.2, 3.6}) {
    add_object(model, "Picture " + std::to_string(number++),
               {{m.picture, picture({x, 1.35, wall + 0.035}, {1.2, 0.0, 0.0}, {0.0, 0.8, 0.0})},
                {m.dark_wood, box({x - 0.06, 1.29, wall}, {x + 1.26, 2.21, wall + 0.03})}});
  }
  const DVec3 door(-half_x, 0.0, -2.4);
  add_object(model, "Door",
             {{m.dark_wood, box(door, door + DVec3(0.06, 2.1, 1.0))},
              {m.white_plastic, box(door + DVec3(0.0, 0.0, -0.1), door + DVec3(0.09, 2.2, 0.0))},
              {m.white_plastic, box(door + DVec3(0.0, 0.0, 1.0), door + DVec3(0.09, 2.2, 1.1))},
              {m.chrome, moved(ellipsoid({0.05, 0.03, 0.03}, 16), door + DVec3(0.1, 1.0, 0.9))}});
  const Shape cabinet = box({-half_x, 0.0, 0.2}, {-half_x + 0.5, 0.9, 3.0});
  add_object(model, "Cabinet", {{m.dark_wood, cabinet}});
}

void add_plants(Model& model, const Materials& m) {
  const PlantSize tall{.pot_radius = 0.28,
                       .pot_height = 0.5,
                       .stem_height = 1.15,
                       .leaf_length = 0.42,
                       .stems = 11,
                       .leaves_per_stem = 6};
  add_object(model, "Tall plant",
             moved(potted_plant(tall, m.plant, 300), {-1.2, 0.0, -half_z + 0.65}));
  add_object(model, "Corner plant",
             moved(potted_plant(tall, m.plant, 301), {half_x - 0.7, 0.0, -half_z + 0.7}));
  const PlantSize small{
      .pot_radius = 0.13, .pot_height = 0.16, .stem_height = 0.3, .leaf_length = 0.2};
  add_object(model, "Table plant",
             moved(potted_plant(small, m.plant, 302), {0.15, table_height, 0.0}));
}

void add_projector(Model& model, const Materials& m) {
  Shape projector = moved(rounded_box({0.42, 0.16, 0.36}, 0.04, 3), {1.4, ceiling - 0.5, 0.0});
  append(projector, moved(cylinder(0.025, 0.42, 16), {1.4, ceiling - 0.42, 0.0}));
  const Shape lens =
      moved(turned(cylinder(0.06, 0.05, 24), -90.0, {0, 0, 1}), {1.6, ceiling - 0.5, 0.0});
  add_object(model, "Projector", {{m.white_plastic, projector}, {m.black_plastic, lens}});
}

}  // namespace

Model make_meeting_room() {
  Model model;
  const Materials materials = add_materials(model);
  add_shell(model, materials);
  add_lamps(model, materials);
  add_windows(model, materials);
  add_table(model, materials);
  add_chairs(model, materials);
  add_laptops(model, materials);
  add_tableware(model, materials);
  add_walls_things(model, materials);
  add_plants(model, materials);
  add_projector(model, materials);
  model.cameras.push_back({"Seat side", {-4.2F, 1.55F, 1.9F}, {radians(68.0), 0.0}});
  return model;
}

}  // namespace foveola::scenes
