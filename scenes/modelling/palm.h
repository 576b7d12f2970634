// Plants that are more than a pot of broad leaves: palms and small trees.
#pragma once

#include <cstdint>
#include <vector>

#include "scenes/modelling/props.h"

namespace foveola::scenes {

/// A palm in a pot that stands on the origin: feathered leaves that arch outwards.
struct PalmSize {
  double pot_radius = 0.25;
  double pot_height = 0.4;
  double frond_length = 1.1;
  int fronds = 13;
  int leaflets = 18;  ///< on each side of a frond
};
std::vector<Part> potted_palm(const PalmSize& size, const PlantMaterials& materials,
                              const Seed& seed);

/// A clipped tree in a pot that stands on the origin: a stem under a ball of leaves with fruit.
struct TreeSize {
  double pot_radius = 0.3;
  double pot_height = 0.5;
  double stem_height = 0.9;  ///< height of the crown's middle above the pot
  double crown_radius = 0.5;
  int leaves = 460;
  int fruits = 14;
};
std::vector<Part> potted_tree(const TreeSize& size, const PlantMaterials& materials, int fruit,
                              const Seed& seed);

}  // namespace foveola::scenes
