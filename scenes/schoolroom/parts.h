// What the parts of the school room share: its size, its materials, and the functions that make
// them.
//
// The board hangs on the wall at +X, the windows look towards -Z, the door is at +Z.
#pragma once

#include <vector>

#include "scenes/modelling/model.h"
#include "scenes/modelling/props.h"

namespace foveola::scenes::school {

constexpr double half_x = 4.6;
constexpr double half_z = 3.5;
constexpr double ceiling = 3.3;
constexpr double wall_thickness = 0.35;

constexpr int windows = 4;
constexpr double window_spacing = 2.15;
constexpr double window_width = 1.7;
constexpr double window_sill = 0.95;
constexpr double window_top = 2.9;
constexpr double window_x(int i) { return window_spacing * (i - 0.5 * (windows - 1)); }

constexpr double desk_height = 0.72;
constexpr double dado_height = 1.25;
constexpr double teacher_desk_height = 0.76;
constexpr DVec3 teacher_desk_place{3.1, 0.0, 1.75};
constexpr double platform_height = 0.16;
constexpr DVec3 teacher_desk_top{3.1, platform_height + teacher_desk_height, 1.75};

struct Materials {
  // The room
  int parquet = 0;
  int ceiling = 0;
  int wall = 0;
  int dado = 0;
  int white_paint = 0;
  int stone = 0;
  int radiator = 0;
  int curtain = 0;
  int lamp = 0;
  // Furniture
  int desk_top = 0;
  int plywood = 0;
  int dark_wood = 0;
  int steel = 0;
  int green_steel = 0;
  int black_plastic = 0;
  int brass = 0;
  // Written and printed things
  int board_middle = 0;
  int board_left = 0;
  int board_right = 0;
  int chalk = 0;
  int wall_map = 0;
  int globe = 0;
  int spines = 0;
  int paper = 0;
  int page = 0;
  int other_page = 0;
  int notices = 0;
  int drawings = 0;
  int alphabet = 0;
  int clock = 0;
  int cork = 0;
  // Colours
  int red = 0;
  int blue = 0;
  int yellow = 0;
  int green = 0;
  int bone = 0;
  int red_cloth = 0;
  int blue_cloth = 0;
  int grey_cloth = 0;
  PlantMaterials plant;
  // Outside
  int grass = 0;
  int paving = 0;
  int facade = 0;
  int roof = 0;
  int bark = 0;
  int foliage = 0;
};

Materials add_materials(Model& model);

void add_shell(Model& model, const Materials& m);
void add_windows(Model& model, const Materials& m);
void add_curtains(Model& model, const Materials& m);
void add_radiators(Model& model, const Materials& m);
void add_lamps(Model& model, const Materials& m);
void add_door(Model& model, const Materials& m);

void add_desks_and_chairs(Model& model, const Materials& m);
void add_teachers_place(Model& model, const Materials& m);
void add_teachers_things(Model& model, const Materials& m);
void add_shelves(Model& model, const Materials& m);

void add_desk_things(Model& model, const Materials& m);
void add_bags(Model& model, const Materials& m);
void add_coats(Model& model, const Materials& m);

void add_board(Model& model, const Materials& m);
void add_wall_things(Model& model, const Materials& m);
void add_globe(Model& model, const Materials& m);
void add_planets(Model& model, const Materials& m);
void add_microscope(Model& model, const Materials& m);
void add_molecule(Model& model, const Materials& m);
void add_waste_basket(Model& model, const Materials& m);
void add_plants(Model& model, const Materials& m);
void add_skeleton(Model& model, const Materials& m);

void add_outside(Model& model, const Materials& m);

/// A book that stands on the origin with its spine towards +Z.
struct BookSize {
  double thickness = 0.03;  ///< along X
  double height = 0.22;
  double depth = 0.16;
};
std::vector<Part> book(const BookSize& size, const Materials& m, int spine);
/// The same on its side, around the origin.
std::vector<Part> lying_book(const BookSize& size, const Materials& m, int spine);
/// An open exercise book whose pages bulge away from the fold, on the origin.
std::vector<Part> open_book(const Materials& m, int page);
/// Lies along X with its point towards +X.
std::vector<Part> pencil(const Materials& m, int paint);

/// `parts` turned about the Y axis and then moved.
std::vector<Part> placed(std::vector<Part> parts, const DVec3& offset, double turn_deg);
/// Adds the shapes of `from` to those of the same materials in `to`.
void append(std::vector<Part>& to, const std::vector<Part>& from);

}  // namespace foveola::scenes::school
