// A progressive render: draws and traces samples and adds them to a film, call by call.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "renderer/film/adaptive_sampling.h"
#include "renderer/film/equirect_film.h"
#include "renderer/film/sample_pass.h"
#include "renderer/trace/paths/path_tracer.h"
#include "renderer/view/view_sampler.h"

namespace foveola {

struct ProgressiveSettings {
  Vec3 viewpoint{0.0F};         ///< in the scene's coordinates (see Scene::origin), metres
  IVec2 film_size{2048, 1024};  ///< pixels, as for EquirectFilm
  /// Angle of the film's pixels; default: of a 360-degree image.
  std::optional<float> pixel_angle_rad;
  /// Its seed is that of the paths; its pixel angle is replaced by the film's.
  TraceSettings trace;
  RandomNumbers numbers = RandomNumbers::low_discrepancy;
  /// Visits all pixels in rounds if the sampler is uniform over the film, so that their counts
  /// differ by at most one. Off in studies, whose sample positions come from one sequence.
  bool visits_pixels_in_rounds = false;
  /// Redirects samples from pixels whose noise is invisible. Off in the published study.
  std::optional<VisibleNoise> adaptive;
  bool keep_variances = false;  ///< in the film, without adaptive sampling too
};

/// The samples traced in one call.
struct TracedSamples {
  std::uint64_t samples = 0;
  RayCounts rays;
  double trace_seconds = 0.0;  ///< without drawing directions and without the film
};

/// Default number of samples between updates of adaptive sampling.
constexpr std::uint64_t adaptive_pass = 1 << 16;

/// The film of one viewpoint. Each call draws the next points of one pattern, mapped to directions
/// by an aimed sampler, which may differ between calls. The tracer and the workers must outlive it.
class ProgressiveRender {
 public:
  /// Throws Error for an impossible film size.
  ProgressiveRender(const PathTracer& tracer, const ProgressiveSettings& settings,
                    const Workers& workers);

  /// Clears the film and restarts paths and directions with `seed`.
  void restart(std::uint32_t seed);

  /// Restarts with the same seed at another viewpoint, in the scene's coordinates.
  void stand_at(const Vec3& viewpoint);

  /// Clamps each channel of later samples, as TraceSettings::largest_radiance. Samples in the film
  /// stay.
  void cut_samples(float largest_radiance) { settings_.trace.largest_radiance = largest_radiance; }

  /// Draws directions from the beginning of another pattern, into the same film. By default the
  /// pattern's seed is derived from the paths' seed.
  void begin_pattern(std::uint32_t seed);

  /// Sets the gaze (unit length, world) of adaptive sampling's visibility threshold. Also begins
  /// new random numbers.
  void look_at(const Vec3& gaze);

  /// Restores the state of a render with the same settings after `points_drawn` points of its
  /// pattern. Without adaptive sampling it continues as that render would.
  void go_on_from(std::span<const PixelState> pixels, std::uint64_t points_drawn,
                  std::vector<DroppedSample> dropped);

  /// Removes samples that are not to be traced.
  using Filter = std::function<void(std::vector<ViewSample>& samples)>;
  /// Traces only the drawn samples that `filter` leaves.
  void filter_samples(Filter filter) { filter_ = std::move(filter); }

  /// Receives the radiance of traced samples, one element per job.
  using Observe =
      std::function<void(std::span<const SampleJob> jobs, std::span<const Rgb> radiance)>;
  /// Passes the samples traced by each advance() to `observe`, before the film.
  void observe_samples(Observe observe) { observe_ = std::move(observe); }

  /// Continues with another tracer, of the same scene or, before a restart, of another.
  void use(const PathTracer& tracer) { tracer_ = &tracer; }

  /// Draws `points` points, all in memory at once, by an aimed sampler. Traces those that adaptive
  /// sampling and the filter leave.
  TracedSamples advance(const ViewSampler& sampler, std::uint64_t points);

  /// Draws `points` points and returns their jobs. Traces them only for adaptive sampling, where
  /// they decide about the next samples; otherwise the film gets black samples.
  std::vector<SampleJob> pass_over(const ViewSampler& sampler, std::uint64_t points);

  /// As pass_over, but returns the job of one sample of one pixel; nullopt if it is not among them.
  /// pixel: its row times the film's width, plus its column.
  std::optional<SampleJob> find_job(const ViewSampler& sampler, std::uint64_t points,
                                    std::uint32_t pixel, std::uint32_t sample_number);

  /// Number of points drawn from the current pattern.
  std::uint64_t points_drawn() const { return next_point_; }
  const EquirectFilm& film() const { return film_; }
  /// Samples dropped since the last clear because they were not finite.
  const std::vector<DroppedSample>& dropped() const { return dropped_; }
  /// The settings of its paths, the film's pixel angle included.
  const TraceSettings& trace_settings() const { return settings_.trace; }

 private:
  /// The jobs of the next points, without those that adaptive sampling and the filter remove.
  std::span<const SampleJob> draw(const ViewSampler& sampler, std::uint64_t points);
  /// Fills radiance_.
  RayCounts trace(std::span<const SampleJob> jobs);
  /// Adds radiance_ to the film.
  void add(const ViewSampler& sampler);

  const PathTracer* tracer_;
  const Workers* workers_;
  ProgressiveSettings settings_;
  Filter filter_;
  Observe observe_;
  EquirectFilm film_;
  SamplePass pass_;
  std::vector<Rgb> radiance_;  ///< of the last pass's jobs
  std::uint32_t pattern_seed_ = 0;
  std::uint64_t next_point_ = 0;
  Vec3 gaze_{0.0F, 0.0F, -1.0F};
  std::uint32_t looks_ = 0;
  std::vector<DroppedSample> dropped_;
};

}  // namespace foveola
