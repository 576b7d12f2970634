// What a participant sees: films as a head looks at them, and pages, in the window, frame by frame.
#pragma once

#include <filesystem>
#include <future>
#include <optional>
#include <string>

#include "renderer/base/clock.h"
#include "renderer/film/equirect_film.h"
#include "renderer/gaze/profiles.h"
#include "renderer/image/image.h"
#include "renderer/preview/frame_budget.h"
#include "renderer/window/drawing/display_pictures.h"
#include "renderer/window/drawing/film_drawing.h"
#include "renderer/window/drawing/presenter.h"
#include "renderer/window/drawing/view_geometry.h"
#include "renderer/window/screens/screen.h"

namespace foveola::study {

/// One frame's picture.
struct SessionPicture {
  Quat head{1.0F, 0.0F, 0.0F, 0.0F};  ///< world from head
  ViewLook look;
  ViewOverlays overlays;
  std::optional<ScreenPage> screen;
  bool lights_patch = false;  ///< whether the display's timing patch is white in it
};

class SessionDisplay {
 public:
  /// framebuffer: the window's size in pixels. The fields of view are those of this size for as
  /// long as it lives: a trial must not be seen through another view than its record says.
  /// presenter and clock must outlive it.
  SessionDisplay(Presenter& presenter, const DisplayProfile& profile, const IVec2& framebuffer,
                 const Clock& clock);
  SessionDisplay(const SessionDisplay&) = delete;
  SessionDisplay& operator=(const SessionDisplay&) = delete;

  void resize(const IVec2& framebuffer);
  void hide(bool is_hidden) { area_.is_hidden = is_hidden; }

  /// From now on, until show_no_film(): film and workers must outlive that. Has to be called for
  /// every new film, even if it lies where an old one was.
  void show_film(const EquirectFilm& film, const Workers& workers);
  /// Below pages that cover all, what was shown last may stay.
  void show_no_film() { drawing_.reset(); }

  /// The next frame that is drawn becomes a file, too.
  void take_picture(const std::filesystem::path& file) { picture_file_ = file; }
  /// Waits until the pictures so far are files. Throws Error for the first one that cannot be
  /// written.
  void finish_pictures() { pictures_.finish(); }

  /// The pixels of the next frame that is drawn to be seen, and becomes no file, are kept: those
  /// that are in the framebuffer once all is drawn, before it is swapped to the front.
  void keep_pixels() { keeps_pixels_ = true; }
  /// What was kept since it was asked for, sRGB in [0, 1], top row first; empty if nothing was.
  std::optional<RgbImage> take_pixels();

  /// Hands a frame over; returns when it is drawn. Throws Error if the graphics card cannot do it.
  void draw(SessionPicture picture);
  /// Waits until it is shown, and says when, if it was drawn to be seen.
  std::optional<Nanoseconds> wait_until_shown();
  /// draw and wait_until_shown, not faster than the display refreshes. Returns when it was shown,
  /// or would have been.
  Nanoseconds show(SessionPicture picture);

  const ViewGeometry& geometry() const { return geometry_; }
  /// By OpenXR.
  bool is_headset() const { return profile_.kind == DisplayKind::openxr; }
  const IVec2& framebuffer() const { return area_.framebuffer; }
  const RefreshEstimator& refresh() const { return refresh_; }
  /// What was learnt of the refreshes elsewhere.
  void set_refresh(const RefreshEstimator& refresh) { refresh_ = refresh; }
  /// What the next attempt's frames know of drawing here.
  const FrameBudget& frame_budget() const { return frame_budget_; }
  void set_frame_budget(const FrameBudget& budget) { frame_budget_ = budget; }
  const std::optional<TimingPatch>& timing_patch() const { return profile_.timing_patch; }
  /// The graphics card and its driver, in their own words.
  const std::string& graphics() const { return presenter_->graphics(); }

 private:
  const Clock* clock_;
  ViewGeometry geometry_;
  DisplayProfile profile_;
  WindowArea area_;
  RefreshEstimator refresh_;
  Nanoseconds next_frame_{0};
  Presenter* presenter_;
  FrameBudget frame_budget_;
  std::optional<FilmDrawing> drawing_;  ///< while there is a film
  std::optional<std::filesystem::path> picture_file_;
  bool keeps_pixels_ = false;
  std::future<RgbImage> pixels_;
  DisplayPictures pictures_;
};

}  // namespace foveola::study
