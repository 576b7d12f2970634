// Procedural textures of the built-in church: marble, glass and painted panels.
#pragma once

#include <cstdint>

#include "scenes/modelling/model.h"

namespace foveola::scenes {

/// Polished stone with veins; repeats without a seam.
Image veined_marble(int size, const Rgb& ground, const Rgb& vein, const Seed& seed);

/// Gold stars on blue; repeats without a seam.
Image starry_sky(int size, const Seed& seed);

/// A saint under a canopy, four times as high as wide: leaded panes of deep colours.
Image figure_window(int width, const Rgb& robe, const Seed& seed);

/// Pale lozenges with coloured medallions and borders, three times as high as wide.
Image grisaille_window(int width, const Seed& seed);

/// A round window of twelve petals in a square.
Image rose_window(int size, const Seed& seed);

/// A standing saint on a gold ground, twice as high as wide.
Image painted_saint(int width, const Rgb& robe, const Seed& seed);

/// The hanging in front of an altar: gold crosses and a fringe on red, twice as wide as high.
Image altar_frontal(int height, const Seed& seed);

/// An open book's two pages of writing with red initials.
Image open_book(int size, const Seed& seed);

}  // namespace foveola::scenes
