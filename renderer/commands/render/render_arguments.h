// The options of `render`, and their interpretation as settings.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "renderer/command_line/cli_fwd.h"
#include "renderer/commands/look_options.h"
#include "renderer/progressive/headless_render.h"

namespace foveola {

/// As typed; empty or nullopt if an option was not given.
struct RenderArguments {
  RenderSettings settings;  ///< settings without a notation of their own
  LookArguments look;
  std::string scene;
  std::string output;
  bool panorama = false;
  std::string size;
  std::string gaze;
  std::string pointer;
  std::string lens;
  std::string view;
  std::string view_size = size_text(default_view_size);
  bool fill_unsampled = false;
  std::optional<double> samples_per_pixel;
  std::optional<std::int64_t> samples;
  std::optional<double> seconds;
  double largest_radiance = settings.progressive.trace.largest_radiance;
  double adaptive_contrast = 0.0;
  std::string replay;
  std::string shard;  ///< empty: the whole
  std::string split = "tiles";
  bool resume = false;
  bool json = false;
};

/// Adds all options to `command`; `arguments` must outlive it.
void add_render_options(CLI::App& command, RenderArguments& arguments);

/// Throws UsageError for settings that are invalid for any scene.
RenderSettings settings_from(const CLI::App& command, const RenderArguments& arguments);

/// Throws UsageError unless `valid`.
void require(bool valid, const std::string& option, const std::string& what);

}  // namespace foveola
