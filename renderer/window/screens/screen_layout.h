// Lays out a screen: lines of text and plain shapes, in pixels of the window.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/base/vec.h"
#include "renderer/window/drawing/view_renderer.h"
#include "renderer/window/screens/screen.h"

namespace foveola {

/// A rectangle in pixels from the window's top left corner.
struct ScreenRect {
  Vec2 low{0.0F};   ///< its top left corner
  Vec2 high{0.0F};  ///< its bottom right corner

  Vec2 size() const { return high - low; }
};

enum class TextFace { body, title };

/// Ratio of a title's height to other text's.
inline constexpr float title_scale = 1.35F;

/// Width of a line of text in pixels.
using TextWidth = std::function<float(TextFace face, std::string_view line)>;

enum class Ink {
  ground,  ///< the screen's background
  text,
  quiet,    ///< constant text
  focus,    ///< the focus of keys
  fault,    ///< a fault
  chosen,   ///< behind ground-coloured text
  outline,  ///< outline of choices and fields
};

/// sRGB in [0, 1]. Text has at least 7 times the contrast of its background, outlines 3 times (WCAG
/// 2.1, 1.4.6 and 1.4.11).
Vec3 color_of(Ink ink);

struct PlacedText {
  TextFace face = TextFace::body;
  Ink ink = Ink::text;
  ScreenRect rect;  ///< from the line's ascent to its descent
  std::string line;
};

struct PlacedShape {
  enum class Kind { box, disc, triangle_up, triangle_down, triangle_right };
  Kind kind = Kind::box;
  Ink ink = Ink::outline;
  ScreenRect rect;
  float outline_px = 0.0F;  ///< width of the outline; filled if 0
  bool is_frame = false;    ///< surrounds others, and may do so partly
};

struct ScreenLayout {
  std::vector<PlacedShape> shapes;  ///< in drawing order, before all texts
  std::vector<PlacedText> texts;
};

/// The areas of a screen in a view.
struct ScreenPlace {
  ScreenRect view;  ///< filled by a screen that covers the picture
  ScreenRect page;  ///< contains everything to be read
};

/// A monitor's page is the whole view. In a headset it is the middle half of the view, around
/// `straight_ahead` (in units of the view, (0, 0) its top left): with a field of view of 100
/// degrees, 31 to each side, since lenses are sharp only in the centre and eyes turn no further
/// without the head.
ScreenPlace screen_place(const WindowPart& part, int framebuffer_height,
                         const std::optional<Vec2>& straight_ahead);

/// The height of a line of text, in whole pixels: a 28th of the page's height, or a 27th of its
/// width. DejaVu's x is then 0.48 degrees high on a monitor of 24 inches (16:9) in full screen, 60
/// cm away, and 1.2 in a headset's views of 1280x1440 pixels and 100 degrees. Reading is fluent
/// from 0.2 degrees (Legge & Bigelow 2011, "Does print size matter for reading?").
float text_height_px(const ScreenPlace& place);

/// Nothing overlaps, and no line is cut: excess lines are left out, with a mark above or below, and
/// the focus is kept in view.
ScreenLayout lay_out(const ScreenPage& screen, const ScreenPlace& place, const TextWidth& width_of);

}  // namespace foveola
