#include "study/prediction/pilot.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "renderer/base/error.h"
#include "renderer/base/random.h"
#include "renderer/film/viewport_resampler.h"
#include "renderer/progressive/progressive_render.h"

namespace foveola::study {
namespace {

constexpr std::uint64_t pass_samples = 1 << 20;

// Keep these pictures' noise apart, and from that of previews and references.
constexpr std::uint32_t pilot_stream = 0x70696C6FU;
constexpr std::uint32_t converged_stream = 0x636F6E76U;

double pixel_sr(const FilmSettings& film) {
  return 4.0 * std::numbers::pi / (static_cast<double>(film.width) * film.height);
}

/// A render in which only a mask's pixels are traced. The mask must outlive it.
ProgressiveRender masked_render(const PilotSetting& setting, const SampleMask& mask,
                                std::uint32_t seed) {
  ProgressiveRender render(setting.tracer,
                           {.viewpoint = setting.viewpoint,
                            .film_size = {setting.film.width, setting.film.height},
                            .trace = {.max_depth = setting.film.max_depth, .seed = seed}},
                           setting.workers);
  render.filter_samples([&mask](std::vector<ViewSample>& samples) { mask.keep(samples); });
  return render;
}

/// Goes on until so many of the sampler's points were drawn. Throws Error if stopped.
void continue_to(std::uint64_t points, const PilotSetting& setting, const ViewSampler& sampler,
                 ProgressiveRender& render) {
  while (render.points_drawn() < points) {
    if (setting.stop.stop_requested()) {
      throw Error("pilot render", "stopped before it was finished");
    }
    render.advance(sampler, std::min(pass_samples, points - render.points_drawn()));
  }
}

/// Views of one size share what is kept between pictures, so they are best shown one after another.
class Display {
 public:
  Display(const EquirectFilm& film, const PilotSetting& setting) : film_(film), setting_(setting) {}

  std::vector<std::vector<ChannelValues>> means(const JudgedView& view) {
    if (view.width != width_ || view.height != height_) {
      width_ = view.width;
      height_ = view.height;
      resampler_.emplace(film_, ViewImage{.width = width_,
                                          .height = height_,
                                          .unsampled = setting_.unsampled,
                                          .exposure_stops = setting_.exposure_stops});
    }
    const RgbImage& image = resampler_->show(view.viewport, setting_.workers);
    std::vector<std::vector<ChannelValues>> of_scales;
    for (const JudgedCells& judged : view.judged) {
      of_scales.push_back(cell_means(image, judged.pixels, setting_.jnd_lab));
    }
    return of_scales;
  }

