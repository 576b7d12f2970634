// A frame of what a head sees of a film in a window.
#pragma once

#include "renderer/film/equirect_film.h"
#include "renderer/window/film_mirror.h"
#include "renderer/window/presenter.h"
#include "renderer/window/view_geometry.h"

namespace foveola {

/// The window, as its events describe it.
struct WindowArea {
  IVec2 framebuffer{0};    ///< pixels
  bool is_hidden = false;  ///< minimised

  /// Whether there is room for views, one for each eye in a headset.
  bool has_room() const { return framebuffer.x >= 2 && framebuffer.y >= 1; }
  bool is_seen() const { return !is_hidden && has_room(); }
};

/// The head's views in their parts of the window, and nothing else yet. Of a window that is not
/// seen, nothing is drawn.
ShownFrame head_frame(const WindowArea& window, const ViewGeometry& geometry, const Quat& head,
                      const ViewLook& look);

/// The update of `film` that the graphics card needs before it draws such a frame. mirror: of this
/// film.
FilmUpdate update_for(const ShownFrame& frame, const EquirectFilm& film, FilmMirror& mirror);

}  // namespace foveola
