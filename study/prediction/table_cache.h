// Noise tables on the disk, by a hash of all that they depend on.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "renderer/base/build_info.h"
#include "study/prediction/noise_table.h"

namespace foveola::study {

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
