// Noise tables on the disk, by a hash of all that they depend on.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "study/prediction/noise_table.h"

namespace foveola::study {

class TableCache {
 public:
  /// folder: made when something is kept.
  explicit TableCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// The tables that were kept under `key`; empty if there are none, or if they are damaged: then
  /// they are simply made again.
  std::optional<std::vector<NoiseTable>> find(const std::string& key) const;
  /// Keeps the tables whole or not at all. Throws Error if the folder cannot be written.
  void keep(const std::string& key, const std::vector<NoiseTable>& tables) const;

 private:
  std::filesystem::path file_of(const std::string& key) const;

  std::filesystem::path folder_;
};

}  // namespace foveola::study
