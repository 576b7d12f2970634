// Where things are put and how they are turned.
#pragma once

#include "scenes/modelling/shapes.h"

namespace foveola::scenes {

/// Moves what faces +Z, upright, to `position` and turns it towards `direction`.
DMat4 facing(const DVec3& position, const DVec3& direction);

}  // namespace foveola::scenes
