// What the parts of the meeting room share: its measures, its materials, and the functions that
// make them.
//
// The whiteboard hangs on the wall at +X, the windows look towards +Z, the door is at -X.
#pragma once

#include "scenes/modelling/model.h"
#include "scenes/modelling/props.h"

namespace foveola::scenes::meeting {

constexpr double half_x = 6.0;
constexpr double half_z = 3.75;
constexpr double ceiling = 3.0;
constexpr double table_half_length = 3.3;
constexpr double table_half_width = 0.85;
constexpr double table_height = 0.75;
constexpr double seat_height = 0.46;
constexpr int seats_along_table = 7;
constexpr double seat_spacing = 0.82;
constexpr double seat_x(int i) { return seat_spacing * (i - 0.5 * (seats_along_table - 1)); }

struct Materials {
  int floor = 0;
  int ceiling = 0;
  int wall = 0;
  int accent_wall = 0;
  int table = 0;
  int dark_wood = 0;
  int light_wood = 0;
  int fabric = 0;
  int red_fabric = 0;
  int dark_piping = 0;
  int chrome = 0;
  int aluminium = 0;
  int white_plastic = 0;
  int black_plastic = 0;
  int grey_plastic = 0;
  int porcelain = 0;
  int coffee = 0;
  int glass = 0;
  int paper = 0;
  int page = 0;
  int board = 0;
  int flip_chart = 0;
  int picture = 0;
  int abstract_picture = 0;
  int clock = 0;
  int screen = 0;
  int blind = 0;
  int red = 0;
  int blue = 0;
  int green = 0;
  int lamp = 0;
  int daylight = 0;
  int far_building = 0;
  int near_building = 0;

  PlantMaterials plant;
};
Materials add_materials(Model& model);

void add_shell(Model& model, const Materials& m);
void add_ceiling(Model& model, const Materials& m);
void add_windows(Model& model, const Materials& m);
void add_door(Model& model, const Materials& m);
void add_chairs(Model& model, const Materials& m);
void add_table(Model& model, const Materials& m);
void add_laptops(Model& model, const Materials& m);
void add_tableware(Model& model, const Materials& m);
void add_papers(Model& model, const Materials& m);
void add_conference_phone(Model& model, const Materials& m);
void add_whiteboard(Model& model, const Materials& m);
void add_flip_chart(Model& model, const Materials& m);
void add_wall_things(Model& model, const Materials& m);
void add_cabinet(Model& model, const Materials& m);
void add_plants(Model& model, const Materials& m);
void add_projector(Model& model, const Materials& m);

/// A cup on its saucer with coffee in it, standing on the origin: porcelain and coffee.
struct Cup {
  Shape porcelain;
  Shape coffee;
};
Cup make_cup();

/// A vacuum jug that stands on the origin.
Shape make_jug();

}  // namespace foveola::scenes::meeting
