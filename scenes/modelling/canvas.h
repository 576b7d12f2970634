// Drawing with lines and letters on an image.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "scenes/modelling/model.h"

namespace foveola::scenes {

/// Colours are sRGB-encoded bytes, as what is drawn on holds them.
struct Ink {
  DVec3 color{0.0};
  double opacity = 1.0;
  double grain = 0.0;  ///< how unevenly it covers, in [0, 1]: chalk's is high
};

struct Pen {
  Ink ink;
  double width = 2.0;  ///< in pixels
};

struct TextStyle {
  Pen pen;
  double height = 24.0;   ///< height of capital letters in pixels
  double slant = 0.0;     ///< sideways lean of upright strokes, relative to their height
  DVec2 along{1.0, 0.0};  ///< unit vector in which the line runs; y points down
};

/// Positions are in pixels from the top left, y down.
class Canvas {
 public:
  explicit Canvas(Image ground) : image_(std::move(ground)) {}

  int width() const { return image_.width; }
  int height() const { return image_.height; }
  Image finished() && { return std::move(image_); }

  void draw_lines(const std::vector<DVec2>& points, const Pen& pen);
  void draw_circle(const DVec2& middle, double radius, const Pen& pen);
  void fill_circle(const DVec2& middle, double radius, const Ink& ink);
  void fill_rectangle(const DVec2& upper_left, const DVec2& lower_right, const Ink& ink);
  void fill_polygon(const std::vector<DVec2>& corners, const Ink& ink);
  /// Returns where the line ends.
  DVec2 write(std::string_view text, const DVec2& from, const TextStyle& style);

 private:
  void draw_segment(const DVec2& a, const DVec2& b, const Pen& pen);
  template <typename Coverage>
  void blend_box(const DVec2& lower, const DVec2& upper, const Ink& ink, const Coverage& coverage);

  Image image_;
};

/// An image of one colour, in sRGB-encoded bytes.
Image blank(int width, int height, const DVec3& color);

/// Whether the corners' outline goes around `p`.
bool is_inside(const DVec2& p, const std::vector<DVec2>& corners);

}  // namespace foveola::scenes
