// How a film gets into a window: resampled by the graphics card, or by the processor where there is
// none.
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

/// The processor where OpenGL itself is computed by it, which Mesa's software drivers say in their
/// names ("llvmpipe", "softpipe", "SWR"): their shaders take ten times as long as our resampling,
/// which does again only what changed.
FilmDrawer default_drawer(std::string_view graphics);

/// For frames that are drawn so.
FrameBudget frame_budget_for(FilmDrawer drawer);

/// Gives frames of one window what they show of one film.
class FilmDrawing {
 public:
  /// film and workers must outlive it. film: for the graphics card at most 65535 pixels wide.
  FilmDrawing(const EquirectFilm& film, FilmDrawer drawer, const Workers& workers);

  /// Brings `frame`, whose views and look are set, up to the film as it is now. The frame refers to
  /// this object until the next call.
  void bring_up_to_date(ShownFrame& frame);

 private:
  /// One view's resampler, for as long as its size stays.
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
  bool is_new_ = true;  ///< nothing of this film was drawn yet
};

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
