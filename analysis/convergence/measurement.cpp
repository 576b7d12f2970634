#include "analysis/convergence/measurement.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/clock.h"
#include "renderer/base/files/digest.h"
#include "renderer/base/transformed.h"
#include "renderer/film/viewport_resampler.h"
#include "renderer/view/equirect.h"

namespace foveola::analysis {
namespace {

const PathTracer& tracer_for(const Configuration& configuration, const Subject& subject) {
  const PathTracer* tracer = subject.tracer_for(configuration.light_sampling);
  assert(tracer != nullptr);
  return *tracer;
}

ProgressiveSettings settings_for(const Configuration& configuration, const ConvergencePlan& plan,
                                 const SceneSource& source, std::uint32_t seed) {
  const auto white = static_cast<float>(std::exp2(-source.exposure_stops.value_or(0.0)));
  ProgressiveSettings settings = configuration.render;
  settings.film_size = plan.size;
  settings.trace.max_depth = plan.max_depth;
  settings.trace.seed = seed;
  settings.trace.largest_light_sample *= white;
  return settings;
}

/// Returns the weighted mean of a pixel's variance after one sample on the film, relative to that
/// of a sample; infinite if a pixel is never reached.
double mean_inverse_probability(const ViewSampler& sampler, const PixelRegion& region,
                                const IVec2& size) {
  const double pixel_area = 2.0 * std::numbers::pi * std::numbers::pi / size.x / size.y;
  double sum = 0.0;
  double total_weight = 0.0;
  for (const auto& [index, weight] : region.pixels) {
    const int y = static_cast<int>(index) / size.x;
    const int x = static_cast<int>(index) % size.x;
    const double v = (y + 0.5) / size.y;
    const double sr = pixel_area * std::sin(std::numbers::pi * v);
    const Vec3 middle = direction_from_equirect(Vec2((x + 0.5) / size.x, v));
    sum += weight / (density_around(sampler, middle) * sr);
    total_weight += weight;
  }
  return sum / total_weight;
}

/// Samples per turn of a configuration: a batch of a progressive render.
constexpr std::uint64_t turn_samples = 1 << 17;
/// Samples per turn if renders end after a time.
constexpr std::uint64_t short_turn_samples = 1 << 14;

Aim aim_at(const ConvergencePlan& plan, const AzimuthElevation& gaze) {
  return {
      .viewport = Viewport(gaze, {.horizontal_deg = plan.fov_deg, .vertical_deg = plan.fov_deg}),
      .gaze = direction_from(gaze)};
}

/// Returns whether another repetition as long as the previous ones would end within the limit.
bool has_time_for_another(double limit_s, std::size_t repetitions, double elapsed_s) {
  return limit_s <= 0.0 || elapsed_s * static_cast<double>(repetitions + 1) <=
                               limit_s * static_cast<double>(repetitions);
}

/// Returns the fraction done of a measurement that ends at its maximum number of repetitions, or at
/// the time limit once it has its minimum.
double fraction_done(const ConvergencePlan& plan, double repetitions, double limit_s,
                     double elapsed_s) {
  const double of_most = repetitions / plan.most_repetitions;
  return limit_s <= 0.0 ? of_most
                        : std::min(std::max(of_most, elapsed_s / limit_s),
                                   repetitions / plan.least_repetitions);
}

/// Joins images from left to right, with gaps. There is at least one image, and all are of one
/// size.
RgbImage side_by_side(const std::vector<RgbImage>& images) {
  constexpr int gap = 8;
  const int pitch = images.front().width + gap;
  RgbImage strip(static_cast<int>(images.size()) * pitch - gap, images.front().height);
  std::ranges::fill(strip.pixels, Rgb(1.0F));
  for (std::size_t i = 0; i < images.size(); ++i) {
    for (int y = 0; y < images[i].height; ++y) {
      for (int x = 0; x < images[i].width; ++x) {
        strip.at(static_cast<int>(i) * pitch + x, y) = images[i].at(x, y);
      }
    }
  }
  return strip;
}

}  // namespace

GazeBench::GazeBench(const Subject& subject, const ConvergencePlan& plan,
                     const AzimuthElevation& gaze, const Workers& workers,
                     const std::filesystem::path& cache, const ReportProgress& progress,
                     std::stop_token stop)
    : subject_(&subject),
      plan_(&plan),
      workers_(&workers),
      stop_(std::move(stop)),
      gaze_(gaze_name(gaze)),
      aim_(aim_at(plan, gaze)),
      regions_(regions_around(aim_.gaze, aim_.viewport)),
      scorer_(plan, aim_.viewport, subject.loaded.source.exposure_stops.value_or(0.0), regions_,
              reference_halves(
                  subject, plan, aim_.gaze, workers, cache,
                  [&](double fraction) {
                    progress("reference of " + subject.loaded.source.name, fraction);
                  },
                  stop_),
              workers) {}

GazeMeasurement GazeBench::without_repetitions() const {
  GazeMeasurement measurement{.scene = subject_->loaded.source.name,
                              .scene_sha256 = sha256(std::string_view(subject_->key)),
                              .gaze = gaze_,
                              .predicted = predictions()};
  for (const Configuration& configuration : plan_->configurations) {
    measurement.configurations.push_back(configuration.name);
  }
  for (const Region& region : regions_) {
    measurement.regions.push_back(region.name);
  }
  return measurement;
}

GazeMeasurement GazeBench::measure(double limit_s, const ReportProgress& progress) const {
  GazeMeasurement measurement = without_repetitions();
  const SteadyClock clock;
  const Nanoseconds start = clock.now();
  for (int repetition = 0; repetition < plan_->most_repetitions; ++repetition) {
    if (repetition >= plan_->least_repetitions &&
        !has_time_for_another(limit_s, measurement.repetitions.size(),
                              seconds(clock.now() - start))) {
      break;
    }
    const auto in_repetition = [&](double fraction) {
      progress("repetitions in " + subject_->loaded.source.name,
               fraction_done(*plan_, repetition + fraction, limit_s, seconds(clock.now() - start)));
    };
    std::optional<Repetition> logs = run_repetition(
        plan_->seed * max_repetitions + static_cast<std::uint32_t>(repetition), in_repetition);
    if (!logs) {
      break;
    }
    measurement.repetitions.push_back(std::move(*logs));
  }
  return measurement;
}

std::optional<Repetition> GazeBench::run_repetition(
    std::uint32_t seed, const std::function<void(double)>& progress) const {
  std::vector<ProgressiveRun> runs =
      transformed(plan_->configurations, [&](const Configuration& configuration) {
        return ProgressiveRun(*subject_, *plan_, configuration, aim_, seed, *workers_);
      });
  Repetition logs(runs.size());
  const std::vector<std::uint64_t> counts = checkpoints(*plan_);
  for (const std::uint64_t count : counts) {
    while (runs.back().samples() < count) {
      for (ProgressiveRun& run : runs) {
        if (stop_.stop_requested()) {
          return std::nullopt;
        }
        run.advance(std::min(turn_samples, count - run.samples()));
      }
      progress(static_cast<double>(runs.back().samples()) / static_cast<double>(counts.back()));
    }
    for (std::size_t i = 0; i < runs.size(); ++i) {
      logs[i].checkpoints.push_back({.samples = runs[i].samples(),
                                     .seconds = runs[i].seconds(),
                                     .scores = scorer_.score(runs[i].film())});
    }
  }
  for (std::size_t i = 0; i < runs.size(); ++i) {
    logs[i].seed = seed;
    logs[i].dropped = runs[i].dropped();
  }
  return logs;
}

std::vector<std::vector<std::optional<double>>> GazeBench::predictions() const {
  const auto aimed = [this](const Configuration& configuration) {
    std::unique_ptr<ViewSampler> sampler = make_view_sampler(configuration.method);
    sampler->aim(aim_);
    return sampler;
  };
  const std::unique_ptr<ViewSampler> baseline = aimed(plan_->configurations.front());
  std::vector<std::vector<std::optional<double>>> predicted;
  for (const Configuration& configuration : plan_->configurations) {
    const std::unique_ptr<ViewSampler> method = aimed(configuration);
    predicted.emplace_back();
    for (const PixelRegion& region : scorer_.film_regions()) {
      predicted.back().push_back(predicted_speed_up(*method, *baseline, region, plan_->size));
    }
  }
  return predicted;
}

RgbImage GazeBench::crops() const {
  constexpr std::uint32_t seed = 0;
  const double fov_rad = radians(plan_->crop_fov_deg);
  const Viewport view(aim_.viewport.head(), fov_rad, fov_rad);
  const int size = plan_->crop_size;
  std::vector<RgbImage> images;
  for (const Configuration& configuration : plan_->configurations) {
    ProgressiveRun run(*subject_, *plan_, configuration, aim_, seed, *workers_);
    while (run.seconds() < plan_->crop_seconds && !stop_.stop_requested()) {
      run.advance(short_turn_samples);
    }
    images.push_back(
        viewport_image(run.film(), view, size, size, UnsampledPixels::black, *workers_));
  }
  images.push_back(viewport_image(scorer_.reference(), view, size, size));
  return side_by_side(images);
}

std::optional<double> predicted_speed_up(const ViewSampler& method, const ViewSampler& baseline,
                                         const PixelRegion& region, const IVec2& size) {
  const double speed_up = mean_inverse_probability(baseline, region, size) /
                          mean_inverse_probability(method, region, size);
  return speed_up > 0.0 && std::isfinite(speed_up) ? std::optional(speed_up) : std::nullopt;
}

ProgressiveRun::ProgressiveRun(const Subject& subject, const ConvergencePlan& plan,
                               const Configuration& configuration, const Aim& aim,
                               std::uint32_t seed, const Workers& workers)
    : gaze_(aim.gaze),
      is_adaptive_(configuration.render.adaptive.has_value()),
      sampler_(make_view_sampler(configuration.method)),
      render_(tracer_for(configuration, subject),
              subject.loaded.rendered_with(
                  settings_for(configuration, plan, subject.loaded.source, seed)),
              workers) {
  sampler_->aim(aim);
}

void ProgressiveRun::advance(std::uint64_t samples) {
  const SteadyClock clock;
  const Nanoseconds start = clock.now();
  const std::uint64_t end = render_.points_drawn() + samples;
  while (render_.points_drawn() < end) {
    const std::uint64_t left = end - render_.points_drawn();
    render_.look_at(gaze_);
    render_.advance(*sampler_, is_adaptive_ ? std::min(left, adaptive_pass) : left);
  }
  seconds_ += foveola::seconds(clock.now() - start);
}

}  // namespace foveola::analysis
