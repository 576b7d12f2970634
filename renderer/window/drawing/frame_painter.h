// Draws frames with OpenGL: what of it lives on the graphics card.
#pragma once

#include <optional>
#include <string>

#include "renderer/window/drawing/presenter.h"
#include "renderer/window/drawing/text_overlay.h"
#include "renderer/window/drawing/view_renderer.h"

namespace foveola {

/// Needs a current OpenGL 3.3 context in all that it does, always the same one. Draws into the
/// framebuffer that is bound.
class FramePainter {
 public:
  /// All of it, as a window shows it.
  void draw(const ShownFrame& frame);

  // The same in parts, for who shows it otherwise.

  /// Brings the graphics card's copy of the film up to date.
  void update_film(const ShownFrame& frame);
  /// What `view` shows of that copy, if the frame shows any of it.
  void draw_film(const ShownFrame& frame, const ShownView& view);
  /// Marks and screens, and `panels`, over pictures of `framebuffer` pixels.
  void draw_over(const ShownFrame& frame, const IVec2& framebuffer,
                 std::span<const ShownView> views, std::span<const TextPanel> panels);

 private:
  void draw_films(const ShownFrame& frame);

  std::optional<FilmTexture> film_;  ///< once there is one to draw
  ViewRenderer renderer_;
  PictureTexture picture_;
  TextOverlay text_;
};

/// What is in the framebuffer that is bound, sRGB in [0, 1], top row first.
RgbImage read_picture(const IVec2& size);

/// The graphics card and its driver, in their own words.
std::string graphics_name();

/// Throws Error for a window of more pixels, to either side, than OpenGL draws.
void require_drawable(const IVec2& window_px);

}  // namespace foveola
