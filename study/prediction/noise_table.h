// How noisy each patch of one picture is after so many samples, the data of predicted looks, and
// their cache on the disk.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "renderer/base/build_info.h"
#include "study/participant/evidence.h"

namespace foveola::study {

/// Noise over the density of samples, at densities that grow by half an octave from one level to
/// the next.
struct PatchNoise {
  Vec3 direction{0.0F};       ///< unit length, world
  double cells = 0.0;         ///< how many cells it stands for, as PatchEnergies::cells
  double contrast = 0.0;      ///< as PatchEnergies::contrast
  ChannelValues unsampled{};  ///< the noise of black, JND^2
  double first_per_sr = 0.0;  ///< density at the first level, samples per steradian
  std::vector<ChannelValues>
      noise_times_density;  ///< JND^2 samples per steradian, one for each level
};
using NoiseTable = std::vector<PatchNoise>;

/// The noise of a patch after `samples_per_sr`, interpolated; below the first level between its and
/// black's, beyond the last one falling with the number of samples.
ChannelValues noise_at(const PatchNoise& patch, double samples_per_sr);

/// The mean of patches that are sampled alike, each counted by its cells. table: not empty.
PatchNoise mean_of(const NoiseTable& table);

/// The patches' energies but for their noise, which changes with the samples.
std::vector<PatchEnergies> energies_without_noise(const NoiseTable& table);

class TableCache {
 public:
  /// folder: made when something is kept. build: its tables are not those of another whose last
  /// bits may differ.
  explicit TableCache(std::filesystem::path folder, const BuildInfo& build = build_info())
      : folder_(std::move(folder)), arithmetic_(arithmetic_name(build)) {}

  /// The tables that were kept under `key`; empty if there are none, or if they are damaged: then
  /// they are simply made again.
  std::optional<std::vector<NoiseTable>> find(const std::string& key) const;
  /// Keeps the tables whole or not at all. Throws Error if the folder cannot be written.
  void keep(const std::string& key, const std::vector<NoiseTable>& tables) const;

 private:
  std::filesystem::path file_of(const std::string& key) const;

  std::filesystem::path folder_;
  std::string arithmetic_;
};

}  // namespace foveola::study
