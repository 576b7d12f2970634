#include "renderer/window/head_frame.h"

#include <vector>

namespace foveola {

ShownFrame head_frame(const WindowArea& window, const ViewGeometry& geometry, const Quat& head,
                      const ViewLook& look) {
  ShownFrame frame{.framebuffer = window.is_seen() ? window.framebuffer : IVec2(0), .look = look};
  const std::vector<Viewport> viewports = viewports_of(geometry, head);
  for (std::size_t i = 0; i < viewports.size(); ++i) {
    frame.views.push_back({.viewport = viewports[i], .part = geometry.parts[i]});
  }
  return frame;
}

FilmUpdate update_for(const ShownFrame& frame, const EquirectFilm& film, FilmMirror& mirror) {
  std::vector<Viewport> viewports;
  for (const ShownView& view : frame.views) {
    viewports.push_back(view.viewport);
  }
  const int levels =
      frame.look.fill_unsampled
          ? film.levels()
          : levels_shown(viewports.front(), frame.views.front().part.size, film.height());
  return mirror.collect(film, viewports, levels);
}

}  // namespace foveola
