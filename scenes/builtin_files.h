// The files of the scenes that Foveola makes itself: their names, their place in the cache, and
// having them made.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scenes/default_seed.h"

namespace foveola::scenes {

/// The names of the built-in scenes, in alphabetical order.
std::vector<std::string> builtin_names();

/// Where the cache keeps the scene's .glb. The file's name carries a digest of the generators'
/// sources, so that a scene made by other generators is never taken for this program's, and the
/// seed of a variant. It does not say with which compiler: generators make the same bytes with all
/// (each descriptor has their SHA-256).
std::filesystem::path cached_builtin(const std::string& name, std::uint32_t seed = default_seed);

/// The seed of the variant of the scene that `file` is called after in the manner of
/// cached_builtin, if it is.
std::optional<std::uint32_t> variant_seed(const std::string& name,
                                          const std::filesystem::path& file);

/// Has the scene made and writes it to `file`, whose folder is made too if need be. Returns the
/// number of its triangles. Throws Error if it cannot be made (see generate) or written.
std::size_t write_builtin(const std::string& name, const std::filesystem::path& file,
                          std::uint32_t seed = default_seed);

/// Whether `file` is a .glb that is as long as its header says: not cut off.
bool is_whole_glb(const std::filesystem::path& file);

/// The scene's .glb in the cache, made now if it is not there as it was kept (see
/// renderer/base/cache.h).
std::filesystem::path require_builtin(const std::string& name);

}  // namespace foveola::scenes
