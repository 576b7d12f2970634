// Lights of the built-in church: candles on whatever holds them, and hanging lamps.
#pragma once

#include <vector>

#include "scenes/church/parts.h"

namespace foveola::scenes::church {

/// Things with candles, collected by material while they are put in their places.
struct Candles {
  Shape brass;
  Shape wax;
  Shape flames;

  /// A burning candle that stands on `foot`.
  void add_candle(const DVec3& foot, double radius, double height);
  /// A turned candlestick of `height` with its candle.
  void add_candlestick(const DVec3& foot, double height, double candle_height);
  void append_to(std::vector<Part>& parts, const Materials& m) const;
};

}  // namespace foveola::scenes::church
