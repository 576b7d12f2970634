// A stone column with a carved capital.
#pragma once

#include "scenes/modelling/shapes.h"

namespace foveola::scenes {

/// A column with moulded base and a capital of two rows of acanthus leaves under four scrolls,
/// standing on the origin.
struct CarvedColumn {
  double radius = 0.2;
  double height = 2.9;
  double slab = 0.62;  ///< side of the top slab
  int segments = 20;
  int leaf_rows = 6;
};
Shape carved_column(const CarvedColumn& size);

}  // namespace foveola::scenes
