// How a screen's questions look.
#pragma once

#include "renderer/window/screens/screen_column.h"

namespace foveola {

/// The question, what it is answered with, and what is wrong with that. A scale's points stand in a
/// row if their words have room there, else one below the other.
void add_field(ScreenColumn& column, const ScreenField& field);

}  // namespace foveola
