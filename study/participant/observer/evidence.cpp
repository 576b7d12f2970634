#include "study/participant/observer/evidence.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "renderer/base/transformed.h"

namespace foveola::study {
namespace {

constexpr auto achromatic = static_cast<std::size_t>(Channel::achromatic);

double square(double x) { return x * x; }

double mean_lightness(const CellPixels& pixels, const std::vector<ChannelValues>& values) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t cell = 0; cell < values.size(); ++cell) {
    sum += pixels.pixels_in_cell[cell] * values[cell][achromatic];
    count += pixels.pixels_in_cell[cell];
  }
  return count > 0.0 ? sum / count : 0.0;
}

int block_of(const Vision& vision) {
  return std::max(1, static_cast<int>(std::lround(vision.coarseness)));
}

/// Returns the sum of presented - expected over each block's pixels, in each channel.
std::vector<ChannelValues> block_differences(const Cells& cells, const CellPixels& pixels,
                                             const std::vector<ChannelValues>& presented,
                                             const std::vector<ChannelValues>& expected) {
  std::vector<ChannelValues> differences(cells.blocks().size());
  for (std::uint32_t cell = 0; cell < cells.count(); ++cell) {
    const double count = pixels.pixels_in_cell[cell];
    for (std::size_t channel = 0; channel < channel_count; ++channel) {
      differences[cells.block_of(cell)][channel] +=
          count * (presented[cell][channel] - expected[cell][channel]);
    }
  }
  return differences;
}

/// Returns (presented - expected)^2 of each block's mean in each channel, times its pixels. A block
/// at an edge, with fewer cells, is noisier than a complete one, and has less weight accordingly.
std::vector<ChannelValues> block_energies(const Cells& cells, const CellPixels& pixels,
                                          const std::vector<ChannelValues>& presented,
                                          const ExpectedMeans& expected) {
  std::vector<double> pixels_in_block(cells.blocks().size());
  for (std::uint32_t cell = 0; cell < cells.count(); ++cell) {
    pixels_in_block[cells.block_of(cell)] += pixels.pixels_in_cell[cell];
  }
  std::vector<ChannelValues> energies = block_differences(cells, pixels, presented, expected.first);
  const std::vector<ChannelValues> again =
      block_differences(cells, pixels, presented, expected.second);
  for (std::size_t block = 0; block < energies.size(); ++block) {
    const double part = static_cast<double>(cells.blocks()[block].cells) /
                        static_cast<double>(cells.cells_of_whole_block());
    for (std::size_t channel = 0; channel < channel_count; ++channel) {
      double& energy = energies[block][channel];
      energy = pixels_in_block[block] > 0.0
                   ? part * energy * again[block][channel] / pixels_in_block[block]
                   : 0.0;
    }
  }
  return energies;
}

}  // namespace

Cells outline_cells(const Vision& vision, const Vec3& object, double radius_deg) {
  return Cells::around(object, vision.surround_factor * radius_deg,
                       radius_deg / vision.recognition_line_pairs, vision.object_patch_deg,
                       block_of(vision));
}

std::vector<double> scales_deg(const Vision& vision, double finest_cell_deg) {
  std::vector<double> scales(static_cast<std::size_t>(std::lround(vision.scale_count)));
  for (std::size_t i = 0; i < scales.size(); ++i) {
    scales[i] = std::ldexp(finest_cell_deg, static_cast<int>(i));
  }
  return scales;
}

std::vector<Cells> material_cells(const Vision& vision, const Vec3& object, double radius_deg) {
  return transformed(scales_deg(vision, vision.material_cell_deg), [&](const double cell_deg) {
    return Cells::around(object, radius_deg, cell_deg, vision.object_patch_deg, block_of(vision));
  });
}

Cells cells_around(const Vision& vision, const Vec3& place, double radius_deg, double cell_deg) {
  constexpr double blocks_to_each_side = 0.8;  // a whole block, at any offset of the grid
  const double reach_deg = blocks_to_each_side * block_of(vision) * cell_deg;
  return Cells::around(place, std::max(radius_deg, reach_deg), cell_deg, vision.view_patch_deg,
                       block_of(vision));
}

