// Procedural textures of the built-in scenes. All but the picture-like ones repeat without a seam.
#pragma once

#include <cstdint>

#include "scenes/modelling/model.h"

namespace foveola::scenes {

/// Square floor tiles, `tiles` by `tiles` in the image, each with its own shade, and grout between
/// them. Tiles alternate between the two linear colours.
Image floor_tiles(int size, int tiles, const Rgb& first, const Rgb& second, const Seed& seed);

/// Courses of cut stones or bricks with mortar joints, every second course shifted by half a stone.
struct Masonry {
  int courses = 8;
  int stones = 4;          ///< in a course
  double joint = 0.04;     ///< width in courses
  double variation = 0.2;  ///< relative variation of the stones' brightness
  Rgb stone{0.5F};         ///< linear
  Rgb mortar{0.4F};        ///< linear
};
Image masonry(int size, const Masonry& masonry, const Seed& seed);

/// Boards along v, `boards` side by side, with grain.
Image wood(int size, int boards, const Rgb& light, const Rgb& dark, const Seed& seed);

/// A nearly plain colour with soft blotches of relative strength `variation`: plaster, marble.
Image plaster(int size, const Rgb& color, double variation, const Seed& seed);

/// Woven cloth: a ground with stripes along v and threads.
Image cloth(int size, int stripes, const Rgb& ground, const Rgb& stripe, const Seed& seed);

/// Ceiling panels: `panels` by `panels` with dark grooves and fine holes.
Image ceiling_panels(int size, int panels, const Seed& seed);

/// One leaf on a transparent ground, its stalk at the bottom (v = 1).
Image leaf(int size, const Rgb& color, const Seed& seed);

/// A whiteboard with lines of writing, a chart and a sketch; twice as wide as high.
Image written_board(int height, const Seed& seed);

/// A framed picture's inside: hills under a sky.
Image landscape(int size, const Seed& seed);

/// A clock's face at ten past ten.
Image clock_face(int size);

}  // namespace foveola::scenes
