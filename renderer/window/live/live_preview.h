// The preview in a window: frames at the display's pace, and what keys do to them.
#pragma once

#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "renderer/gaze/calibration.h"
#include "renderer/gaze/profiles.h"
#include "renderer/preview/live_frames.h"
#include "renderer/preview/preview.h"
#include "renderer/window/drawing/display_pictures.h"
#include "renderer/window/drawing/film_drawing.h"
#include "renderer/window/drawing/presenter.h"
#include "renderer/window/drawing/slow_drawing.h"
#include "renderer/window/drawing/view_geometry.h"
#include "renderer/window/live/free_camera.h"
#include "renderer/window/live/preview_controls.h"
#include "renderer/window/live/preview_panels.h"
#include "renderer/window/live/steering.h"
#include "renderer/window/live/window_gaze.h"
#include "renderer/window/window.h"

namespace foveola {

/// What became of a change of the scene's files.
struct SceneChange {
  const PathTracer* tracer = nullptr;  ///< of the new scene; null: the old one stays
  std::shared_ptr<const void> owner;   ///< keeps the tracer and the surroundings alive
  CameraSurroundings surroundings;     ///< those of the new scene
  std::vector<std::string> remarks;    ///< on the new scene, or why the old one stays
  std::vector<std::string> warnings;   ///< on the new scene
  bool has_studio_light = false;       ///< whether only that lights it
  Nanoseconds changed{0};              ///< when the files were complete
};

/// A change that was shown, or refused.
struct ShownChange {
  bool is_refused = false;
  Nanoseconds after{0};  ///< from the change to the first frame that shows it, or says so
};

struct LivePreviewSettings {
  DisplayProfile display;
  TrackerProfile tracker;
  PreviewChoices choices;  ///< the choices to begin with
  std::uint32_t seed = 0;
  IVec2 framebuffer{0};  ///< the picture's size, in pixels: the window's, or that for one eye
  IVec2 window_px{0};    ///< the window's
  /// The field of view to begin with across the larger side of a monitor's window; empty: true
  /// angles.
  std::optional<double> larger_fov_deg;
  std::optional<std::uint64_t> frames;  ///< ends after so many; default: when the user does
  bool keeps_last_picture = false;      ///< whether the last frame's picture is kept
  bool corrects_gaze = false;           ///< whether the gaze is corrected by what each check finds
  CalibrationTiming gaze_check;         ///< timing of such a check
  std::vector<std::string> warnings;    ///< on the scene: counted at first, and shown by a key
  bool has_studio_light = false;        ///< whether only that lights it; named at first
  /// Called with each line that the user should read at once; may be empty.
  std::function<void(const std::string& line)> notify;
  /// Asked before each frame for what became of the last change of the scene; may be empty.
  std::function<std::optional<SceneChange>()> take_change;
  /// Whether a changed scene is being loaded, so that the processor is needed there; may be empty.
  std::function<bool()> is_loading;
};

/// What happened in a live preview.
struct LivePreviewReport {
  std::vector<LiveFrame> frames;  ///< at least the last max_frames of them
  std::uint64_t frame_count = 0;
  std::uint64_t late_frames = 0;
  std::vector<std::string> methods;  ///< as they were rendered, one for each start
  IVec2 framebuffer{0};              ///< the window's size in the end, in pixels
  std::string graphics;              ///< the graphics card and its driver
  double refresh_rate_hz = 0.0;      ///< the display's: measured, or else its profile's
  bool is_refresh_measured = false;
  int threads = 0;                             ///< threads that traced
  std::optional<Nanoseconds> first_shown;      ///< the first picture, after the scene was loaded
  std::vector<GazeCheck> gaze_checks;          ///< in the order they were made
  std::vector<std::string> lost_monitors;      ///< names, in the order they were lost
  std::vector<ShownChange> changes;            ///< of the scene, in their order
  std::vector<HeadsetChange> headset_changes;  ///< in their order
  std::optional<SlowDrawing> slow_drawing;     ///< when it was first found too slow; else none
  std::optional<RgbImage> last_picture;        ///< sRGB in [0, 1]
  /// The last view as options that show it again: --camera, --head, and a monitor's --fov.
  std::string last_view;
  static constexpr std::size_t max_frames = 1 << 16;
};

/// Runs in one thread, beside the one that passes on the window's events and the one that draws.
class LivePreview {
 public:
  /// What it works with, all of which must outlive it.
  struct Parts {
    Preview* preview;
    Steering* steering;
    FreeCamera* camera;
    CorrectedEyeTracker* eye;
    /// The same as the preview sees it if its view may be wider than it is seen; null: it knows.
    WidenedEyeTracker* widened_eye;
    Window* window;
    WindowEvents* events;
    Presenter* presenter;
    const Workers* workers;
    const Clock* clock;
  };

  LivePreview(const LivePreviewSettings& settings, const Parts& parts);

  /// Keeps alive what is shown first, until a change takes its place.
  void own(std::shared_ptr<const void> scene) { scene_ = std::move(scene); }

  /// Until the user closes the window, the frames are done, or `stop` is requested.
  LivePreviewReport run(const std::stop_token& stop);

 private:
  void answer_events();
  void answer(const WindowEvent& event);
  void answer(const KeyMoved& key);
  void answer(HeadsetChange change);
  void follow_size(const WindowResized& size);
  bool is_in_headset() const { return settings_.display.kind == DisplayKind::openxr; }
  void act(PreviewAction action);
  void restart();
  void move_camera();
  void follow_change();
  void note_change_shown(const LiveFrame& frame);
  void show_view();
  void zoom(double steps);
  void print(const std::string& line) const;
  void tell(const std::string& message, MessageStay stay = MessageStay::briefly);

  void draw(const Preview& preview);
  std::optional<Nanoseconds> wait_until_shown();
  void keep(const LiveFrame& frame);
  void tell_of_slow_drawing(const LiveFrames& live);
  void begin_check();
  void go_on_checking(const Preview& preview);
  void leave_check();
  void judge(const std::vector<WatchedTarget>& watched);
  void take_picture(ShownFrame& frame);
  void tell_of_pictures();
  void tell_of_warnings();
  std::vector<TextPanel> panels() const;
  ShownNow shown_now() const;

  LivePreviewSettings settings_;
  Parts parts_;
  PreviewChoices choices_;
  WindowArea area_;
  WindowResized window_;  ///< its size as long as it had room
  WindowView view_;
  Nanoseconds start_;
  FilmDrawing drawing_;
  LivePreviewReport report_;
  TrackerCheck check_;
  PreviewMessages messages_;
  std::shared_ptr<const void> scene_;     ///< keeps what is shown alive
  std::optional<SceneChange> not_shown_;  ///< what the next frame shows first
  bool is_done_ = false;
  bool wants_picture_ = false;
  std::optional<std::future<RgbImage>> last_picture_;
  DisplayPictures pictures_;
};

}  // namespace foveola
