// A render's report: on the terminal, as JSON, and in its image's header.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "renderer/image/image.h"
#include "renderer/image/image_file.h"
#include "renderer/progressive/headless_render.h"

namespace foveola {

/// Scene and output file as the person typed them.
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

/// What the image was made with, for its header.
ImageFacts facts_of(const RenderReport& report, const RenderSettings& settings,
                    const std::string& scene);

/// A line if nearly all of an image's pixels that have samples are black, or nearly all white, once
/// they are shown with 8 bits after an exposure of so many stops. is_enclosed: no light comes in
/// from outside the scene.
std::vector<std::string> picture_faults(const FilmImage& image, double exposure_stops,
                                        bool is_enclosed);

}  // namespace foveola
