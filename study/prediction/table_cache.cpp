#include "study/prediction/table_cache.h"

#include <nlohmann/json.hpp>

#include "renderer/base/cache.h"
#include "renderer/base/digest.h"

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
  NoiseTable table;
  for (const Json& patch : json) {
    table.push_back(patch_from(patch));
  }
  return table;
}

}  // namespace

std::optional<std::vector<NoiseTable>> TableCache::find(const std::string& key) const {
  const std::optional<std::string> kept = kept_content(file_of(key));
  if (!kept) {
    return std::nullopt;
  }
  try {
    std::vector<NoiseTable> tables;
    for (const Json& table : Json::from_cbor(*kept)) {
      tables.push_back(table_from(table));
    }
    return tables;
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
  keep_content(file_of(key), std::string(bytes.begin(), bytes.end()));
}

fs::path TableCache::file_of(const std::string& key) const {
  return folder_ / (sha256(std::string_view(arithmetic_ + "\n" + key)) + ".cbor");
}

}  // namespace foveola::study
