// Tabulates the noise of a protocol's scenes with each of its methods, for predicted looks, which
// render nothing.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <stop_token>
#include <string>
#include <tuple>
#include <vector>

#include "renderer/base/work/shard.h"
#include "study/prediction/noise_table.h"
#include "study/stage/scene_stage.h"

namespace foveola::study {

/// The noise in one picture of one object, with one method aimed at its centre.
struct ObjectNoise {
  NoiseTable outline;
  std::vector<NoiseTable> material;  ///< the material's noise on each scale
};

/// A trial's scene, method and object.
using PicturedPlace = std::tuple<std::string, std::string, std::string>;

/// The picture numbers that trials see of each place.
using PicturesWanted = std::map<PicturedPlace, std::set<std::uint32_t>>;

/// Returns the maximum number of pictures of a place. A trial sees one picture, so that differences
/// between pictures are random: noise from few bright paths is less than its mean in most pictures.
/// A scaled film has so few pixels that its pictures differ more.
std::uint32_t picture_count(const Vision& vision);

struct NoiseAtlas {
  /// The wanted pictures of each place, by number.
  std::map<PicturedPlace, std::map<std::uint32_t, ObjectNoise>> objects;
  /// By scene: the noise of surround patches on each scale, with evenly spread samples. The patches
  /// are the same on all scales.
  std::map<std::string, std::vector<NoiseTable>> surround;
};

/// Inputs of an atlas; it refers to them.
struct AtlasSetting {
  const Protocol& protocol;
  const SceneStages& stages;
  const Vision& vision;
  double highest_seen_deg = 90.0;  ///< maximum gaze elevation above and below the horizon
  const PicturesWanted& wanted;  ///< of the protocol's scenes and methods, and the scenes' objects
  const Workers& workers;
  std::filesystem::path cache;  ///< folder of earlier tables
};

/// Renders the wanted pilots, or takes their tables from the cache; shows progress. Throws Error if
/// stopped, or for a protocol with adaptive sampling, whose samples cannot be predicted.
NoiseAtlas make_noise_atlas(const AtlasSetting& setting, const std::stop_token& stop);

/// Counts of separately rendered items.
struct PreparedItems {
  std::int64_t items = 0;
  std::int64_t rendered = 0;  ///< items that were not in the cache
};

/// Renders the shard's part of the same pilots into the cache, as far as they are missing. Shards
/// divide the surround of each scene and each object that is looked at, whatever the cache has.
/// Throws Error as make_noise_atlas.
PreparedItems prepare_pilots(const AtlasSetting& setting, const Shard& shard,
                             const std::stop_token& stop);

}  // namespace foveola::study
