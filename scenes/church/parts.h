// The parts that the built-in church is put together from, and the measures they share. The nave
// runs along X with the apse at +X; the floor is y = 0.
#pragma once

#include "scenes/modelling/model.h"

namespace foveola::scenes::church {

constexpr double bay = 4.0;
constexpr int bays = 6;
constexpr double half_length = 0.5 * bays * bay;  ///< half length of nave and aisles, inside
constexpr double arcade_z = 3.5;                  ///< the columns' middles
constexpr double aisle_z = 7.0;                   ///< the outer walls' inner faces
constexpr double wall = 0.7;                      ///< thickness
constexpr double column_height = 4.5;
constexpr double arcade_opening = 3.1;
constexpr double gallery = 7.2;  ///< the ledge under the upper windows
constexpr double nave_springing = 7.0;
constexpr double nave_rise = 4.2;
constexpr double nave_top = 11.5;
constexpr double choir_floor = 0.48;
constexpr double apse_x = 14.4;      ///< where the choir's straight walls end
constexpr double apse_radius = 3.1;  ///< to the corners of the half decagon
constexpr double choir_springing = 5.0;
constexpr double choir_rise = 3.4;
constexpr double rose_radius = 1.55;
constexpr double rose_height = 8.5;  ///< height of the rose window's middle
constexpr double loft_floor = 4.0;   ///< height of the organ loft at the west end
constexpr double loft_edge_x = -9.6;

struct Materials {
  int masonry = 0;
  int limestone = 0;
  int vault = 0;
  int sky_vault = 0;
  int slabs = 0;
  int rosette = 0;
  int band = 0;
  int white_marble = 0;
  int red_marble = 0;
  int dark_stone = 0;
  int oak = 0;
  int dark_oak = 0;
  int gold = 0;
  int brass = 0;
  int iron = 0;
  int tin = 0;
  int wax = 0;
  int linen = 0;
  int frontal = 0;
  int book = 0;
  int blue_saint = 0;
  int red_saint = 0;
  int water = 0;
  int flame = 0;
  int lamp = 0;
  int northern_sky = 0;
  int southern_sky = 0;
  int shaded_sky = 0;
  int grisaille = 0;
  int blue_glass = 0;
  int green_glass = 0;
  int white_glass = 0;
  int rose_glass = 0;
};
Materials add_materials(Model& model);

void add_floor(Model& model, const Materials& m);
void add_walls(Model& model, const Materials& m);
void add_apse_walls(Model& model, const Materials& m);
void add_columns(Model& model, const Materials& m);
void add_vaults(Model& model, const Materials& m);
void add_windows(Model& model, const Materials& m);

void add_altar(Model& model, const Materials& m);
void add_pulpit(Model& model, const Materials& m);
void add_font(Model& model, const Materials& m);
void add_pews(Model& model, const Materials& m);
void add_statues(Model& model, const Materials& m);
void add_aisle_furniture(Model& model, const Materials& m);
void add_organ(Model& model, const Materials& m);
void add_west_door(Model& model, const Materials& m);
void add_chandeliers(Model& model, const Materials& m);
void add_candles(Model& model, const Materials& m);

/// A wall with a round-headed window, whose jambs start at the origin; the room is at +Z.
struct WindowPlace {
  DVec3 sill{0.0};        ///< in the middle of the wall's thickness
  double turn_deg = 0.0;  ///< +Z towards +X
  double width = 1.2;     ///< width of the opening
  double jamb = 2.0;      ///< height at which the arch begins
  double wall_width = bay;
  double wall_height = 4.0;  ///< above the sill
};
std::vector<WindowPlace> aisle_windows();
std::vector<WindowPlace> clerestory_windows();
std::vector<WindowPlace> apse_windows();

/// The corner between two sides of the apse on its inner face, at the floor; 0 to 5 from -Z to +Z.
DVec3 apse_corner(int number);

}  // namespace foveola::scenes::church
