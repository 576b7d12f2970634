// The car of the studio: a coupe with its wheels, lamps and cabin.
#pragma once

#include "scenes/modelling/model.h"

namespace foveola::scenes {

struct CarMaterials {
  int paint = 0;
  int glass = 0;
  int lamp_glass = 0;
  int red_glass = 0;
  int rubber = 0;
  int alloy = 0;
  int chrome = 0;
  int mirror = 0;
  int iron = 0;
  int black_plastic = 0;
  int gloss_black = 0;
  int lamp = 0;      ///< shines white
  int red_lamp = 0;  ///< shines red
  int screen = 0;    ///< the dashboard's screen
  int leather = 0;
  int stitched_leather = 0;
  int lining = 0;
  int carpet = 0;
  int caliper = 0;
  int number_plate = 0;
};

CarMaterials add_car_materials(Model& model);

/// Adds a car of 4.4 m that stands on y = `ground` over the origin and faces +X, as objects "Car
/// body", "Car windows", "Front wheel" (the one at +Z) and so on.
void add_car(Model& model, const CarMaterials& materials, double ground);

/// A tyre lying on the origin.
Shape tyre();

}  // namespace foveola::scenes
