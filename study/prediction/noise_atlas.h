// How noisy a protocol's scenes are with each of its methods: all that predicted looks, which are
// not rendered, know of pictures.
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

/// The noise in one picture of one object, with one method that is aimed at its middle.
struct ObjectNoise {
  NoiseTable outline;
  std::vector<NoiseTable> material;  ///< the material's noise on each scale
};

/// Where a trial looks: its scene, method and object.
using PicturedPlace = std::tuple<std::string, std::string, std::string>;

/// The numbers of the pictures that trials see of each place.
using PicturesWanted = std::map<PicturedPlace, std::set<std::uint32_t>>;

/// How many pictures of a place there may be. What differs between them is left to chance in a
/// trial, which sees one: noise that comes from few bright paths is less than its mean in most
/// pictures. A scaled film has so few pixels that its pictures differ more.
std::uint32_t picture_count(const Vision& vision);

struct NoiseAtlas {
  /// Of each place the wanted pictures, by their numbers.
  std::map<PicturedPlace, std::map<std::uint32_t, ObjectNoise>> objects;
  /// By scene: the noise of surround patches on each scale, with samples that are spread evenly.
  /// The patches are the same on all scales.
  std::map<std::string, std::vector<NoiseTable>> surround;
};

/// What an atlas is made of; it refers to all of it.
struct AtlasSetting {
  const Protocol& protocol;
  const SceneStages& stages;
  const Vision& vision;
  double highest_seen_deg = 90.0;  ///< above the horizon, or below it, whoever looks around
  const PicturesWanted& wanted;  ///< of the protocol's scenes and methods, and the scenes' objects
  const Workers& workers;
  std::filesystem::path cache;  ///< folder of the tables that were made before
};

/// Renders the wanted pilots, or takes their tables from the cache; shows progress. Throws Error if
/// stopped, or for a protocol with adaptive sampling: where its samples go is not known
/// beforehand.
NoiseAtlas make_noise_atlas(const AtlasSetting& setting, const std::stop_token& stop);

/// What can be rendered by itself, and was to be there afterwards.
struct PreparedItems {
  std::int64_t items = 0;
  std::int64_t rendered = 0;  ///< the others were there before
};

/// Renders what the cache lacks of the shard's part of the same pilots, into the cache. What they
/// are dealt by is the surround of each scene, and each object that is looked at, whatever the
/// cache has. Throws Error as make_noise_atlas.
PreparedItems prepare_pilots(const AtlasSetting& setting, const Shard& shard,
                             const std::stop_token& stop);

}  // namespace foveola::study
