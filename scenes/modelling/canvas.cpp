#include "scenes/modelling/canvas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "renderer/base/random.h"
#include "scenes/modelling/lettering.h"
#include "scenes/modelling/painting.h"

namespace foveola::scenes {
namespace {

/// The share of a pixel that lies inside an edge which is `distance` away, inside counting
/// negative.
double covered(double distance) { return std::clamp(0.5 - distance, 0.0, 1.0); }

}  // namespace

/// Blends the ink by coverage(p) into the pixels whose middles p lie in the box.
template <typename Coverage>
void Canvas::blend_box(const DVec2& lower, const DVec2& upper, const Ink& ink,
                       const Coverage& coverage) {
  const int x0 = std::max(0, static_cast<int>(std::floor(lower.x)));
  const int y0 = std::max(0, static_cast<int>(std::floor(lower.y)));
  const int x1 = std::min(image_.width - 1, static_cast<int>(std::ceil(upper.x)));
  const int y1 = std::min(image_.height - 1, static_cast<int>(std::ceil(upper.y)));
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      const double share = coverage(DVec2(x + 0.5, y + 0.5));
      if (share <= 0.0) {
        continue;
      }
      const int pixel = y * image_.width + x;
      const double grain = ink.grain * unit_float(mix(static_cast<std::uint32_t>(pixel)));
      const double amount = ink.opacity * (1.0 - grain) * share;
      for (int channel = 0; channel < 3; ++channel) {
        std::uint8_t& byte = image_.rgba[static_cast<std::size_t>(pixel) * 4 + channel];
        byte = static_cast<std::uint8_t>(std::lround(std::lerp(byte, ink.color[channel], amount)));
      }
    }
  }
}

void Canvas::draw_segment(const DVec2& a, const DVec2& b, const Pen& pen) {
  const DVec2 reach(0.5 * pen.width + 1.0);
  blend_box(glm::min(a, b) - reach, glm::max(a, b) + reach, pen.ink, [&](const DVec2& p) {
    return covered(paint::distance_to_segment(p, a, b) - 0.5 * pen.width);
  });
}

void Canvas::draw_lines(const std::vector<DVec2>& points, const Pen& pen) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    draw_segment(points[i - 1], points[i], pen);
  }
}

void Canvas::draw_circle(const DVec2& middle, double radius, const Pen& pen) {
  const DVec2 reach(radius + pen.width);
  blend_box(middle - reach, middle + reach, pen.ink, [&](const DVec2& p) {
    return covered(std::abs(glm::distance(p, middle) - radius) - 0.5 * pen.width);
  });
}

void Canvas::fill_circle(const DVec2& middle, double radius, const Ink& ink) {
  const DVec2 reach(radius + 1.0);
  blend_box(middle - reach, middle + reach, ink,
            [&](const DVec2& p) { return covered(glm::distance(p, middle) - radius); });
}

void Canvas::fill_rectangle(const DVec2& upper_left, const DVec2& lower_right, const Ink& ink) {
  const DVec2 middle = 0.5 * (upper_left + lower_right);
  const DVec2 half = 0.5 * (lower_right - upper_left);
  blend_box(upper_left - DVec2(1.0), lower_right + DVec2(1.0), ink, [&](const DVec2& p) {
    const DVec2 outside = glm::abs(p - middle) - half;
    return covered(std::max(outside.x, outside.y));
  });
}

void Canvas::fill_polygon(const std::vector<DVec2>& corners, const Ink& ink) {
  DVec2 lower = corners.front();
  DVec2 upper = corners.front();
  for (const DVec2& corner : corners) {
    lower = glm::min(lower, corner);
    upper = glm::max(upper, corner);
  }
  blend_box(lower, upper, ink, [&](const DVec2& p) { return is_inside(p, corners) ? 1.0 : 0.0; });
}

DVec2 Canvas::write(std::string_view text, const DVec2& from, const TextStyle& style) {
  constexpr double capital_height = 6.0;
  const double scale = style.height / capital_height;
  const DVec2 up(style.along.y, -style.along.x);
  const Lettering letters = lettering(text);
  for (const Stroke& stroke : letters.strokes) {
    std::vector<DVec2> points;
    for (const DVec2& point : stroke) {
      const double x = point.x + style.slant * point.y;
      points.push_back(from + scale * (x * style.along + point.y * up));
    }
    draw_lines(points, style.pen);
  }
  return from + scale * letters.width * style.along;
}

Image blank(int width, int height, const DVec3& color) {
  Image image{width, height, {}};
  image.rgba.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
  const auto byte = [&](int channel) {
    return static_cast<std::uint8_t>(std::lround(color[channel]));
  };
  const std::array<std::uint8_t, 4> texel = {byte(0), byte(1), byte(2), 255};
  for (std::size_t i = 0; i < image.rgba.size(); i += texel.size()) {
    std::copy(texel.begin(), texel.end(), &image.rgba[i]);
  }
  return image;
}

bool is_inside(const DVec2& p, const std::vector<DVec2>& corners) {
  bool inside = false;
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
    const DVec2& a = corners[i];
    const DVec2& b = corners[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < std::lerp(a.x, b.x, (p.y - a.y) / (b.y - a.y))) {
      inside = !inside;
    }
  }
  return inside;
}

}  // namespace foveola::scenes
