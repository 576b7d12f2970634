// A headset in which a film's pattern is shown, whatever runtime it has.
#pragma once

#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "renderer/headset/headset_presenter.h"
#include "renderer/window/drawing/film_drawing.h"
#include "renderer/window/window.h"

namespace foveola::test {

class WornHeadset {
 public:
  /// A window needs a display. Throws as HeadsetPresenter.
  WornHeadset();

  HeadsetPresenter& presenter() { return presenter_; }
  const EquirectFilm& film() const { return film_; }
  const Workers& workers() const { return workers_; }
  Nanoseconds now() const { return clock_.now(); }

  /// Shows the film's pattern where the head looks, or a page, once.
  void show(const std::optional<ScreenPage>& page = {});
  /// As show(), and returns what the left eye's picture was, read back before the runtime got it.
  RgbImage shown_picture();

  /// So many keys that were pressed or let go since the last call.
  std::vector<std::pair<int, bool>> keys(std::size_t count);
  /// What was told of the headset until `last`, whatever else happened; what came after that is for
  /// the next call.
  std::vector<HeadsetChange> changes_until(HeadsetChange last);

 private:
  ShownFrame frame();
  /// The next event that was not looked at yet, if there is one.
  std::optional<WindowEvent> next_event();

  SteadyClock clock_;
  WindowEvents events_;
  std::deque<WindowEvent> unseen_events_;
  Window window_{WindowSettings{.size = {320, 240}}, events_, clock_};
  Workers workers_{2};
  EquirectFilm film_{600, 300};
  FilmDrawing drawing_{film_, FilmDrawer::graphics_card, workers_};
  HeadsetPresenter presenter_{window_, events_, clock_};
};

}  // namespace foveola::test
