// The letters of screens, as large as a window asks for.
#pragma once

#include <filesystem>
#include <string>

#include "renderer/window/screen_layout.h"

struct ImFont;
struct ImFontAtlas;

namespace foveola {

/// DejaVu Sans: Latin, Greek, Cyrillic, punctuation and arrows. Other characters are shown as a
/// question mark.
class ScreenFonts {
 public:
  /// Reads its files, by default where Debian keeps them. Throws Error if they are not there.
  explicit ScreenFonts(const std::filesystem::path& folder = "/usr/share/fonts/truetype/dejavu");

  /// Adds both faces to `atlas`, which must not outlive this. text_px: a line's height.
  void add_to(ImFontAtlas& atlas, float text_px);

  // --- Once the atlas is built ---

  ImFont* face(TextFace face) const { return face == TextFace::title ? title_ : body_; }
  float height_px(TextFace face) const;
  /// Pixels from the left of the first letter to the right of the last.
  float width_px(TextFace face, std::string_view line) const;

 private:
  std::string body_file_;
  std::string title_file_;
  ImFont* body_ = nullptr;
  ImFont* title_ = nullptr;
};

}  // namespace foveola
