#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "renderer/base/numbers/random.h"
#include "renderer/film/equirect_film.h"
#include "renderer/stability/checks.h"

namespace foveola {
namespace {

/// Samples per batch.
constexpr std::uint64_t batch_samples = 1 << 20;

/// A batch of radiance with an exact mean: each channel in units of 2^-24.
struct KnownBatch {
  std::vector<Rgb> radiance;
  DVec3 mean{0.0};
};

/// Red: a constant tenth, which is not a float. Green: anything in [0, 1). Blue: a spark of 10000
/// in every 65536 samples of 2^-20, the kind of sum that loses small terms.
KnownBatch known_batch() {
  constexpr std::uint32_t tenth = 1677722;
  constexpr std::uint32_t small = 1 << 4;
  constexpr std::uint64_t spark = std::uint64_t{10000} << 24;
  KnownBatch batch;
  batch.radiance.reserve(batch_samples);
  Pcg32 random(5);
  std::array<std::uint64_t, 3> sums{};
  for (std::uint64_t i = 0; i < batch_samples; ++i) {
    const std::array<std::uint64_t, 3> units{tenth, random.next() >> 8,
                                             i % 65536 == 4711 ? spark : small};
    Rgb value;
    for (int channel = 0; channel < 3; ++channel) {
      const std::uint64_t unit = units[static_cast<std::size_t>(channel)];
      sums[static_cast<std::size_t>(channel)] += unit;
      value[channel] = static_cast<float>(unit) * 0x1p-24F;  // exact: at most 24 bits are set
    }
    batch.radiance.push_back(value);
  }
  for (int channel = 0; channel < 3; ++channel) {
    batch.mean[channel] = static_cast<double>(sums[static_cast<std::size_t>(channel)]) * 0x1p-24 /
                          static_cast<double>(batch_samples);
  }
  return batch;
}

}  // namespace

std::vector<StabilityFigure> check_accumulation(const StabilityRun& run) {
  const KnownBatch known = known_batch();
  EquirectFilm film(1, 1);
  NumberedBatch batch;
  film.number(std::vector<ViewSample>(batch_samples), batch, run.workers);
  const std::uint64_t batches = std::max<std::uint64_t>(1, run.effort.film_samples / batch_samples);
  for (std::uint64_t i = 0; i < batches && !run.stop.stop_requested(); ++i) {
    film.add(batch, known.radiance, run.workers);
    run.progress(static_cast<double>(i + 1) / static_cast<double>(batches));
  }
  const FilmPixel pixel = film.pixel(0, 0);
  double worst = 0.0;
  std::string details;
  for (int channel = 0; channel < 3; ++channel) {
    const double off = std::abs(pixel.mean[channel] - known.mean[channel]) / known.mean[channel];
    worst = std::max(worst, off);
    details += fmt::format("{}{:.9g} against {:.9g}", channel == 0 ? "" : ", ", pixel.mean[channel],
                           known.mean[channel]);
  }
  return {{.name = fmt::format("{:.1e} samples in one pixel: off their mean",
                               static_cast<double>(pixel.samples)),
           .measured = worst,
           .bound = 1e-6,
           .unit = "of it",
           .details = details}};
}

}  // namespace foveola
