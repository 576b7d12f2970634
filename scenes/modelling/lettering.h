// Handwriting in single strokes, for the school room's blackboard, pages and books.
#pragma once

#include <string_view>
#include <vector>

#include "scenes/modelling/shapes.h"

namespace foveola::scenes {

/// Points that a pen connects. Lengths in units of which a capital letter is 6 high; the baseline
/// is y = 0 and y points up.
using Stroke = std::vector<DVec2>;

struct Lettering {
  std::vector<Stroke> strokes;
  double width = 0.0;  ///< where the next letter would begin
};

/// `text` on one line from x = 0. Letters, digits and common signs; others leave a space.
Lettering lettering(std::string_view text);

}  // namespace foveola::scenes