 private:
  const EquirectFilm& film_;
  const PilotSetting& setting_;
  std::optional<ViewportResampler> resampler_;
  int width_ = 0;
  int height_ = 0;
};

/// Before anything was sampled: black, with all that does not depend on samples.
NoiseTable unsampled_table(const JudgedCells& judged, const std::vector<ChannelValues>& expected,
                           double jnd_lab) {
  const ChannelValues black = opponent_channels(Rgb(0.0F), jnd_lab);
  const std::vector<ChannelValues> nothing(expected.size(), black);
  NoiseTable table;
  for (const PatchEnergies& patch :
       patch_energies(judged.cells, judged.pixels, nothing, expected, judged.with_contrast)) {
    table.push_back({.direction = patch.direction,
                     .cells = patch.cells,
                     .contrast = patch.contrast,
                     .unsampled = patch.noise,
                     .first_per_sr = 0.0,
                     .noise_times_density = {}});
  }
  return table;
}

std::vector<ScaleTables> unsampled_tables(std::span<const JudgedView> views,
                                          const CellMeans& expected, double jnd_lab) {
  std::vector<ScaleTables> tables(views.size());
  for (std::size_t view = 0; view < views.size(); ++view) {
    for (std::size_t scale = 0; scale < views[view].judged.size(); ++scale) {
      tables[view].push_back(
          unsampled_table(views[view].judged[scale], expected[view][scale], jnd_lab));
    }
  }
  return tables;
}

/// Calls visit(patch) with every patch of the tables.
template <typename Tables, typename Visit>
void for_each_patch(Tables& tables, const Visit& visit) {
  for (auto& of_view : tables) {
    for (auto& table : of_view) {
      for (auto& patch : table) {
        visit(patch);
      }
    }
  }
}

double geometric_mean_density(const ViewSampler& sampler, const std::vector<ScaleTables>& tables) {
  double sum = 0.0;
  double count = 0.0;
  for_each_patch(tables, [&](const PatchNoise& patch) {
    if (const double density = sampler.density_per_sr(patch.direction); density > 0.0) {
      sum += std::log(density);
      count += 1.0;
    }
  });
  return count > 0.0 ? std::exp(sum / count) : 0.0;
}

using ScaleEnergies = std::vector<PatchEnergies>;

/// What is to be seen in a view on each scale.
std::vector<ScaleEnergies> look(Display& display, const JudgedView& view,
                                const std::vector<std::vector<ChannelValues>>& expected) {
  const auto presented = display.means(view);
  std::vector<ScaleEnergies> seen;
  for (std::size_t scale = 0; scale < presented.size(); ++scale) {
    const JudgedCells& judged = view.judged[scale];
    seen.push_back(patch_energies(judged.cells, judged.pixels, presented[scale], expected[scale],
                                  judged.with_contrast));
  }
  return seen;
}

/// Notes what a picture after `samples` says about a level.
void set_level(const ViewSampler& sampler, std::uint64_t samples, std::size_t level,
               const ScaleEnergies& seen, NoiseTable& table) {
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (table[i].noise_times_density.empty()) {
      continue;  // the method does not go there
    }
    const double per_sr = static_cast<double>(samples) * sampler.density_per_sr(table[i].direction);
    for (std::size_t c = 0; c < channel_count; ++c) {
      table[i].noise_times_density[level][c] = seen[i].noise[c] * per_sr;
    }
  }
}

/// The samples after which each level is looked at.
std::vector<std::uint64_t> sample_counts_of(const FilmSettings& film,
                                            const SampleCountLevels& levels,
                                            double density_per_sr) {
  std::vector<std::uint64_t> sample_counts;
  const double first = levels.first_per_pixel / (pixel_sr(film) * density_per_sr);
  for (int level = 0; level < levels.count; ++level) {
    sample_counts.push_back(static_cast<std::uint64_t>(
        std::max(1.0, std::round(first * std::exp2(0.5 * static_cast<double>(level))))));
  }
  return sample_counts;
}

}  // namespace

CellMeans converged_means(const PilotSetting& setting, const ViewSampler& sampler,
                          const Vec3& middle, double per_pixel, const SampleMask& mask,
                          std::span<const JudgedView> views) {
  ProgressiveRender render = masked_render(setting, mask, mix(0U, converged_stream));
  const double points =
      std::ceil(per_pixel / (pixel_sr(setting.film) * sampler.density_per_sr(middle)));
  continue_to(static_cast<std::uint64_t>(points), setting, sampler, render);
  Display display(render.film(), setting);
  CellMeans means;
  for (const JudgedView& view : views) {
    means.push_back(display.means(view));
  }
  return means;
}

std::vector<ScaleTables> measure_noise(const PilotSetting& setting, const ViewSampler& sampler,
                                       const SampleCountLevels& levels, std::uint32_t picture,
                                       const SampleMask& mask, std::span<const JudgedView> views,
                                       const CellMeans& expected) {
  std::vector<ScaleTables> tables = unsampled_tables(views, expected, setting.jnd_lab);
  const double density = geometric_mean_density(sampler, tables);
  if (density == 0.0) {
    return tables;  // a method that never goes there
  }
  const std::vector<std::uint64_t> sample_counts = sample_counts_of(setting.film, levels, density);
  for_each_patch(tables, [&](PatchNoise& patch) {
    const double per_sr = sampler.density_per_sr(patch.direction);
    patch.first_per_sr = static_cast<double>(sample_counts.front()) * per_sr;
    patch.noise_times_density.resize(per_sr > 0.0 ? sample_counts.size() : 0);
  });
  ProgressiveRender render = masked_render(setting, mask, mix(picture, pilot_stream));
  Display display(render.film(), setting);
  for (std::size_t level = 0; level < sample_counts.size(); ++level) {
    continue_to(sample_counts[level], setting, sampler, render);
    for (std::size_t view = 0; view < views.size(); ++view) {
      const std::vector<ScaleEnergies> seen = look(display, views[view], expected[view]);
      for (std::size_t scale = 0; scale < seen.size(); ++scale) {
        set_level(sampler, sample_counts[level], level, seen[scale], tables[view][scale]);
      }
    }
  }
  return tables;
}

}  // namespace foveola::study
