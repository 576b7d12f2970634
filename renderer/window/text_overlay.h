// Text over the picture: help, frame times.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "renderer/window/view_renderer.h"

namespace foveola {

enum class PanelPlace { top_left, top_right, middle, bottom_left };

struct TextPanel {
  PanelPlace place = PanelPlace::top_left;
  std::vector<std::string> lines;
};

/// Dear ImGui's text, which is for drawing only: it hears of no key and no pointer. Needs a current
/// context in all that it does; there can be one at a time.
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
};

}  // namespace foveola
