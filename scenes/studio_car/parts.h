// The groups of parts that the car is put together from.
#pragma once

#include <vector>

#include "scenes/studio_car/body.h"
#include "scenes/studio_car/car.h"

namespace foveola::scenes::car {

std::vector<Part> bodywork(const Body& body, const CarMaterials& m);
std::vector<Part> window_panes(const Body& body, const CarMaterials& m);
std::vector<Part> underbody_and_grille(const Body& body, const CarMaterials& m);
std::vector<Part> headlights(const Body& body, const CarMaterials& m);
std::vector<Part> tail_lights(const Body& body, const CarMaterials& m);

/// Handles, wipers, seals, badges, exhausts.
std::vector<Part> trim(const Body& body, const CarMaterials& m);
std::vector<Part> mirrors(const CarMaterials& m);
std::vector<Part> front_number_plate(const CarMaterials& m);
std::vector<Part> rear_number_plate(const CarMaterials& m);

std::vector<Part> seats(const CarMaterials& m);
std::vector<Part> steering_wheel(const CarMaterials& m);
std::vector<Part> dashboard(const CarMaterials& m);
/// Floor, door trims, roof lining.
std::vector<Part> cabin_lining(const Body& body, const CarMaterials& m);

/// A wheel lying on the origin with its outer side up, middle at y = 0.
std::vector<Part> wheel(const CarMaterials& m);

}  // namespace foveola::scenes::car
