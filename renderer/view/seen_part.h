// The part of a view that a display ever shows: a headset's lenses show no corners.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "renderer/base/piecewise_constant.h"
#include "renderer/base/vec.h"

namespace foveola {

/// In cells of equal size over the display's plane, as a Viewport has it, each of which is seen or
/// not.
class SeenPart {
 public:
  /// A row of cells for each text, from the top, four cells in each hexadecimal digit, the leftmost
  /// one in its highest bit. Throws Error if that is no such grid, or nothing of it is seen.
  explicit SeenPart(std::vector<std::string> rows);

  /// What it was made of.
  const std::vector<std::string>& rows() const { return rows_; }
  /// How much of the plane is seen, in (0, 1].
  double share() const { return share_; }
  /// plane: (0, 0) is the display's top left corner, (1, 1) the bottom right one.
  bool contains(const Vec2& plane) const;
  /// Maps points of the unit square to places on the plane, uniform over what is seen, one to one.
  Vec2 place(const Vec2& point) const;

 private:
  std::vector<std::string> rows_;
  Vec2 cells_;  ///< how many beside each other, and one below the other
  PiecewiseConstant2D seen_;
  double share_;
};

}  // namespace foveola
