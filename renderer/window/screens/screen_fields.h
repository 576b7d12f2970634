// Lays out a screen's questions.
#pragma once

#include "renderer/window/screens/screen_column.h"

namespace foveola {

/// Adds the question, its answers and its fault. A scale's points are in a row if their words fit,
/// otherwise one below the other.
void add_field(ScreenColumn& column, const ScreenField& field);

}  // namespace foveola
