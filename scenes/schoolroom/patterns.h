// Textures of the school room: what is written, printed and laid there.
#pragma once

#include <cstdint>

#include "scenes/modelling/model.h"

namespace foveola::scenes::school {

/// A blackboard's three leaves with chalk on them. The middle one is twice as wide as high, the
/// others are square.
Image board_middle(int height, const Seed& seed);
Image board_left(int height, const Seed& seed);
Image board_right(int height, const Seed& seed);

/// Wooden blocks in herringbone; `blocks` block widths along each side. Repeats if `blocks` is a
/// multiple of 8.
Image parquet(int size, int blocks, const Seed& seed);

/// The earth's land and sea, twice as wide as high: longitude to the right, latitude upwards.
Image world(int height);
/// The same as a printed sheet with a title and a border.
Image wall_map(int height);

/// Books' spines side by side, titles running down them. The lowest eighth is plain cover.
constexpr int spines_in_image = 32;
constexpr double plain_cover_from_v = 0.875;
Image book_spines(int height, const Seed& seed);

/// A page of an exercise book, three by four, ruled and written on.
Image written_page(int height, const Seed& seed);

/// Eight sheets, four by two: timetables, lists, pictures.
constexpr int sheets_across = 4;
constexpr int sheets_down = 2;
Image notices(int height, const Seed& seed);
/// Eight children's drawings in the same order.
Image drawings(int height, const Seed& seed);

/// The alphabet on a strip sixteen times as wide as high.
Image alphabet_strip(int height);

/// A house's outside with windows; repeats.
Image facade(int size, const Seed& seed);

}  // namespace foveola::scenes::school
