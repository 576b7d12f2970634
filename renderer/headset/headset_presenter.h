// The thread that shows frames in a headset: both eyes' pictures, as the head is turned when they
// are seen, at the headset's own pace, however long the next frame takes to render.
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
  /// Takes the window's context, and shows in it what the left eye sees, a few times a second.
  /// Changes of the headset and its wearer's keys are pushed into `events`. Waits until the headset
  /// is there and knows how it is turned. All must outlive it. Throws Error, with what to do, if
  /// there is none.
  HeadsetPresenter(Window& window, WindowEvents& events, const Clock& clock);
  ~HeadsetPresenter() override;
  HeadsetPresenter(const HeadsetPresenter&) = delete;
  HeadsetPresenter& operator=(const HeadsetPresenter&) = delete;

  void draw(ShownFrame frame) override { handover_.draw(std::move(frame)); }
  /// When the headset's runtime asked for a frame after this one was drawn: this one is seen
  /// HeadsetFacts::display_delay later.
  Nanoseconds wait_until_shown() override { return handover_.wait_until_shown(); }
  const std::string& graphics() const override { return graphics_; }
  FilmDrawer film_drawer() const override { return FilmDrawer::graphics_card; }
  /// Heads turn by up to a few hundred degrees a second.
  double late_turn_rad() const override { return radians(15.0); }
  /// What the left eye sees.
  ViewGeometry in_window(const ViewGeometry& shown, const IVec2& window_px) const override;

  const HeadsetFacts& facts() const { return *facts_; }
  HeadsetMotion& motion() { return motion_; }

 private:
  void run(const std::stop_token& stop);
  void serve(FramePainter& painter, const std::stop_token& stop);
  /// Until the headset is lost or its runtime wants the program to end.
  void show_in(HeadsetConnection& headset, FramePainter& painter, const std::stop_token& stop);
  void show_frame(HeadsetConnection& headset, FramePainter& painter);
  void learn_facts(HeadsetConnection& headset, const XrPlannedFrame& planned, Nanoseconds asked);
  /// Takes frames without showing them for so long, so that nobody waits for a headset that is not
  /// there.
  void serve_nobody(FramePainter& painter, Nanoseconds duration, const std::stop_token& stop);
  bool take_frame(FramePainter& painter);
  /// Whoever waits for the picture of a frame that was not shown is told so.
  void give_up_picture();
  void tell(HeadsetChange change);

  Window* window_;
  WindowEvents* events_;
  const Clock* clock_;
  std::string graphics_;
  std::optional<HeadsetFacts> facts_;
  HeadsetMotion motion_;
  FrameHandover handover_;
  // The drawing thread's:
  ShownFrame shown_;  ///< the newest one
  HeadsetMirror mirror_;
  std::vector<WindowEvent> keys_;
  std::vector<HeadsetChange> changes_;
  std::jthread thread_;  ///< last: it ends before the rest does
};

}  // namespace foveola
