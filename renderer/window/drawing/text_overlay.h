// What stands over the picture, or instead of it: marks, screens, and panels of text.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "renderer/window/drawing/view_overlays.h"
#include "renderer/window/screens/panel_layout.h"
#include "renderer/window/screens/screen_fonts.h"
#include "renderer/window/screens/screen_layout.h"

namespace foveola {

/// What a frame has over its views, from below to above.
struct Overlaid {
  const ViewOverlays* marks = nullptr;  ///< null: none
  const ScreenPage* screen = nullptr;   ///< null: none
  std::span<const TextPanel> panels;
};

/// Dear ImGui, which is for drawing only: it receives neither keys nor pointer. Needs a current
/// context in all that it does; there can be one at a time.
class TextOverlay {
 public:
  TextOverlay();
  ~TextOverlay();
  TextOverlay(const TextOverlay&) = delete;
  TextOverlay& operator=(const TextOverlay&) = delete;

  /// Draws into each view's part of a window of `framebuffer` pixels. A screen's letters are made
  /// when their size changes, or when one is new that is not of Europe's, which takes longer than a
  /// frame. Throws Error if the system lacks them.
  void draw(const IVec2& framebuffer, std::span<const ShownView> views, const Overlaid& overlaid);

 private:
  void paint_screen(ImDrawList& list, const ScreenPage& screen, const ShownView& view,
                    int framebuffer_height) const;
  void make_letters(float text_px, const ScreenPage& screen);

  std::optional<ScreenFonts> fonts_;
  float text_px_ = 0.0F;  ///< the size that they were made in; 0: not made yet
};

}  // namespace foveola
