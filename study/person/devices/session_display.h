// Draws a session's films, seen by the participant's head, and its pages, frame by frame.
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
  /// framebuffer: the window's size in pixels. It fixes the fields of view for the display's
  /// lifetime, so that a trial's view is always the recorded one. presenter and clock must outlive
  /// it.
  SessionDisplay(Presenter& presenter, const DisplayProfile& profile, const IVec2& framebuffer,
                 const Clock& clock);
  SessionDisplay(const SessionDisplay&) = delete;
  SessionDisplay& operator=(const SessionDisplay&) = delete;

  void resize(const IVec2& framebuffer);
  void hide(bool is_hidden) { area_.is_hidden = is_hidden; }

  /// Shows the film from now on, until show_no_film(). film and workers must last until then. Call
  /// it for every new film, even at the address of an old one.
  void show_film(const EquirectFilm& film, const Workers& workers);
  /// Stops showing a film. Pages that cover everything may hide the last picture.
  void show_no_film() { drawing_.reset(); }

  /// Writes the next frame that is drawn to `file`.
  void take_picture(const std::filesystem::path& file) { picture_file_ = file; }
  /// Waits until all pictures are written. Throws Error for the first one that cannot be written.
  void finish_pictures() { pictures_.finish(); }

  /// Keeps the pixels of the next visible frame that is not written to a file, as they are in the
  /// framebuffer before the swap.
  void keep_pixels() { keeps_pixels_ = true; }
  /// Returns the kept pixels, sRGB in [0, 1], top row first; empty if there are none.
  std::optional<RgbImage> take_pixels();

  /// Submits a frame; returns when it is drawn. Throws Error if the graphics card fails.
  void draw(SessionPicture picture);
  /// Waits until the frame is shown. Returns that time; empty if it was not drawn to be seen.
  std::optional<Nanoseconds> wait_until_shown();
  /// Calls draw and wait_until_shown, at most once per refresh. Returns the time at which the frame
  /// was shown, or would have been.
  Nanoseconds show(SessionPicture picture);

  const ViewGeometry& geometry() const { return geometry_; }
  bool is_headset() const { return profile_.kind == DisplayKind::openxr; }
  const IVec2& framebuffer() const { return area_.framebuffer; }
  const RefreshEstimator& refresh() const { return refresh_; }
  /// Sets the refreshes that were measured elsewhere.
  void set_refresh(const RefreshEstimator& refresh) { refresh_ = refresh; }
  /// Drawing times, for the next attempt's frames.
  const FrameBudget& frame_budget() const { return frame_budget_; }
  void set_frame_budget(const FrameBudget& budget) { frame_budget_ = budget; }
  const std::optional<TimingPatch>& timing_patch() const { return profile_.timing_patch; }
  /// The graphics card and its driver, as they name themselves.
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
