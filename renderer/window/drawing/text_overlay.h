// Draws overlays on the picture: marks, screens, and panels of text.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "renderer/window/drawing/view_overlays.h"
#include "renderer/window/screens/panel_layout.h"
#include "renderer/window/screens/screen_fonts.h"
#include "renderer/window/screens/screen_layout.h"

namespace foveola {

/// A frame's overlays, from bottom to top.
struct Overlaid {
  const ViewOverlays* marks = nullptr;  ///< null: none
  const ScreenPage* screen = nullptr;   ///< null: none
  std::span<const TextPanel> panels;
};

/// Dear ImGui, for drawing only: it receives neither keys nor pointer. Needs a current context
/// throughout; only one instance at a time.
class TextOverlay {
 public:
  TextOverlay();
  ~TextOverlay();
  TextOverlay(const TextOverlay&) = delete;
  TextOverlay& operator=(const TextOverlay&) = delete;

  /// Draws into each view's part of a window of `framebuffer` pixels. Glyphs are rendered when
  /// their size changes, or for a new character outside Europe's, which takes longer than a frame.
  /// Throws Error if the system lacks the fonts.
  void draw(const IVec2& framebuffer, std::span<const ShownView> views, const Overlaid& overlaid);

 private:
  void paint_screen(ImDrawList& list, const ScreenPage& screen, const ShownView& view,
                    int framebuffer_height) const;
  void make_letters(float text_px, const ScreenPage& screen);

  std::optional<ScreenFonts> fonts_;
  float text_px_ = 0.0F;  ///< the glyphs' size; 0: not yet rendered
};

}  // namespace foveola
