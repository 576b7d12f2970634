// Samples for films in tests.
#pragma once

#include <vector>

#include "renderer/base/numbers/random.h"
#include "renderer/film/equirect_film.h"
#include "renderer/view/equirect.h"

namespace foveola {

/// Spread over the whole image.
inline std::vector<ViewSample> sobol_samples(std::uint64_t begin, std::uint64_t count) {
  std::vector<ViewSample> samples;
  for (std::uint64_t i = begin; i < begin + count; ++i) {
    const Vec2 image = sobol_2d(i, 3);
    samples.push_back({.direction = direction_from_equirect(image), .image = image});
  }
  return samples;
}

/// `count` in the middle of one pixel.
inline std::vector<ViewSample> in_pixel(int x, int y, const EquirectFilm& film, std::size_t count) {
  const Vec2 image((static_cast<float>(x) + 0.5F) / static_cast<float>(film.width()),
                   (static_cast<float>(y) + 0.5F) / static_cast<float>(film.height()));
  return {count, {.direction = direction_from_equirect(image), .image = image}};
}

/// A colour that depends on the job alone, as the tracer's does.
inline Rgb color_of(const SampleJob& job) {
  const float value = unit_float(mix(mix(job.pixel), job.sample_number));
  return {value, value * value, 1.0F - value};
}

inline std::vector<Rgb> colors_of(const NumberedBatch& batch) {
  std::vector<Rgb> colors;
  for (const SampleJob& job : batch.jobs) {
    colors.push_back(color_of(job));
  }
  return colors;
}

/// The film of a colour for each sample, which depends on its job alone.
inline void add_samples(const std::vector<ViewSample>& samples, EquirectFilm& film,
                        const Workers& workers) {
  NumberedBatch batch;
  film.number(samples, batch, workers);
  film.add(batch, colors_of(batch), workers);
}

}  // namespace foveola
