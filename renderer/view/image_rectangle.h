// Rectangles of the equirect image, which may lie across its seam.
#pragma once

#include "renderer/view/viewport.h"

namespace foveola {

struct ImageRectangle {
  double u_begin = 0.0;  ///< in [0, 1)
  double width = 1.0;    ///< in (0, 1]; u_begin + width > 1 goes on at u = 0
  double v_begin = 0.0;  ///< 0 <= v_begin < v_end <= 1
  double v_end = 1.0;

  double area() const { return width * (v_end - v_begin); }
  /// A point of the unit square, stretched over the rectangle; u in [0, 1).
  Vec2 place(const Vec2& point) const;
  bool contains(const Vec2& image) const;
  bool operator==(const ImageRectangle&) const = default;
};

/// The smallest that holds all of the viewport: all around where the viewport holds a pole. Under a
/// lens, whose bowed edges count as 1024 straight ones, it may miss a sliver of less than 1e-6.
ImageRectangle bounding_rectangle(const Viewport& viewport);

}  // namespace foveola
