// What a cell of the film's pyramid knows of its pixels.
#pragma once

#include "renderer/base/vec.h"

namespace foveola {

/// Of a square of pixels, those without samples counting as black and weightless: the sum of the
/// colours over the number of all pixels, and the fraction that has samples. Their quotient is the
/// mean of what is known, so that an unsampled pixel neither darkens nor brightens its neighbours.
struct Coverage {
  Rgb color{0.0F};
  float weight = 0.0F;

  Coverage& operator+=(const Coverage& other) {
    color += other.color;
    weight += other.weight;
    return *this;
  }
};

inline Coverage operator*(float factor, const Coverage& coverage) {
  return {factor * coverage.color, factor * coverage.weight};
}

/// Of the square that four equal ones make up.
inline Coverage mean_of(const Coverage& a, const Coverage& b, const Coverage& c,
                        const Coverage& d) {
  return {0.25F * ((a.color + b.color) + (c.color + d.color)),
          0.25F * ((a.weight + b.weight) + (c.weight + d.weight))};
}

/// Of the square at (x, y) one level up from width x height cells, which cell(x, y) returns: what
/// reaches beyond them is empty.
template <typename Cell>
Coverage mean_of_square(int x, int y, int width, int height, const Cell& cell) {
  const auto known = [&](int column, int row) -> Coverage {
    return column < width && row < height ? cell(column, row) : Coverage{};
  };
  return mean_of(known(2 * x, 2 * y), known(2 * x + 1, 2 * y), known(2 * x, 2 * y + 1),
                 known(2 * x + 1, 2 * y + 1));
}

}  // namespace foveola
