// Screens as they are drawn: on a display without a screen, at the sizes that windows have.
#pragma once

#include <optional>
#include <string>

#include "renderer/film/equirect_film.h"
#include "renderer/window/drawing/film_mirror.h"
#include "renderer/window/drawing/presenter.h"
#include "tests/x_server.h"

namespace foveola::test {

/// A window of a size: one view, or two side by side.
struct WindowCase {
  const char* name;
  IVec2 size;
  bool is_headset;
};

inline constexpr WindowCase window_cases[] = {
    {"1280x720", {1280, 720}, false},   {"1920x1080", {1920, 1080}, false},
    {"2560x1440", {2560, 1440}, false}, {"3840x2160", {3840, 2160}, false},
    {"headset", {2560, 1440}, true},
};

/// Draws screens over a film that is white all around.
class ScreenCapture {
 public:
  explicit ScreenCapture(const WindowCase& window);

  RgbImage capture(const std::optional<ScreenPage>& screen) {
    return capture(screen, window_case_.size);
  }
  RgbImage capture(const std::optional<ScreenPage>& screen, const IVec2& framebuffer);
  RgbImage capture(const ViewOverlays& overlays);

 private:
  /// The views and the film are added to what `frame` says.
  RgbImage draw(ShownFrame frame);

  WindowCase window_case_;
  XServer server_;
  SteadyClock clock_;
  WindowEvents events_;
  Window window_{{.size = window_case_.size}, events_, clock_};
  EquirectFilm film_{64, 32};
  FilmMirror mirror_{film_};
  WindowPresenter presenter_{window_, window_.framebuffer_size(), clock_};
};

/// Writes NAME.png into the folder that FOVEOLA_SCREENS names, if it does, for people to look at.
void keep_for_people(const std::string& name, const RgbImage& picture);

/// How many pixels of the picture's outermost 1 % are not of this ink.
int strangers_in_margin(const RgbImage& picture, Ink ink);

/// Whether a pixel is of an ink, but for the rounding of 8 bits.
bool is_ink(const Rgb& color, Ink ink);

}  // namespace foveola::test
