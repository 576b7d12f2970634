// A progressive render: samples drawn, traced and added to a film, for as long as somebody asks.
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
  IVec2 film_size{2048, 1024};  ///< pixels, as EquirectFilm takes them
  /// The angle of the film's pixels; default: those of a 360-degree image.
  std::optional<float> pixel_angle_rad;
  /// Its seed is that of the paths. Its pixel angle is that of the film, whatever stands here.
  TraceSettings trace;
  RandomNumbers numbers = RandomNumbers::low_discrepancy;
  /// Visits all pixels in rounds where the sampler is uniform over the film, so that their counts
  /// differ by one at most. Off in studies, whose sample positions are those of one sequence.
  bool visits_pixels_in_rounds = false;
  /// Sends samples away from pixels whose noise is no longer seen. Off in the published study.
  std::optional<VisibleNoise> adaptive;
  bool keep_variances = false;  ///< in the film, even without adaptive sampling
};

/// What was traced in one go.
struct TracedSamples {
  std::uint64_t samples = 0;
  RayCounts rays;
  double trace_seconds = 0.0;  ///< without drawing directions and without the film
};

/// Samples after which adaptive sampling looks again at what is done, where no frame says when.
constexpr std::uint64_t adaptive_pass = 1 << 16;

/// The film of one viewpoint. Each call draws the next points of one pattern, whose directions an
/// aimed sampler chooses; it may be another sampler in each call. It refers to the tracer and the
/// workers, which must outlive it.
class ProgressiveRender {
 public:
  /// Throws Error for a film size that cannot be.
  ProgressiveRender(const PathTracer& tracer, const ProgressiveSettings& settings,
                    const Workers& workers);

  /// Clears the film and draws paths and directions anew from `seed`.
  void restart(std::uint32_t seed);

  /// Restarts with the same seed at another place, in the scene's coordinates.
  void stand_at(const Vec3& viewpoint);

  /// Cuts each channel of the samples from now on, as TraceSettings::largest_radiance. Those that
  /// are in the film stay.
  void cut_samples(float largest_radiance) { settings_.trace.largest_radiance = largest_radiance; }

  /// Draws directions from the first point of another pattern on, into the same film. Without it,
  /// the pattern's seed is made from the paths' seed.
  void begin_pattern(std::uint32_t seed);

  /// Adaptive sampling judges noise as an eye does that looks along `gaze` (unit length, world).
  /// After each look it draws other random numbers.
  void look_at(const Vec3& gaze);

  /// Takes over what a render with the same settings had come to when it had drawn so many points
  /// of its pattern. Without adaptive sampling it goes on as that would.
  void go_on_from(std::span<const PixelState> pixels, std::uint64_t points_drawn,
                  std::vector<DroppedSample> dropped);

  /// Takes away samples that are not to be traced.
  using Filter = std::function<void(std::vector<ViewSample>& samples)>;
  /// Traces only what `filter` leaves of the samples that were drawn.
  void filter_samples(Filter filter) { filter_ = std::move(filter); }

  /// The radiance of samples that were traced, one element a job.
  using Observe =
      std::function<void(std::span<const SampleJob> jobs, std::span<const Rgb> radiance)>;
  /// Shows `observe` what each call of advance() traces, whatever the film makes of it.
  void observe_samples(Observe observe) { observe_ = std::move(observe); }

  /// Goes on with another tracer, of the same scene or, before a restart, of another.
  void use(const PathTracer& tracer) { tracer_ = &tracer; }

  /// Draws so many points, all in memory at once, by a sampler that was aimed, and traces what
  /// adaptive sampling and the filter leave of them.
  TracedSamples advance(const ViewSampler& sampler, std::uint64_t points);

  /// Draws so many points and returns their jobs. They are only traced where the samples decide
  /// where the next ones go, in adaptive sampling; else the film gets black ones.
  std::vector<SampleJob> pass_over(const ViewSampler& sampler, std::uint64_t points);

  /// As pass_over, but returns the job of one sample of one pixel, if it is among them. pixel: its
  /// row times the film's width, plus its column.
  std::optional<SampleJob> find_job(const ViewSampler& sampler, std::uint64_t points,
                                    std::uint32_t pixel, std::uint32_t sample_number);

  /// Points drawn of the present pattern.
  std::uint64_t points_drawn() const { return next_point_; }
  const EquirectFilm& film() const { return film_; }
  /// Samples dropped since the film was clear because they were not finite.
  const std::vector<DroppedSample>& dropped() const { return dropped_; }
  /// The settings of its paths, the film's pixel angle included.
  const TraceSettings& trace_settings() const { return settings_.trace; }

 private:
  /// The jobs of the next points, without those that adaptive sampling and the filter take away.
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
