// The frame loop: poll head and gaze, aim, trace, update the film, present.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/film/equirect_film.h"
#include "renderer/film/viewport_resampler.h"
#include "renderer/gaze/eye_tracker.h"
#include "renderer/gaze/gaze_filter.h"
#include "renderer/gaze/head_tracker.h"
#include "renderer/progressive/progressive_render.h"
#include "renderer/trace/paths/path_tracer.h"
#include "renderer/view/view_sampler.h"

namespace foveola {

struct PreviewSettings {
  /// Adaptive sampling uses the exposure below.
  ProgressiveSettings render;
  FieldOfView field_of_view;
  IVec2 view_size = default_view_size;                 ///< pixels of the presented image
  UnsampledPixels unsampled = UnsampledPixels::black;  ///< in the presented image
  double exposure_stops = 0.0;  ///< the presented image is brightened by 2^stops
  /// Filters of the frames' gaze, in the head's axes of the eye tracker. Kept by a restart.
  GazeFilterSettings gaze_filter;
};

/// One frame's events, for the record.
struct FrameReport {
  std::uint64_t frame = 0;       ///< counted from the last restart
  Nanoseconds time{0};           ///< when head and gaze were polled
  AzimuthElevation head;         ///< world
  double head_roll_rad = 0.0;    ///< as in HeadPose
  Vec3 gaze{0.0F, 0.0F, -1.0F};  ///< unit length, world: the gaze in use
  /// Whether the newest filtered sample was valid. If not, the last valid one is kept in the head's
  /// axes, or straight ahead before the first.
  bool gaze_valid = false;
  bool gaze_held = false;     ///< the gaze is frozen, whatever the tracker reports
  Nanoseconds gaze_age{0};    ///< age at `time` of the gaze in use; 0 before the first valid one
  std::uint64_t samples = 0;  ///< traced in this frame
  std::uint64_t rays = 0;
};

/// Renders frame after frame with the method of the last restart, which must precede the first
/// frame. The tracer, the trackers and the workers must outlive it; its owner keeps the clock.
class Preview {
 public:
  /// Throws Error for an impossible film size or field of view.
  Preview(const PathTracer& tracer, const PreviewSettings& settings, EyeTracker& eye,
          HeadTracker& head, const Workers& workers);
  ~Preview();

  /// Clears the film and renders with `method` (see make_view_sampler) from the next frame on.
  /// Points and paths are redrawn from `seed`. Throws Error as make_view_sampler does.
  void restart(std::string_view method, std::uint32_t seed);
  /// Restarts with an existing sampler.
  void restart(std::unique_ptr<ViewSampler> sampler, std::uint32_t seed);

  /// Clears the film and continues at another place, in the scene's coordinates, with the same
  /// sampler and seed.
  void stand_at(const Vec3& viewpoint);
  /// Continues in another scene, at `viewpoint`, with an empty film. The tracer must outlive this.
  void show(const PathTracer& tracer, const Vec3& viewpoint);

  /// As ProgressiveRender::cut_samples.
  void cut_samples(float largest_radiance) { render_.cut_samples(largest_radiance); }

  /// Polls head and gaze at `now` and traces `samples` samples; the caller knows how many fit into
  /// a frame (by a budget or a model of a machine).
  FrameReport render_frame(Nanoseconds now, std::uint64_t samples);

  /// Polls, and begins a frame that is traced in pieces.
  FrameReport begin_frame(Nanoseconds now);
  /// Begins a frame at the time of `head`, without polling: head and gaze (unit length, world) are
  /// known, as in a recording.
  FrameReport begin_frame(const HeadPose& head, const Vec3& gaze);
  /// Traces `samples` more samples in the frame of `report`.
  void trace(std::uint64_t samples, FrameReport& report);

  /// Freezes the last frame's gaze in the world, while the head looks around, or releases it.
  /// Before the first frame that gaze is straight ahead at azimuth 0.
  void hold_gaze(bool held);

  /// Changes the field of view from the next frame on. Throws Error if it cannot be shown flat.
  void set_view(const FieldOfView& view);

  /// Sets the user's pointer (unit length, world). Without it, methods that follow the pointer
  /// follow the gaze. Kept by a restart.
  void point_at(const std::optional<Vec3>& pointer) { pointer_ = pointer; }

  /// The image for the display at the last frame's head pose: sRGB-encoded, in [0, 1]. Valid until
  /// the next call.
  const RgbImage& present();
  /// The view of the last frame.
  const Viewport& viewport() const { return viewport_; }
  /// The gaze of the last frame: unit length, world.
  const Vec3& gaze() const { return last_gaze_; }
  /// The current sampler; requires a restart before.
  const ViewSampler& sampler() const { return *sampler_; }
  /// All unfiltered gaze samples that arrived for the last frame, after those of the frame before.
  const std::vector<GazeSample>& arrived_gaze() const { return arrived_gaze_; }
  const EquirectFilm& film() const { return render_.film(); }
  const PreviewSettings& settings() const { return settings_; }
  /// Samples dropped since the last restart because they were not finite.
  const std::vector<DroppedSample>& dropped() const { return render_.dropped(); }

 private:
  /// Polls the eye tracker into arrived_gaze and keeps the data that later frames need.
  void poll_gaze(Nanoseconds now);

  PreviewSettings settings_;
  EyeTracker* eye_;
  HeadTracker* head_;
  const Workers* workers_;
  ProgressiveRender render_;
  std::optional<ViewportResampler> resampler_;  ///< resamples the film, from the first present()
  Viewport viewport_;
  std::unique_ptr<ViewSampler> sampler_;
  std::uint64_t next_frame_ = 0;
  std::vector<GazeSample> arrived_gaze_;
  GazeFilter gaze_filter_;
  bool newest_gaze_is_valid_ = false;
  std::optional<GazeSample> last_valid_gaze_;
  Vec3 last_gaze_{0.0F, 0.0F, -1.0F};  ///< world
  std::optional<Vec3> held_gaze_;      ///< world
  std::optional<Vec3> pointer_;        ///< world
};

}  // namespace foveola
