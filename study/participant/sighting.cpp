#include "study/participant/sighting.h"

#include <cmath>
#include <limits>
#include <numeric>

namespace foveola::study {
namespace {

constexpr auto achromatic = static_cast<std::size_t>(Channel::achromatic);

double square(double x) { return x * x; }

/// The mean achromatic value of all pixels in cells.
double mean_lightness(const CellPixels& pixels, const std::vector<ChannelValues>& values) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t cell = 0; cell < values.size(); ++cell) {
    sum += pixels.pixels_in_cell[cell] * values[cell][achromatic];
    count += pixels.pixels_in_cell[cell];
  }
  return count > 0.0 ? sum / count : 0.0;
}

}  // namespace

Cells outline_cells(const Vision& vision, const Vec3& object, double radius_deg) {
  return Cells::around(object, vision.surround_factor * radius_deg,
                       radius_deg / vision.recognition_line_pairs, vision.object_patch_deg);
}

Cells material_cells(const Vision& vision, const Vec3& object, double radius_deg) {
  return Cells::around(object, radius_deg, vision.material_cell_deg, vision.object_patch_deg);
}

Cells view_cells(const Vision& vision) {
  return Cells::everywhere(vision.view_cell_deg, vision.view_patch_deg);
}

std::vector<PatchEnergies> patch_energies(const Cells& cells, const CellPixels& pixels,
                                          const std::vector<ChannelValues>& presented,
                                          const std::vector<ChannelValues>& expected,
                                          bool with_contrast) {
  std::vector<PatchEnergies> patches(cells.patches().size());
  std::vector<double> pixels_in_patch(patches.size());
  const double mean = with_contrast ? mean_lightness(pixels, expected) : 0.0;
  for (std::uint32_t cell = 0; cell < cells.count(); ++cell) {
    const double count = pixels.pixels_in_cell[cell];
    if (count == 0.0) {
      continue;
    }
    PatchEnergies& patch = patches[cells.patch_of(cell)];
    pixels_in_patch[cells.patch_of(cell)] += count;
    patch.cells += 1.0;
    for (std::size_t channel = 0; channel < channel_count; ++channel) {
      patch.noise[channel] += count * square(presented[cell][channel] - expected[cell][channel]);
    }
    if (with_contrast) {
      patch.contrast += count * square(2.0 * (expected[cell][achromatic] - mean));
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

}  // namespace foveola::study
