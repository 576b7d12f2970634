// What a cell of the film's pyramid knows of its pixels.
#pragma once

#include "renderer/base/vec.h"

namespace foveola {

/// A square of pixels, those without samples counting as black and weightless: the sum of the
/// colours over the number of all pixels, and the fraction that has samples. Their quotient is the
/// mean of what is known, so that an unsampled pixel neither darkens nor brightens its neighbours.
struct PremultipliedTexel {
  Rgb color{0.0F};
  float weight = 0.0F;

  PremultipliedTexel& operator+=(const PremultipliedTexel& other) {
    color += other.color;
    weight += other.weight;
    return *this;
  }
};

inline PremultipliedTexel operator*(float factor, const PremultipliedTexel& texel) {
  return {factor * texel.color, factor * texel.weight};
}

/// The texel of the square that four equal ones make up.
inline PremultipliedTexel mean_of(const PremultipliedTexel& a, const PremultipliedTexel& b,
                                  const PremultipliedTexel& c, const PremultipliedTexel& d) {
  return {0.25F * ((a.color + b.color) + (c.color + d.color)),
          0.25F * ((a.weight + b.weight) + (c.weight + d.weight))};
}

/// The texel of the square at (x, y) one level up from width x height cells, which cell(x, y)
/// returns: what reaches beyond them is empty.
template <typename Cell>
PremultipliedTexel mean_of_square(int x, int y, int width, int height, const Cell& cell) {
  const auto known = [&](int column, int row) -> PremultipliedTexel {
    return column < width && row < height ? cell(column, row) : PremultipliedTexel{};
  };
  return mean_of(known(2 * x, 2 * y), known(2 * x + 1, 2 * y), known(2 * x, 2 * y + 1),
                 known(2 * x + 1, 2 * y + 1));
}

}  // namespace foveola
