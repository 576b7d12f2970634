#include "study/prediction/noise_table.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <nlohmann/json.hpp>

#include "renderer/base/files/cache.h"
#include "renderer/base/files/digest.h"
#include "renderer/base/transformed.h"

namespace fs = std::filesystem;
namespace foveola::study {
namespace {

using Json = nlohmann::json;

Json json_of(const PatchNoise& patch) {
  return Json::array({Json::array({patch.direction.x, patch.direction.y, patch.direction.z}),
                      patch.cells, patch.contrast, patch.unsampled, patch.first_per_sr,
                      patch.noise_times_density});
}

PatchNoise patch_from(const Json& json) {
  const Json& direction = json.at(0);
  return {.direction = {direction.at(0).get<float>(), direction.at(1).get<float>(),
                        direction.at(2).get<float>()},
          .cells = json.at(1).get<double>(),
          .contrast = json.at(2).get<double>(),
          .unsampled = json.at(3).get<ChannelValues>(),
          .first_per_sr = json.at(4).get<double>(),
          .noise_times_density = json.at(5).get<std::vector<ChannelValues>>()};
}

NoiseTable table_from(const Json& json) {
  return transformed(json, [&](const Json& patch) { return patch_from(patch); });
}

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

std::vector<NoiseTable> mean_patches(const std::vector<std::vector<NoiseTable>>& views,
                                     const std::vector<Vec3>& places) {
  std::vector<NoiseTable> tables(views.front().size());
  for (std::size_t view = 0; view < views.size(); ++view) {
    if (std::ranges::any_of(views[view], std::mem_fn(&NoiseTable::empty))) {
      continue;
    }
    for (std::size_t scale = 0; scale < tables.size(); ++scale) {
      tables[scale].push_back(mean_of(views[view][scale]));
      tables[scale].back().direction = places[view];
    }
  }
  return tables;
}

std::vector<PatchEnergies> energies_without_noise(const NoiseTable& table) {
  return transformed(table, [&](const PatchNoise& patch) {
    return PatchEnergies{.direction = patch.direction,
                         .cells = patch.cells,
                         .noise = {},
                         .contrast = patch.contrast};
  });
}

std::optional<std::vector<NoiseTable>> TableCache::find(const std::string& key) const {
  const std::optional<std::string> kept = read_from_cache(file_of(key));
  if (!kept) {
    return std::nullopt;
  }
  try {
    return transformed(Json::from_cbor(*kept),
                       [&](const Json& table) { return table_from(table); });
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

void TableCache::keep(const std::string& key, const std::vector<NoiseTable>& tables) const {
  Json json = Json::array();
  for (const NoiseTable& table : tables) {
    Json patches = Json::array();
    for (const PatchNoise& patch : table) {
      patches.push_back(json_of(patch));
    }
    json.push_back(std::move(patches));
  }
  make_cache_folder(folder_);
  const std::vector<std::uint8_t> bytes = Json::to_cbor(json);
  store_content(file_of(key), std::string(bytes.begin(), bytes.end()));
}

fs::path TableCache::file_of(const std::string& key) const {
  return folder_ / (sha256(std::string_view(arithmetic_ + "\n" + key)) + ".cbor");
}

}  // namespace foveola::study
