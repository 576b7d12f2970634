// The car's skin in sheets, cut along the gaps between its panels.
#pragma once

#include "scenes/studio_car/panels.h"

namespace foveola::scenes::car {

/// The sheets of the sides are those at +Z.
struct Body {
  Sheet nose;    ///< around the front: columns towards +Z, rows upwards
  Sheet bonnet;  ///< columns towards +Z, rows backwards
  Sheet cowl;    ///< at the windscreen's foot
  Sheet fender;  ///< columns backwards, rows upwards, as of all sheets of the side
  Sheet door;
  Sheet quarter;
  Sheet sill;
  Sheet cabin_side;  ///< from the belt line to the roof's edge
  Sheet cabin_top;   ///< windscreen, roof, rear window: columns backwards, rows from +Z
  Sheet boot_lid;    ///< columns from +Z, rows backwards
  Sheet tail;        ///< around the rear: columns from +Z, rows upwards
};

Body make_body();

}  // namespace foveola::scenes::car
