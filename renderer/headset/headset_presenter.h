// The thread that shows frames in a headset, with the head's orientation at display, at the
// headset's own pace, however long the next frame takes to render.
#pragma once

#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/headset/headset_connection.h"
#include "renderer/headset/headset_motion.h"
#include "renderer/window/drawing/presenter.h"
#include "renderer/window/window.h"

namespace foveola {

class HeadsetPresenter final : public Presenter {
 public:
  /// Takes the window's context, and shows the left eye's view in it a few times a second. Pushes
  /// changes of the headset and its wearer's keys into `events`. Waits until the headset is there
  /// and its orientation known. All must outlive it. Throws Error with a remedy if there is none.
  HeadsetPresenter(Window& window, WindowEvents& events, const Clock& clock);
  ~HeadsetPresenter() override;
  HeadsetPresenter(const HeadsetPresenter&) = delete;
  HeadsetPresenter& operator=(const HeadsetPresenter&) = delete;

  void draw(ShownFrame frame) override { handover_.draw(std::move(frame)); }
  /// The time of the runtime's first request for a frame after this one was drawn, which is
  /// displayed HeadsetFacts::display_delay later.
  Nanoseconds wait_until_shown() override { return handover_.wait_until_shown(); }
  const std::string& graphics() const override { return graphics_; }
  FilmDrawer film_drawer() const override { return FilmDrawer::graphics_card; }
  /// Heads turn by up to a few hundred degrees a second.
  double late_turn_rad() const override { return radians(15.0); }
  /// The left eye's view.
  ViewGeometry in_window(const ViewGeometry& shown, const IVec2& window_px) const override;

  const HeadsetFacts& facts() const { return *facts_; }
  HeadsetMotion& motion() { return motion_; }

 private:
  void run(const std::stop_token& stop);
  void serve(FramePainter& painter, const std::stop_token& stop);
  /// Runs until the headset is lost or its runtime asks the program to end.
  void show_in(HeadsetConnection& headset, FramePainter& painter, const std::stop_token& stop);
  void show_frame(HeadsetConnection& headset, FramePainter& painter);
  void learn_facts(HeadsetConnection& headset, const XrPlannedFrame& planned, Nanoseconds asked);
  /// Takes frames without showing them for this time, so that no thread waits for an absent
  /// headset.
  void serve_nobody(FramePainter& painter, Nanoseconds duration, const std::stop_token& stop);
  bool take_frame(FramePainter& painter);
  /// Fails the picture of a frame that was not shown.
  void give_up_picture();
  void tell(HeadsetChange change);

  Window* window_;
  WindowEvents* events_;
  const Clock* clock_;
  std::string graphics_;
  std::optional<HeadsetFacts> facts_;
  HeadsetMotion motion_;
  FrameHandover handover_;
  // Of the drawing thread:
  ShownFrame shown_;  ///< the newest frame
  HeadsetMirror mirror_;
  std::vector<WindowEvent> keys_;
  std::vector<HeadsetChange> changes_;
  std::jthread thread_;  ///< last: it ends before the other members
};

}  // namespace foveola
