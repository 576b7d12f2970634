// Runs the preview in a window: frames at the display's refresh rate, and the effects of keys.
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

/// The result of a change of the scene's files.
struct SceneChange {
  const PathTracer* tracer = nullptr;  ///< of the new scene; null: the old one is kept
  std::shared_ptr<const void> owner;   ///< keeps the tracer and the surroundings alive
  CameraSurroundings surroundings;     ///< of the new scene
  std::vector<std::string> remarks;    ///< on the new scene, or why the old one is kept
  std::vector<std::string> warnings;   ///< on the new scene
  bool has_studio_light = false;       ///< whether it is the only light
  Nanoseconds changed{0};              ///< when the files were complete
};

/// A change that was shown, or refused.
struct ShownChange {
  bool is_refused = false;
  Nanoseconds after{0};  ///< from the change to the first frame that reflects it
};

struct LivePreviewSettings {
  DisplayProfile display;
  TrackerProfile tracker;
  PreviewChoices choices;  ///< the initial choices
  std::uint32_t seed = 0;
  IVec2 framebuffer{0};  ///< the picture's size, in pixels: of the window, or for one eye
  IVec2 window_px{0};    ///< the window's size
  /// Initial field of view across the larger side of a monitor's window; nullopt: the
  /// display's actual field of view.
  std::optional<double> larger_fov_deg;
  std::optional<std::uint64_t> frames;  ///< number of frames; default: until the user ends it
  bool keeps_last_picture = false;      ///< whether the last frame's picture is kept
  bool corrects_gaze = false;           ///< whether checks correct the gaze
  CalibrationTiming gaze_check;         ///< timing of checks
  std::vector<std::string> warnings;    ///< on the scene: counted at first, and shown by a key
  bool has_studio_light = false;        ///< whether it is the only light; reported at first
  /// Called with each line that the user should read at once; may be empty.
  std::function<void(const std::string& line)> notify;
  /// Called before each frame for the result of the scene's last change; may be empty.
  std::function<std::optional<SceneChange>()> take_change;
  /// Whether a changed scene is loading, which needs the processor; may be empty.
  std::function<bool()> is_loading;
};

/// The results of a live preview.
struct LivePreviewReport {
  std::vector<LiveFrame> frames;  ///< at least the last max_frames of them
  std::uint64_t frame_count = 0;
  std::uint64_t late_frames = 0;
  std::vector<std::string> methods;  ///< as rendered, one per start
  IVec2 framebuffer{0};              ///< the final size of the window, in pixels
  std::string graphics;              ///< the graphics card and its driver
  double refresh_rate_hz = 0.0;      ///< of the display: measured, or else from its profile
  bool is_refresh_measured = false;
  int threads = 0;                             ///< number of tracing threads
  std::optional<Nanoseconds> first_shown;      ///< the first picture, since the scene was loaded
  std::vector<GazeCheck> gaze_checks;          ///< in order
  std::vector<std::string> lost_monitors;      ///< names, in order of their loss
  std::vector<ShownChange> changes;            ///< of the scene, in order
  std::vector<HeadsetChange> headset_changes;  ///< in order
  std::optional<SlowDrawing> slow_drawing;     ///< from its first detection; otherwise empty
  std::optional<RgbImage> last_picture;        ///< sRGB in [0, 1]
  /// Options that show the last view again: --camera, --head, and a monitor's --fov.
  std::string last_view;
  static constexpr std::size_t max_frames = 1 << 16;
};

/// Call run() once, in a thread of its own: the window's events are passed on in the program's
/// first thread, and the presenter draws in another.
class LivePreview {
 public:
  /// Its parts, all of which must outlive it. None is null but widened_eye.
  struct Parts {
    Preview* preview;
    Steering* steering;
    FreeCamera* camera;
    CorrectedEyeTracker* eye;
    /// The preview's eye tracker if its view may be widened; null otherwise.
    WidenedEyeTracker* widened_eye;
    Window* window;
    WindowEvents* events;
    Presenter* presenter;
    const Workers* workers;
    const Clock* clock;
  };

  LivePreview(const LivePreviewSettings& settings, const Parts& parts);

  /// Keeps the first scene alive until a change replaces it.
  void keep_alive(std::shared_ptr<const void> scene) { scene_ = std::move(scene); }

  /// Runs until the user closes the window, the frames are done, or `stop` is requested.
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
  void report_slow_drawing(const LiveFrames& live);
  void begin_check();
  void continue_check(const Preview& preview);
  void end_check();
  void judge(const std::vector<WatchedTarget>& watched);
  void take_picture(ShownFrame& frame);
  void report_pictures();
  void report_warnings();
  std::vector<TextPanel> panels() const;
  ShownNow shown_now() const;

  LivePreviewSettings settings_;
  Parts parts_;
  PreviewChoices choices_;
  WindowArea area_;
  WindowResized window_;  ///< its size while it had room
  WindowView view_;
  Nanoseconds start_;
  FilmDrawing drawing_;
  LivePreviewReport report_;
  TrackerCheck check_;
  PreviewMessages messages_;
  std::shared_ptr<const void> scene_;     ///< keeps the shown scene alive
  std::optional<SceneChange> not_shown_;  ///< first shown by the next frame
  bool is_done_ = false;
  bool wants_picture_ = false;
  std::optional<std::future<RgbImage>> last_picture_;
  DisplayPictures pictures_;
};

}  // namespace foveola
