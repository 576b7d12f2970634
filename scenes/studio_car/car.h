// The car of the studio: a smooth body that reflections run over, with its wheels.
#pragma once

#include <vector>

#include "scenes/modelling/model.h"

namespace foveola::scenes {

struct CarMaterials {
  int paint = 0;  ///< double-sided: the body is a shell
  int glass = 0;
  int rubber = 0;
  int alloy = 0;
  int chrome = 0;
  int black_plastic = 0;
  int headlight = 0;
  int tail_light = 0;
};

/// Adds a car of 4.4 m that stands on y = `ground` over the origin and faces +X, as objects "Car
/// body", "Car windows", "Front wheel" (the one at +Z) and so on.
void add_car(Model& model, const CarMaterials& materials, double ground);

/// A tyre lying on the origin.
Shape tyre();

}  // namespace foveola::scenes
