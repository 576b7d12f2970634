#include "study/prediction/pilot.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <numbers>
#include <optional>

#include "renderer/base/error.h"
#include "renderer/base/numbers/random.h"
#include "renderer/base/transformed.h"
#include "renderer/film/viewport_resampler.h"
#include "renderer/progressive/progressive_render.h"
#include "renderer/view/view_sampler.h"

namespace foveola::study {
namespace {

constexpr std::uint64_t pass_samples = 1 << 20;

// Keeps the noise of these pictures independent of each other's, and of previews and references.
constexpr std::uint32_t pilot_stream = 0x70696C6FU;
constexpr std::uint32_t converged_stream = 0x636F6E76U;

double pixel_sr(const FilmSettings& film) {
  return 4.0 * std::numbers::pi / (static_cast<double>(film.width) * film.height);
}

/// Returns a render in which only a mask's pixels are traced. The mask must outlive it.
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

/// Renders until this many of the sampler's points were drawn. Throws Error if stopped.
void continue_to(std::uint64_t points, const PilotSetting& setting, const ViewSampler& sampler,
                 ProgressiveRender& render) {
  while (render.points_drawn() < points) {
    if (setting.stop.stop_requested()) {
      throw Error("pilot render", "was stopped before its end");
    }
    render.advance(sampler, std::min(pass_samples, points - render.points_drawn()));
  }
}

/// Shows views; best all those of one size in succession, as they share cached data.
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
    return transformed(view.judged, [&](const JudgedCells& judged) {
      return cell_means(image, judged.pixels, setting_.jnd_lab);
    });
  }

 private:
  const EquirectFilm& film_;
  const PilotSetting& setting_;
  std::optional<ViewportResampler> resampler_;
  int width_ = 0;
  int height_ = 0;
};

ExpectedMeans expected_of(const ConvergedMeans& expected, std::size_t view, std::size_t scale) {
  return {expected.first[view][scale], expected.second[view][scale]};
}

/// Products of differences are negative only by chance, where there is hardly any difference.
ChannelValues not_negative(ChannelValues noise) {
  for (double& value : noise) {
    value = std::max(0.0, value);
  }
  return noise;
}

/// Returns the table without samples: black, with all values that do not depend on samples.
NoiseTable unsampled_table(const JudgedCells& judged, const ExpectedMeans& expected,
                           double jnd_lab) {
  const ChannelValues black = opponent_channels(Rgb(0.0F), jnd_lab);
  const std::vector<ChannelValues> nothing(expected.first.size(), black);
  NoiseTable table;
  for (const PatchEnergies& patch :
       patch_energies(judged.cells, judged.pixels, nothing, expected, judged.with_contrast)) {
    table.push_back({.direction = patch.direction,
                     .cells = patch.cells,
                     .contrast = std::max(0.0, patch.contrast),
                     .unsampled = not_negative(patch.noise),
                     .first_per_sr = 0.0,
                     .noise_times_density = {}});
  }
  return table;
}

ScaleTables unsampled_tables(const JudgedView& view, const ConvergedMeans& expected,
                             std::size_t index, double jnd_lab) {
  ScaleTables tables;
  for (std::size_t scale = 0; scale < view.judged.size(); ++scale) {
    tables.push_back(
        unsampled_table(view.judged[scale], expected_of(expected, index, scale), jnd_lab));
  }
  return tables;
}

double geometric_mean_density(const ViewSampler& sampler, const ScaleTables& tables) {
  double sum = 0.0;
  double count = 0.0;
  for (const NoiseTable& table : tables) {
    for (const PatchNoise& patch : table) {
      if (const double density = density_around(sampler, patch.direction); density > 0.0) {
        sum += std::log(density);
        count += 1.0;
      }
    }
  }
  return count > 0.0 ? std::exp(sum / count) : 0.0;
}

using ScaleEnergies = std::vector<PatchEnergies>;

std::vector<ScaleEnergies> look(Display& display, const JudgedView& view,
                                const ConvergedMeans& expected, std::size_t index) {
  const auto presented = display.means(view);
  std::vector<ScaleEnergies> seen;
  for (std::size_t scale = 0; scale < presented.size(); ++scale) {
    const JudgedCells& judged = view.judged[scale];
    seen.push_back(patch_energies(judged.cells, judged.pixels, presented[scale],
                                  expected_of(expected, index, scale), judged.with_contrast));
  }
  return seen;
}

void set_level(const ViewSampler& sampler, std::uint64_t samples, std::size_t level,
               const ScaleEnergies& seen, NoiseTable& table) {
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (table[i].noise_times_density.empty()) {
      continue;  // the method does not sample there
    }
    const double per_sr =
        static_cast<double>(samples) * density_around(sampler, table[i].direction);
    const ChannelValues noise = not_negative(seen[i].noise);
    for (std::size_t c = 0; c < channel_count; ++c) {
      table[i].noise_times_density[level][c] = noise[c] * per_sr;
    }
  }
}

