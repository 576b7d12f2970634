// Text in pictures that no window shows.
#pragma once

#include <memory>
#include <string>

#include "renderer/base/vec.h"
#include "renderer/image/image.h"

namespace foveola {

/// Draws with the font that Dear ImGui brings along: 13 pixels high, Latin letters.
class TextDrawing {
 public:
  TextDrawing();
  ~TextDrawing();
  TextDrawing(const TextDrawing&) = delete;
  TextDrawing& operator=(const TextDrawing&) = delete;

  /// Draws one line in white into `image`, its top left corner at `corner` and cut off after
  /// `width` pixels. text: UTF-8; letters that the font does not have become question marks.
  void draw(const std::string& text, const IVec2& corner, int width, RgbImage& image) const;

 private:
  struct Font;
  std::unique_ptr<Font> font_;
};

}  // namespace foveola
