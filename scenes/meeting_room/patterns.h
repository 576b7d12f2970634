// Textures of the meeting room: what is written, printed and shown there.
#pragma once

#include <cstdint>

#include "scenes/modelling/model.h"

namespace foveola::scenes::meeting {

/// A whiteboard after a discussion: headings, lists, a chart, a sketch of boxes. Twice as wide as
/// high.
Image discussed_board(int height);
/// A flip chart's sheet, three by four.
Image flip_chart_sheet(int height);
/// A printed agenda, three by four.
Image printed_page(int height);
/// What a laptop shows: a window with text and a chart; eight by five.
Image laptop_desktop(int height);
/// An abstract painting: overlapping fields of colour, four by three.
Image abstract_painting(int height, const Seed& seed);

}  // namespace foveola::scenes::meeting
