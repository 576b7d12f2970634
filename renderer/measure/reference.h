// What an image will converge to: long renders, kept in a cache by what they depend on.
#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "renderer/base/build_info.h"
#include "renderer/image/image.h"
#include "renderer/trace/paths/path_tracer.h"

namespace foveola {

struct ReferenceSettings {
  Vec3 viewpoint{0.0F};
  int width = 0;
  int height = 0;
  int max_depth = TraceSettings{}.max_depth;
  std::uint32_t seed = 0;
  int samples_per_pixel = 64;              ///< uniformly over the image
  std::vector<Vec3> interests;             ///< directions that get more
  std::uint64_t samples_per_interest = 0;  ///< foveated around each of them
};

/// The file in `cache` that the reference lies in: its name is a hash of the scene's `scene_key`
/// (its content's SHA-256 and whatever was added to it), the settings, and what of `build` its last
/// bits depend on.
std::filesystem::path reference_file(const std::filesystem::path& cache,
                                     const std::string& scene_key,
                                     const ReferenceSettings& settings, const BuildInfo& build);

/// Renders the reference, or takes it from `cache`. progress is called with the fraction done.
/// Throws Error if stopped, or if the cache cannot be written. Its noise is independent of every
/// preview's, whatever their seeds. A cached file that is damaged is rendered again.
FilmImage reference_image(const PathTracer& tracer, const std::string& scene_key,
                          const ReferenceSettings& settings, const Workers& workers,
                          const std::filesystem::path& cache,
                          const std::function<void(double)>& progress, std::stop_token stop);

}  // namespace foveola
