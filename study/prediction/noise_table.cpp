#include "study/prediction/noise_table.h"

#include <algorithm>
#include <cmath>

namespace foveola::study {
namespace {

constexpr double levels_per_octave = 2.0;

ChannelValues mixed(const ChannelValues& a, const ChannelValues& b, double part, double scale) {
  ChannelValues result;
  for (std::size_t c = 0; c < channel_count; ++c) {
    result[c] = scale * (a[c] + part * (b[c] - a[c]));
  }
  return result;
}

}  // namespace

ChannelValues noise_at(const PatchNoise& patch, double samples_per_sr) {
  const std::vector<ChannelValues>& sample_counts = patch.noise_times_density;
  if (sample_counts.empty() || samples_per_sr <= 0.0) {
    return patch.unsampled;
  }
  const double ratio = samples_per_sr / patch.first_per_sr;
  if (ratio <= 1.0) {
    const ChannelValues first =
        mixed(sample_counts.front(), sample_counts.front(), 0.0, 1.0 / patch.first_per_sr);
    return mixed(patch.unsampled, first, ratio, 1.0);
  }
  const double place = levels_per_octave * std::log2(ratio);
  const std::size_t level = std::min(static_cast<std::size_t>(place), sample_counts.size() - 1);
  const std::size_t next = std::min(level + 1, sample_counts.size() - 1);
  return mixed(sample_counts[level], sample_counts[next],
               std::min(1.0, place - static_cast<double>(level)), 1.0 / samples_per_sr);
}

PatchNoise mean_of(const NoiseTable& table) {
  PatchNoise mean;
  mean.direction = table.front().direction;
  mean.noise_times_density.resize(table.front().noise_times_density.size());
  for (const PatchNoise& patch : table) {
    mean.cells += patch.cells;
  }
  for (const PatchNoise& patch : table) {
    const double part = patch.cells / mean.cells;
    mean.first_per_sr += part * patch.first_per_sr;
    for (std::size_t c = 0; c < channel_count; ++c) {
      mean.unsampled[c] += part * patch.unsampled[c];
      for (std::size_t level = 0; level < mean.noise_times_density.size(); ++level) {
        mean.noise_times_density[level][c] += part * patch.noise_times_density[level][c];
      }
    }
  }
  return mean;
}

std::vector<PatchEnergies> energies_without_noise(const NoiseTable& table) {
  std::vector<PatchEnergies> energies;
  for (const PatchNoise& patch : table) {
    energies.push_back({.direction = patch.direction,
                        .cells = patch.cells,
                        .noise = {},
                        .contrast = patch.contrast});
  }
  return energies;
}

}  // namespace foveola::study
