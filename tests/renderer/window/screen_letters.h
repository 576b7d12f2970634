// Places for screens, and the letters that they are written with there; without a graphics card.
#pragma once

#include <string_view>
#include <vector>

#include <imgui.h>

#include "renderer/window/screens/screen_fonts.h"
#include "renderer/window/screens/screen_layout.h"

namespace foveola::test {

/// The letters of one size, without a graphics card.
class ScreenLetters {
 public:
  explicit ScreenLetters(float text_px, const Characters& more = {}) {
    fonts_.add_characters(more);
    fonts_.add_to(atlas_, text_px);
    atlas_.Build();
  }

  TextWidth width() const {
    return [this](TextFace face, std::string_view line) { return fonts_.width_px(face, line); };
  }
  const ScreenFonts& fonts() const { return fonts_; }

 private:
  ScreenFonts fonts_;
  ImFontAtlas atlas_;
};

/// A place for screens and its name.
struct PlaceCase {
  const char* name;
  ScreenPlace place;
};

inline ScreenPlace monitor(int width, int height) {
  return screen_place({.size = {width, height}}, height, std::nullopt);
}

inline ScreenPlace right_eye() {
  return screen_place({.origin = {1280, 0}, .size = {1280, 1440}}, 1440, Vec2(0.45F, 0.5F));
}

inline std::vector<PlaceCase> place_cases() {
  return {
      {"1280x720", monitor(1280, 720)},   {"1920x1080", monitor(1920, 1080)},
      {"2560x1440", monitor(2560, 1440)}, {"3840x2160", monitor(3840, 2160)},
      {"portrait", monitor(1080, 1920)},  {"square", monitor(600, 600)},
      {"headset", right_eye()},
  };
}

/// More than edges that meet.
inline bool overlap(const ScreenRect& a, const ScreenRect& b) {
  const Vec2 low = glm::max(a.low, b.low);
  const Vec2 high = glm::min(a.high, b.high);
  return high.x - low.x > 1.0F && high.y - low.y > 1.0F;
}

}  // namespace foveola::test
