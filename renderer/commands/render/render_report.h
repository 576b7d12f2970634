// A render's report: on the terminal, as JSON, and in its image's header.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "renderer/image/image.h"
#include "renderer/image/image_file.h"
#include "renderer/progressive/headless_render.h"

namespace foveola {

/// Scene and output file as typed by the user.
struct RenderNames {
  std::string scene;
  std::string output;
};

nlohmann::json json_report(const RenderReport& report, const RenderSettings& settings,
                           const RenderNames& names);
void print_report(const RenderReport& report, const RenderSettings& settings,
                  const RenderNames& names);

nlohmann::json json_path(const ReplayedPath& path);
void print_path(const ReplayedPath& path);

/// The facts of an image's making, for its header.
ImageFacts facts_of(const RenderReport& report, const RenderSettings& settings,
                    const std::string& scene);

/// A warning if nearly all sampled pixels of an image are black, or nearly all white, in 8 bits
/// after exposure_stops. is_enclosed: whether no light comes from outside the scene.
std::vector<std::string> picture_faults(const FilmImage& image, double exposure_stops,
                                        bool is_enclosed);

}  // namespace foveola
