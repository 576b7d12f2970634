// Reference images: long renders, cached by everything they depend on.
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
  std::vector<Vec3> interests;             ///< directions with more samples
  std::uint64_t samples_per_interest = 0;  ///< foveated around each of them
};

/// The reference's file in `cache`. Its name is a hash of the scene's `scene_key` (its content's
/// SHA-256 and all additions), the settings, and the parts of `build` on which its last bits
/// depend.
std::filesystem::path reference_file(const std::filesystem::path& cache,
                                     const std::string& scene_key,
                                     const ReferenceSettings& settings, const BuildInfo& build);

/// Renders the reference, or reads it from `cache`. progress: called with the fraction done. Throws
/// Error if stopped, or if the cache cannot be written. Its noise is independent of every
/// preview's, whatever their seeds. A cached file that is damaged is rendered again.
FilmImage reference_image(const PathTracer& tracer, const std::string& scene_key,
                          const ReferenceSettings& settings, const Workers& workers,
                          const std::filesystem::path& cache,
                          const std::function<void(double)>& progress, std::stop_token stop);

}  // namespace foveola
