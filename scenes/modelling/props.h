// Things that more than one built-in scene has: columns, plants, cloth.
#pragma once

#include <cstdint>
#include <vector>

#include "scenes/modelling/model.h"

namespace foveola::scenes {

/// A round column with a square base and top slab, standing on the origin.
struct ColumnSize {
  double radius = 0.2;  ///< radius of the shaft at its foot
  double height = 3.0;
  double slab = 0.6;  ///< side of the top slab
};
Shape column(const ColumnSize& size, int segments);

/// A turned balustrade post standing on the origin.
Shape baluster(double height, int segments);

/// Cloth that hangs from its top edge at y = 0, middle x = 0, facing +Z; uvs over [0, 1]. Folds
/// grow towards the free lower edge.
struct ClothSize {
  double width = 1.5;
  double drop = 2.5;
  int folds = 4;
  double fold_depth = 0.08;
};
Shape hanging_cloth(const ClothSize& size, const Seed& seed);

/// A plant with broad leaves in a pot that stands on the origin.
struct PlantSize {
  double pot_radius = 0.25;
  double pot_height = 0.4;
  double stem_height = 0.5;  ///< height of the tallest stems above the pot
  double leaf_length = 0.35;
  int stems = 9;
  int leaves_per_stem = 5;
};
struct PlantMaterials {
  int pot = 0;
  int soil = 0;
  int stem = 0;
  int leaf = 0;     ///< cut out and double-sided
  int leaflet = 0;  ///< plain and double-sided, for narrow leaves
};
PlantMaterials add_plant_materials(Model& model);
/// The pot on the origin with its soil, for a plant of any kind.
std::vector<Part> pot_with_soil(double radius, double height, const PlantMaterials& materials);
/// A leaf that rises from the origin towards +Z and bends down, folded along its midrib; uvs over
/// [0, 1], stalk at v = 1.
Shape leaf_blade(double length, double width, double droop, int rows);
std::vector<Part> potted_plant(const PlantSize& size, const PlantMaterials& materials,
                               const Seed& seed);

/// `parts` moved by `offset`.
std::vector<Part> moved(std::vector<Part> parts, const DVec3& offset);

}  // namespace foveola::scenes
