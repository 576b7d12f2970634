// Line breaking, and a column filled from its top: the building blocks of screens.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/window/screens/screen_layout.h"

namespace foveola {

/// Maximum length of a line, so that readers find its successor (Bringhurst, "The Elements of
/// Typographic Style", 2.1.2: 45 to 75 characters).
inline constexpr std::size_t max_line_characters = 70;

/// Width of a line of text in pixels.
using LineWidth = std::function<float(std::string_view line)>;

/// Breaks UTF-8 at its spaces and line breaks into lines of at most `width_px` and
/// max_line_characters. Longer words are broken within, and a wider letter has a line to itself. At
/// least one line.
std::vector<std::string> wrap_to_width(std::string_view text, float width_px,
                                       const LineWidth& width_of);

/// The widest word, in pixels.
float widest_word_px(std::string_view text, const LineWidth& width_of);

enum class Align { left, center, right };

class ScreenColumn {
 public:
  /// left_px, width_px: in the window. text_px: a line's height, the unit of other lengths.
  ScreenColumn(float left_px, float width_px, float text_px, const TextWidth& width_of)
      : left_px_(left_px), width_px_(width_px), text_px_(text_px), width_of_(&width_of) {}

  // --- Appending at its bottom ---

  void leave(float lines) { y_px_ += lines * text_px_; }
  /// Over the whole width, wrapped.
  void write(std::string_view text, TextFace face, Ink ink);
  /// Wrapped between left_px and right_px, relative to the column's left.
  void write_between(float left_px, float right_px, std::string_view text, Align align, Ink ink);

  // --- Placing anywhere, in pixels from its top left ---

  void put_line(const Vec2& low_px, std::string_view line, TextFace face, Ink ink);
  void put_shape(PlacedShape::Kind kind, const Vec2& low_px, const Vec2& size_px, Ink ink,
                 float outline_px = 0.0F);
  void put_frame(const Vec2& low_px, const Vec2& size_px, Ink ink, float outline_px);
  /// The region to keep in view.
  void put_focus(const Vec2& low_px, const Vec2& size_px);

  float bottom_px() const { return y_px_; }
  void set_bottom_px(float y_px) { y_px_ = y_px; }
  float width_px() const { return width_px_; }
  float text_px() const { return text_px_; }
  float line_width_px(std::string_view line) const { return (*width_of_)(TextFace::body, line); }
  LineWidth line_width(TextFace face) const;

  // --- Its content, with its top at y 0 ---

  const ScreenLayout& layout() const { return layout_; }
  const std::optional<ScreenRect>& focus() const { return focus_; }

 private:
  ScreenRect rect(const Vec2& low_px, const Vec2& size_px) const;

  float left_px_;
  float width_px_;
  float text_px_;
  const TextWidth* width_of_;
  float y_px_ = 0.0F;
  ScreenLayout layout_;
  std::optional<ScreenRect> focus_;
};

/// Distance between lines of running text, in heights of a line.
inline constexpr float line_spacing = 1.3F;

}  // namespace foveola
