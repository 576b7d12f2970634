// Draws a film in a window: resampled by the graphics card or, without one, by the processor.
#pragma once

#include <memory>
#include <string_view>
#include <variant>
#include <vector>

#include "renderer/base/work/parallel.h"
#include "renderer/film/equirect_film.h"
#include "renderer/film/viewport_resampler.h"
#include "renderer/preview/frame_budget.h"
#include "renderer/window/drawing/film_mirror.h"
#include "renderer/window/drawing/presenter.h"
#include "renderer/window/drawing/view_geometry.h"

namespace foveola {

/// The processor if OpenGL is computed in software, as Mesa's software drivers state in their names
/// ("llvmpipe", "softpipe", "SWR"). Their shaders take ten times as long as our resampling, which
/// recomputes only changes.
FilmDrawer default_drawer(std::string_view graphics);

/// A budget for frames with this drawer.
FrameBudget frame_budget_for(FilmDrawer drawer);

/// Provides one window's frames with the content of one film.
class FilmDrawing {
 public:
  /// film and workers must outlive it. film: for the graphics card at most 65535 pixels wide.
  FilmDrawing(const EquirectFilm& film, FilmDrawer drawer, const Workers& workers);

  /// Updates `frame`, whose views and look are set, to the film's current state. The frame refers
  /// to this object until the next call.
  void bring_up_to_date(ShownFrame& frame);

 private:
  /// One view's resampler, until its size changes.
  struct ProcessorView {
    ViewImage settings;
    std::unique_ptr<DisplayResampler> resampler;
  };
  using ProcessorViews = std::vector<ProcessorView>;

  void update_card(ShownFrame& frame, FilmMirror& mirror);
  void resample(ShownFrame& frame, ProcessorViews& views) const;

  const EquirectFilm* film_;
  const Workers* workers_;
  std::variant<ProcessorViews, FilmMirror> drawer_;
  bool is_new_ = true;  ///< no content of this film has been drawn
};

/// The window's area, by its events.
struct WindowArea {
  IVec2 framebuffer{0};    ///< pixels
  bool is_hidden = false;  ///< minimised

  /// Whether there is room for all views, one per eye in a headset.
  bool has_room() const { return framebuffer.x >= 2 && framebuffer.y >= 1; }
  bool is_seen() const { return !is_hidden && has_room(); }
};

/// A frame with the head's views in their parts of the window, and nothing else. Empty if the
/// window is not visible.
ShownFrame head_frame(const WindowArea& window, const ViewGeometry& geometry, const Quat& head,
                      const ViewLook& look);

/// The update of `film` that the graphics card needs before it draws this frame. mirror: of this
/// film.
FilmUpdate update_for(const ShownFrame& frame, const EquirectFilm& film, FilmMirror& mirror);

}  // namespace foveola
