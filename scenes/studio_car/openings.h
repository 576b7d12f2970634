// Where the car's sheets are open: for windows, lamps, grille and number plate.
#pragma once

#include "scenes/studio_car/panels.h"

namespace foveola::scenes::car {

Cells is_grille(const Sheet& nose);
Cells is_air_intake(const Sheet& nose);
Cells is_headlight(const Sheet& nose);
Cells is_tail_light(const Sheet& tail);
Cells is_plate_recess(const Sheet& tail);
Cells is_diffuser(const Sheet& tail);
Cells is_door_window(const Sheet& cabin_side);
Cells is_quarter_window(const Sheet& cabin_side);
Cells is_middle_pillar(const Sheet& cabin_side);
Cells is_windscreen(const Sheet& cabin_top);
Cells is_rear_window(const Sheet& cabin_top);

/// The cells that are in none of `openings`.
Cells none_of(std::vector<Cells> openings);

}  // namespace foveola::scenes::car
