// Where the school room's desks stand; what lies on them needs to know.
#pragma once

#include <vector>

#include "scenes/modelling/shapes.h"

namespace foveola::scenes::school {

constexpr double desk_width = 1.3;
constexpr double desk_depth = 0.52;
constexpr int desk_rows = 4;
constexpr int desk_columns = 3;

/// The middles of the desks on the floor, row by row from the board, from the windows to the door.
inline std::vector<DVec3> desk_places() {
  std::vector<DVec3> places;
  for (int row = 0; row < desk_rows; ++row) {
    for (int column = 0; column < desk_columns; ++column) {
      places.emplace_back(1.4 - 1.35 * row, 0.0, 2.15 * (column - 1));
    }
  }
  return places;
}

}  // namespace foveola::scenes::school
