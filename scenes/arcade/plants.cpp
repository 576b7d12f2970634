// Plants in pots around the court.
#include <fmt/format.h>

#include "scenes/arcade/parts.h"
#include "scenes/modelling/palm.h"

namespace foveola::scenes::arcade {

void add_plants(Model& model, const Materials& m) {
  const PlantSize large{.pot_radius = 0.36,
                        .pot_height = 0.55,
                        .stem_height = 0.8,
                        .leaf_length = 0.36,
                        .stems = 14,
                        .leaves_per_stem = 8};
  add_object(model, "Large plant",
             moved(potted_plant(large, m.plant, model.stream(100)), {1.2, court_floor, 3.4}));
  const PlantSize broad{.pot_radius = 0.26, .pot_height = 0.38, .leaf_length = 0.28, .stems = 10};
  const TreeSize tree{};
  const PalmSize palm{};
  enum class Kind { fruit_tree, feathered, broad_leaved };
  struct Place {
    Kind kind;
    double x;
    double z;
  };
  std::uint32_t number = 1;
  for (const Place& place :
       {Place{Kind::fruit_tree, -7.8, 3.3}, Place{Kind::fruit_tree, -7.8, -3.3},
        Place{Kind::fruit_tree, 7.8, 3.3}, Place{Kind::fruit_tree, 7.8, -3.3},
        Place{Kind::feathered, -3.0, 3.55}, Place{Kind::feathered, 4.4, 3.55},
        Place{Kind::broad_leaved, -4.0, -3.55}, Place{Kind::feathered, 3.0, -3.6}}) {
    const Seed seed = model.stream(100 + number);
    const std::vector<Part> plant =
        place.kind == Kind::fruit_tree  ? potted_tree(tree, m.plant, m.orange, seed)
        : place.kind == Kind::feathered ? potted_palm(palm, m.plant, seed)
                                        : potted_plant(broad, m.plant, seed);
    add_object(model, fmt::format("Plant {}", number),
               moved(plant, {place.x, court_floor, place.z}));
    ++number;
  }
}

}  // namespace foveola::scenes::arcade
