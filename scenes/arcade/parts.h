// What the parts of the arcade share: its measures, its materials, and the functions that make
// them.
//
// The court lies about the origin. Every bay and column is made facing +Z, from the walk into the
// court, and then turned to its place.
#pragma once

#include "scenes/modelling/model.h"
#include "scenes/modelling/props.h"

namespace foveola::scenes::arcade {

constexpr double bay = 3.0;
constexpr int bays_x = 6;
constexpr int bays_z = 3;
constexpr double half_x = 0.5 * bays_x * bay;  ///< the court's edge, in the columns' middle
constexpr double half_z = 0.5 * bays_z * bay;
constexpr double walk_depth = 3.2;
constexpr double wall_thickness = 0.4;
constexpr double court_floor = -0.15;
constexpr double arch_thickness = 0.5;
constexpr double arch_opening = 2.4;
constexpr double lower_springing = 2.9;
constexpr double lower_ceiling = 4.6;
constexpr double upper_floor = 4.9;
constexpr double upper_walk = upper_floor + 0.02;
constexpr double upper_springing = 7.2;
constexpr double upper_ceiling = 8.8;
constexpr double roof_top = 9.2;
constexpr double pier_half = 0.31;  ///< half width of the piers in the court's corners

struct Materials {
  int limestone = 0;

  int ashlar = 0;
  int paving = 0;
  int rosette = 0;
  int walk_tiles = 0;
  int brick = 0;
  int plaster = 0;
  int wood = 0;
  int old_wood = 0;
  int roof_tile = 0;
  int bronze = 0;
  int iron = 0;
  int basin_tiles = 0;
  int water = 0;
  int falling_water = 0;
  int lantern_glass = 0;
  int candle = 0;
  int rope = 0;
  int red_banner = 0;
  int blue_banner = 0;
  int red_cloth = 0;
  int blue_cloth = 0;
  int orange = 0;

  PlantMaterials plant;
};
Materials add_materials(Model& model);

void add_floors(Model& model, const Materials& m);
void add_walls(Model& model, const Materials& m);
void add_arches(Model& model, const Materials& m);
void add_vaults(Model& model, const Materials& m);
void add_upper_ceiling(Model& model, const Materials& m);
void add_roof_edge(Model& model, const Materials& m);
void add_columns(Model& model, const Materials& m);
void add_balustrade(Model& model, const Materials& m);
void add_doors(Model& model, const Materials& m);
void add_lanterns(Model& model, const Materials& m);
void add_fountain(Model& model, const Materials& m);
void add_urn(Model& model, const Materials& m);
void add_sundial(Model& model, const Materials& m);
void add_benches(Model& model, const Materials& m);
void add_plants(Model& model, const Materials& m);
void add_cloths(Model& model, const Materials& m);

/// Four boxes around the court, from `inner` metres outside the columns' middle to `outer`.
Shape ring_around_court(double inner, double outer, double bottom, double top);

/// Calls visit(x, z, turn_deg) for the middle of each bay around the court; turned by turn_deg, +Z
/// points from the walk into the court.
template <typename Visit>
void for_each_bay(const Visit& visit) {
  for (int i = 0; i < bays_x; ++i) {
    const double x = -half_x + (i + 0.5) * bay;
    visit(x, -half_z, 0.0);
    visit(x, half_z, 180.0);
  }
  for (int i = 0; i < bays_z; ++i) {
    const double z = -half_z + (i + 0.5) * bay;
    visit(-half_x, z, 90.0);
    visit(half_x, z, -90.0);
  }
}

/// Calls visit(x, z, turn_deg) for each column that is not in a corner, as for_each_bay.
template <typename Visit>
void for_each_column(const Visit& visit) {
  for (int i = 1; i < bays_x; ++i) {
    visit(-half_x + i * bay, -half_z, 0.0);
    visit(-half_x + i * bay, half_z, 180.0);
  }
  for (int i = 1; i < bays_z; ++i) {
    visit(-half_x, -half_z + i * bay, 90.0);
    visit(half_x, -half_z + i * bay, -90.0);
  }
}

/// Calls visit(x, z) for the middle of each corner's pier.
template <typename Visit>
void for_each_corner(const Visit& visit) {
  for (const double x : {-half_x, half_x}) {
    for (const double z : {-half_z, half_z}) {
      visit(x, z);
    }
  }
}

/// The shape in each bay, as for_each_bay.
Shape in_each_bay(const Shape& shape);

}  // namespace foveola::scenes::arcade
