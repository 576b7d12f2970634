#include "analysis/convergence/scorer.h"

#include <utility>

#include "renderer/film/viewport_image.h"
#include "renderer/image/tone_mapping.h"
#include "renderer/measure/flip.h"
#include "renderer/measure/reference.h"

namespace foveola::analysis {

Scorer::Scorer(const ConvergencePlan& plan, const Viewport& viewport, double exposure_stops,
               const std::vector<Region>& regions, ReferenceHalves reference,
               const Workers& workers)
    : viewport_(viewport),
      exposure_stops_(exposure_stops),
      view_size_(plan.view_size),
      regions_(&regions),
      reference_(std::move(reference)),
      workers_(&workers) {
  for (const Region& region : regions) {
    film_regions_.push_back(region_on_film(region, plan.size));
    view_regions_.push_back(region_on_view(region, viewport, view_size_));
  }
  reference_view_ = shown(viewport_image(this->reference(), viewport_, view_size_, view_size_));
}

std::vector<Score> Scorer::score(const EquirectFilm& film) const {
  const FilmImage image = film.resolve();
  const RgbImage view = shown(
      viewport_image(film, viewport_, view_size_, view_size_, UnsampledPixels::black, *workers_));
  const double fov_rad = 2.0 * std::atan(static_cast<double>(viewport_.half_size().x));
  const std::vector<float> flip =
      flip_errors(view, reference_view_, pixels_per_degree(fov_rad, view_size_));
  std::vector<Score> scores;
  for (std::size_t i = 0; i < regions_->size(); ++i) {
    Score score{.error = region_error(image, reference_, film_regions_[i]), .flip = {}};
    if ((*regions_)[i].is_in_view) {
      score.flip = region_mean(flip, view_regions_[i]);
    }
    scores.push_back(score);
  }
  return scores;
}

RgbImage Scorer::reference() const {
  RgbImage mean = reference_.first;
  for (std::size_t i = 0; i < mean.pixels.size(); ++i) {
    mean.pixels[i] = 0.5F * (mean.pixels[i] + reference_.second.pixels[i]);
  }
  return mean;
}

RgbImage Scorer::shown(const RgbImage& view) const { return display_image(view, exposure_stops_); }

RgbImage reference_half(const Subject& subject, const ConvergencePlan& plan, const Vec3& gaze,
                        std::uint32_t half, const Workers& workers,
                        const std::filesystem::path& cache,
                        const std::function<void(double)>& progress, const std::stop_token& stop) {
  ReferenceSettings settings;
  settings.viewpoint = subject.loaded.camera.position;
  settings.width = plan.size.x;
  settings.height = plan.size.y;
  settings.max_depth = plan.max_depth;
  settings.seed = half;
  settings.samples_per_pixel = plan.reference_samples_per_pixel;
  settings.interests = {gaze};
  settings.samples_per_interest = static_cast<std::uint64_t>(plan.reference_foveated_per_pixel) *
                                  static_cast<std::uint64_t>(plan.size.x) *
                                  static_cast<std::uint64_t>(plan.size.y);
  return reference_image(subject.loaded.tracer, subject.key, settings, workers, cache, progress,
                         stop)
      .color;
}

ReferenceHalves reference_halves(const Subject& subject, const ConvergencePlan& plan,
                                 const Vec3& gaze, const Workers& workers,
                                 const std::filesystem::path& cache,
                                 const std::function<void(double)>& progress,
                                 const std::stop_token& stop) {
  const auto half = [&](std::uint32_t number) {
    const auto so_far = [&](double fraction) { progress(0.5 * (number + fraction)); };
    return reference_half(subject, plan, gaze, number, workers, cache, so_far, stop);
  };
  RgbImage first = half(0);
  return {.first = std::move(first), .second = half(1)};
}

}  // namespace foveola::analysis
