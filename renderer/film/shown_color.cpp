#include "renderer/film/shown_color.h"

#include <array>
#include <cassert>

namespace foveola {
namespace {

/// PremultipliedTexel of eight squares, one per lane.
struct PremultipliedTexels {
  Vec3s color;
  Floats weight;

  friend PremultipliedTexels operator+(const PremultipliedTexels& a, const PremultipliedTexels& b) {
    return {a.color + b.color, a.weight + b.weight};
  }
  friend PremultipliedTexels operator*(const Floats& factor, const PremultipliedTexels& texels) {
    return {factor * texels.color, factor * texels.weight};
  }
};

/// PremultipliedTexel of one square: red, green, blue, weight.
using Four = float __attribute__((vector_size(sizeof(PremultipliedTexel))));

Four load(const PremultipliedTexel& cell) {
  Four four;
  __builtin_memcpy(&four, &cell, sizeof(four));
  return four;
}

/// Four cells around each of eight points, with their weights.
struct Squares {
  std::array<const PremultipliedTexel*, lane_count> upper;  ///< the left one; the right one follows
  std::array<const PremultipliedTexel*, lane_count> lower;
  FloatLanes upper_left, upper_right, lower_left, lower_right;
};

/// Also prefetches the cells.
void find_squares(const SpherePlanes<PremultipliedTexel>& cells, const Vec2s& image,
                  const Ints& level, Squares& squares) {
  const CellsAround at = cells_around(Vec2(cells.width(0), cells.height(0)), image, level);
  squares.upper_left.store((1.0F - at.right) * (1.0F - at.down));
  squares.upper_right.store(at.right * (1.0F - at.down));
  squares.lower_left.store((1.0F - at.right) * at.down);
  squares.lower_right.store(at.right * at.down);
  for (std::size_t i = 0; i < lane_count; ++i) {
    squares.upper[i] = cells.at(level[i], at.x[i], at.y[i]);
    squares.lower[i] = squares.upper[i] + cells.stride(level[i]);
    __builtin_prefetch(squares.upper[i]);
    __builtin_prefetch(squares.lower[i]);
  }
}

PremultipliedTexels bilinear(const Squares& squares) {
  std::array<Four, lane_count> sums;
  for (std::size_t i = 0; i < lane_count; ++i) {
    const PremultipliedTexel* const upper = squares.upper[i];
    const PremultipliedTexel* const lower = squares.lower[i];
    sums[i] = squares.upper_left[i] * load(upper[0]) + squares.upper_right[i] * load(upper[1]) +
              squares.lower_left[i] * load(lower[0]) + squares.lower_right[i] * load(lower[1]);
  }
  const auto channel = [&](std::size_t c) {
    return Floats{sums[0][c], sums[1][c], sums[2][c], sums[3][c],
                  sums[4][c], sums[5][c], sums[6][c], sums[7][c]};
  };
  return {.color = {channel(0), channel(1), channel(2)}, .weight = channel(3)};
}

/// Mixes two levels; reads one alone if no point lies between two.
struct SquaresOfLevels {
  Squares finer;
  Squares coarser;
  Floats t;  ///< weight of the coarser level
  bool is_between;
};

void find_squares(const SpherePlanes<PremultipliedTexel>& cells, const ViewPoints& points,
                  SquaresOfLevels& squares) {
  const Ints level = truncated(points.level);
  squares.t = points.level - floats_of(level);
  find_squares(cells, points.image, level, squares.finer);
  const LaneMask is_between = squares.t > 0.0F;
  squares.is_between = any_lane(is_between);
  if (squares.is_between) {
    // A mask's "all bits" is -1. Other lanes may have no coarser level.
    find_squares(cells, points.image, level - is_between, squares.coarser);
  }
}

PremultipliedTexels trilinear(const SquaresOfLevels& squares) {
  const PremultipliedTexels finer = bilinear(squares.finer);
  if (!squares.is_between) {
    return finer;
  }
  return (1.0F - squares.t) * finer + squares.t * bilinear(squares.coarser);
}

/// Completes `known` from the levels from `level` on, one after the other. One known pixel
/// represents its whole cell (as in Grossman and Dally 1998, "Point Sample Rendering").
void fill(const SpherePlanes<PremultipliedTexel>& cells, const Vec2s& image, Ints level,
          PremultipliedTexels& known) {
  constexpr float enough = 0.999F;
  for (;;) {
    const LaneMask lacks = (known.weight < enough) & (level < cells.levels());
    if (!any_lane(lacks)) {
      return;
    }
    Squares squares;
    find_squares(cells, image, lacks ? level : Ints{}, squares);
    const PremultipliedTexels coarser = bilinear(squares);
    const Floats pixels_in_cell = power_of_two(2 * level);
    const Floats share = (1.0F - known.weight) * smaller(pixels_in_cell, 1.0F / coarser.weight);
    known = known + chosen(lacks & (coarser.weight > 0.0F), share, Floats{}) * coarser;
    level = level + 1;
  }
}

}  // namespace

void shown_colors(const SpherePlanes<PremultipliedTexel>& cells, std::span<const ViewPoints> points,
                  UnsampledPixels unsampled, std::span<Vec3s> colors) {
  assert(points.size() <= max_view_points && colors.size() == points.size());
  std::array<SquaresOfLevels, max_view_points> squares;
  for (std::size_t i = 0; i < points.size(); ++i) {
    find_squares(cells, points[i], squares[i]);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    PremultipliedTexels known = trilinear(squares[i]);
    if (unsampled == UnsampledPixels::filled) {
      fill(cells, points[i].image, truncated(points[i].level) + 1, known);
    }
    colors[i] = chosen(known.weight > 0.0F, 1.0F / known.weight, Floats{}) * known.color;
  }
}

}  // namespace foveola
