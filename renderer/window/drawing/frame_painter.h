// Draws frames with OpenGL, and owns their objects on the graphics card.
#pragma once

#include <optional>
#include <string>

#include "renderer/window/drawing/presenter.h"
#include "renderer/window/drawing/text_overlay.h"
#include "renderer/window/drawing/view_renderer.h"

namespace foveola {

/// Needs a current OpenGL 3.3 context throughout, always the same. Draws into the bound
/// framebuffer.
class FramePainter {
 public:
  /// Draws all of it, as in a window.
  void draw(const ShownFrame& frame);

  // The same in parts, for other displays.

  /// Updates the graphics card's copy of the film.
  void update_film(const ShownFrame& frame);
  /// Draws `view` of that copy, if the frame shows the film.
  void draw_film(const ShownFrame& frame, const ShownView& view);
  /// Draws marks, screens and `panels` over pictures of `framebuffer` pixels.
  void draw_over(const ShownFrame& frame, const IVec2& framebuffer,
                 std::span<const ShownView> views, std::span<const TextPanel> panels);

 private:
  void draw_films(const ShownFrame& frame);

  std::optional<FilmTexture> film_;  ///< from the first one drawn
  ViewRenderer renderer_;
  PictureTexture picture_;
  TextOverlay text_;
};

/// The content of the bound framebuffer, sRGB in [0, 1], top row first.
RgbImage read_picture(const IVec2& size);

/// The graphics card's and its driver's own names.
std::string graphics_name();

/// Throws Error if a side of the window exceeds OpenGL's maximum.
void require_drawable(const IVec2& window_px);

}  // namespace foveola