std::vector<Cells> glance_cells(const Vision& vision, const Vec3& gaze) {
  return transformed(scales_deg(vision, vision.view_cell_deg), [&](const double cell_deg) {
    return cells_around(vision, gaze, vision.looked_at_deg, cell_deg);
  });
}

std::vector<PatchEnergies> patch_energies(const Cells& cells, const CellPixels& pixels,
                                          const std::vector<ChannelValues>& presented,
                                          const ExpectedMeans& expected, bool with_contrast) {
  std::vector<PatchEnergies> patches(cells.patches().size());
  std::vector<double> pixels_in_patch(patches.size());
  const double mean = with_contrast ? mean_lightness(pixels, expected.first) : 0.0;
  const double mean_again = with_contrast ? mean_lightness(pixels, expected.second) : 0.0;
  for (std::uint32_t cell = 0; cell < cells.count(); ++cell) {
    const double count = pixels.pixels_in_cell[cell];
    PatchEnergies& patch = patches[cells.patch_of(cell)];
    pixels_in_patch[cells.patch_of(cell)] += count;
    patch.cells += count > 0.0 ? 1.0 : 0.0;
    if (with_contrast) {
      patch.contrast += count * 2.0 * (expected.first[cell][achromatic] - mean) * 2.0 *
                        (expected.second[cell][achromatic] - mean_again);
    }
  }
  const std::vector<ChannelValues> energies = block_energies(cells, pixels, presented, expected);
  for (std::size_t block = 0; block < energies.size(); ++block) {
    ChannelValues& noise = patches[cells.blocks()[block].patch].noise;
    for (std::size_t channel = 0; channel < channel_count; ++channel) {
      noise[channel] += energies[block][channel];
    }
  }
  for (std::size_t i = 0; i < patches.size(); ++i) {
    PatchEnergies& patch = patches[i];
    patch.direction = cells.patches()[i].direction;
    for (double& noise : patch.noise) {
      noise /= pixels_in_patch[i];
    }
    patch.contrast /= pixels_in_patch[i];
  }
  std::erase_if(patches, [](const PatchEnergies& patch) { return patch.cells == 0.0; });
  return patches;
}

double outline_signal_to_noise(std::span<const PatchEnergies> patches, const Visibility& visibility,
                               const Vec3& gaze, double rose) {
  double signal = 0.0;
  double noise = 0.0;
  const double own_noise = 1.0 / square(rose);
  for (const PatchEnergies& patch : patches) {
    const double visible = visibility.at(glm::dot(patch.direction, gaze))[achromatic];
    signal += patch.cells * visible * patch.contrast;
    noise += patch.cells * (visible * patch.noise[achromatic] + own_noise);
  }
  return noise > 0.0 ? std::sqrt(signal / noise) : 0.0;
}

double visible_difference_jnd(std::span<const PatchEnergies> patches, const Visibility& visibility,
                              const Vec3& gaze) {
  double sum = 0.0;
  double total_weight = 0.0;
  for (const PatchEnergies& patch : patches) {
    const auto& visible = visibility.at(glm::dot(patch.direction, gaze));
    const double weight = patch.cells * visible[achromatic];
    double difference = 0.0;
    for (std::size_t channel = 0; channel < channel_count; ++channel) {
      difference += visible[channel] * patch.noise[channel];
    }
    sum += weight * difference;
    total_weight += weight;
  }
  return total_weight > 0.0 ? std::sqrt(sum / total_weight)
                            : std::numeric_limits<double>::infinity();
}

double pooled_jnd(const Vision& vision, std::span<const double> jnd_of_scales) {
  double sum = 0.0;
  for (const double jnd : jnd_of_scales) {
    sum += std::pow(jnd, vision.pooling_exponent);
  }
  return std::pow(sum, 1.0 / vision.pooling_exponent);
}

}  // namespace foveola::study
