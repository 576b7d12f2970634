// Tables of the noise of one picture's patches over the number of samples, and their cache on the
// disk.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "renderer/base/build_info.h"
#include "study/participant/observer/evidence.h"

namespace foveola::study {

/// Noise over the density of samples, at densities that grow by half an octave per level.
struct PatchNoise {
  Vec3 direction{0.0F};       ///< unit length, world
  double cells = 0.0;         ///< number of represented cells, as PatchEnergies::cells
  double contrast = 0.0;      ///< as PatchEnergies::contrast
  ChannelValues unsampled{};  ///< the noise of black, JND^2
  double first_per_sr = 0.0;  ///< density at the first level, samples per steradian
  std::vector<ChannelValues> noise_times_density;  ///< JND^2 samples per steradian, one per level
};
using NoiseTable = std::vector<PatchNoise>;

/// Returns the noise of a patch after `samples_per_sr`: interpolated; below the first level between
/// its noise and black's; beyond the last one falling as one over the samples.
ChannelValues noise_at(const PatchNoise& patch, double samples_per_sr);

/// Returns the mean of equally sampled patches, weighted by their cells. table: not empty.
PatchNoise mean_of(const NoiseTable& table);

/// A table for each scale, in which the mean of a view's patches on that scale stands for the patch
/// at the view's place. A view that has no patches on any one scale, where its cells are too small
/// for the film's pixels, is left out on all. views: not empty, a table for each scale.
std::vector<NoiseTable> mean_patches(const std::vector<std::vector<NoiseTable>>& views,
                                     const std::vector<Vec3>& places);

/// Returns the patches' energies without their noise, which changes with the samples.
std::vector<PatchEnergies> energies_without_noise(const NoiseTable& table);

class TableCache {
 public:
  /// folder: made when a table is kept. build: its tables are kept apart from those of builds with
  /// other rounding.
  explicit TableCache(std::filesystem::path folder, const BuildInfo& build = build_info())
      : folder_(std::move(folder)), arithmetic_(arithmetic_name(build)) {}

  /// Returns the tables kept under `key`; empty if there are none or they are damaged, which means
  /// to make them again.
  std::optional<std::vector<NoiseTable>> find(const std::string& key) const;
  /// Keeps the tables, completely or not at all. Throws Error if the folder cannot be written.
  void keep(const std::string& key, const std::vector<NoiseTable>& tables) const;

 private:
  std::filesystem::path file_of(const std::string& key) const;

  std::filesystem::path folder_;
  std::string arithmetic_;
};

}  // namespace foveola::study
