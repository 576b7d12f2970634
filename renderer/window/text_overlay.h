// Text over the picture, or instead of it: help, frame times, screens.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "renderer/window/screen_fonts.h"
#include "renderer/window/screen_layout.h"
#include "renderer/window/view_renderer.h"

namespace foveola {

enum class PanelPlace { top_left, top_right, middle, bottom_left };

struct TextPanel {
  PanelPlace place = PanelPlace::top_left;
  std::vector<std::string> lines;
};

/// Dear ImGui's text, which is for drawing only: it receives neither keys nor pointer. Needs a
/// current context in all that it does; there can be one at a time.
class TextOverlay {
 public:
  TextOverlay();
  ~TextOverlay();
  TextOverlay(const TextOverlay&) = delete;
  TextOverlay& operator=(const TextOverlay&) = delete;

  /// Draws the panels into each part of a window of `framebuffer` pixels. A panel's first frame
  /// only measures it.
  void draw(const IVec2& framebuffer, std::span<const WindowPart> parts,
            std::span<const TextPanel> panels);
  /// Draws the screen at each of the places, which are of one size and inside a window of
  /// `framebuffer` pixels. Its letters are made when their size changes, or when one is new that is
  /// not of Europe's, which takes longer than a frame. Throws Error if the system lacks them.
  void draw(const IVec2& framebuffer, std::span<const ScreenPlace> places,
            const ScreenPage& screen);

 private:
  void make_letters(float text_px, const ScreenPage& screen);

  std::optional<ScreenFonts> fonts_;
  float text_px_ = 0.0F;  ///< the size that they were made in; 0: not made yet
};

}  // namespace foveola