/// Returns the sample counts at which each level is judged. The density is rounded to quarter
/// octaves, so that views of about the same density share pictures.
std::vector<std::uint64_t> sample_counts_of(const FilmSettings& film,
                                            const SampleCountLevels& levels,
                                            double density_per_sr) {
  std::vector<std::uint64_t> sample_counts;
  const double rounded_per_sr = std::exp2(0.25 * std::round(4.0 * std::log2(density_per_sr)));
  const double first = levels.first_per_pixel / (pixel_sr(film) * rounded_per_sr);
  for (int level = 0; level < levels.count; ++level) {
    sample_counts.push_back(static_cast<std::uint64_t>(
        std::max(1.0, std::round(first * std::exp2(0.5 * static_cast<double>(level))))));
  }
  return sample_counts;
}

void begin_levels(const ViewSampler& sampler, const std::vector<std::uint64_t>& sample_counts,
                  ScaleTables& tables) {
  for (NoiseTable& table : tables) {
    for (PatchNoise& patch : table) {
      const double per_sr = density_around(sampler, patch.direction);
      patch.first_per_sr = static_cast<double>(sample_counts.front()) * per_sr;
      patch.noise_times_density.resize(per_sr > 0.0 ? sample_counts.size() : 0);
    }
  }
}

/// A level of a view, and its sample count.
struct DueLook {
  std::uint64_t samples = 0;
  std::size_t view = 0;
  std::size_t level = 0;

  auto operator<=>(const DueLook&) const = default;
};

CellMeans means_of(Display& display, std::span<const JudgedView> views) {
  CellMeans means;
  for (const JudgedView& view : views) {
    means.push_back(display.means(view));
  }
  return means;
}

/// Returns twice the means after all samples less those after half of them.
CellMeans extrapolated(const CellMeans& half, CellMeans all) {
  for (std::size_t view = 0; view < all.size(); ++view) {
    for (std::size_t scale = 0; scale < all[view].size(); ++scale) {
      for (std::size_t cell = 0; cell < all[view][scale].size(); ++cell) {
        for (std::size_t c = 0; c < channel_count; ++c) {
          double& mean = all[view][scale][cell][c];
          mean = 2.0 * mean - half[view][scale][cell][c];
        }
      }
    }
  }
  return all;
}

CellMeans converged_once(const PilotSetting& setting, const ViewSampler& sampler,
                         std::uint64_t points, std::uint32_t seed, const SampleMask& mask,
                         std::span<const JudgedView> views) {
  ProgressiveRender render = masked_render(setting, mask, seed);
  Display display(render.film(), setting);
  continue_to((points + 1) / 2, setting, sampler, render);
  const CellMeans half = means_of(display, views);
  continue_to(points, setting, sampler, render);
  return extrapolated(half, means_of(display, views));
}

}  // namespace

ConvergedMeans converged_means(const PilotSetting& setting, const ViewSampler& sampler,
                               const Vec3& middle, double per_pixel, const SampleMask& mask,
                               std::span<const JudgedView> views) {
  const auto points = static_cast<std::uint64_t>(
      std::ceil(per_pixel / (pixel_sr(setting.film) * sampler.density_per_sr(middle))));
  const auto converged = [&](std::uint32_t number) {
    return converged_once(setting, sampler, points, mix(number, converged_stream), mask, views);
  };
  return {.first = converged(0), .second = converged(1)};
}

std::vector<ScaleTables> measure_noise(const PilotSetting& setting, const ViewSampler& sampler,
                                       const SampleCountLevels& levels, std::uint32_t picture,
                                       const SampleMask& mask, std::span<const JudgedView> views,
                                       const ConvergedMeans& expected) {
  std::vector<ScaleTables> tables;
  std::vector<DueLook> due;
  for (std::size_t view = 0; view < views.size(); ++view) {
    tables.push_back(unsampled_tables(views[view], expected, view, setting.jnd_lab));
    const double density = geometric_mean_density(sampler, tables.back());
    if (density == 0.0) {
      continue;  // the method never samples there
    }
    const std::vector<std::uint64_t> sample_counts =
        sample_counts_of(setting.film, levels, density);
    begin_levels(sampler, sample_counts, tables.back());
    for (std::size_t level = 0; level < sample_counts.size(); ++level) {
      due.push_back({sample_counts[level], view, level});
    }
  }
  std::ranges::sort(due);
  ProgressiveRender render = masked_render(setting, mask, mix(picture, pilot_stream));
  Display display(render.film(), setting);
  for (const auto& [samples, view, level] : due) {
    continue_to(samples, setting, sampler, render);
    const std::vector<ScaleEnergies> seen = look(display, views[view], expected, view);
    for (std::size_t scale = 0; scale < seen.size(); ++scale) {
      set_level(sampler, samples, level, seen[scale], tables[view][scale]);
    }
  }
  return tables;
}

}  // namespace foveola::study
