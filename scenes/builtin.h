// The scenes that Foveola makes itself, so that demo and tests need no download.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scenes/modelling/model.h"

namespace foveola::scenes {

/// An open court between two arcaded storeys: cloth, plants with cut-out leaves, sun and sky.
Model make_arcade(std::uint32_t seed);
/// A cathedral's nave with two aisles, vaults and an apse, lit through stained glass.
Model make_church(std::uint32_t seed);
/// A long table with its chairs under many ceiling lights.
Model make_meeting_room(std::uint32_t seed);
/// A classroom by day: desks, a blackboard, books, a skeleton, sun through a row of windows.
Model make_schoolroom(std::uint32_t seed);
/// A car under the softboxes of a photographer's studio.
Model make_studio_car(std::uint32_t seed);

/// In alphabetical order.
std::vector<std::string> builtin_names();

/// The scene, or with another seed a variant of it: the same things in the same places, of other
/// stones, cloths, leaves and scribbles. Throws Error if there is no such scene, naming those there
/// are.
Model make_builtin(const std::string& name, std::uint32_t seed = default_seed);

/// Where the cache keeps the scene's .glb. The file's name carries a digest of the generators'
/// sources, so that a scene made by other generators is never taken for this program's, and the
/// seed of a variant.
std::filesystem::path cached_builtin(const std::string& name, std::uint32_t seed = default_seed);

/// The seed of the variant of the scene that `file` is called after in the manner of
/// cached_builtin, if it is.
std::optional<std::uint32_t> variant_seed(const std::string& name,
                                          const std::filesystem::path& file);

/// Makes the scene and writes it to `file`, whose folder is made too if need be. Returns the number
/// of its triangles.
std::size_t write_builtin(const std::string& name, const std::filesystem::path& file,
                          std::uint32_t seed = default_seed);

/// Whether `file` is a .glb that is as long as its header says: not cut off.
bool is_whole_glb(const std::filesystem::path& file);

/// The scene's .glb in the cache, made now if it is not there or not whole.
std::filesystem::path require_builtin(const std::string& name);

}  // namespace foveola::scenes
