// The renderer's commands beside `foveola bench`: render, compare, merge-images, preview, scene and
// tracker.
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "renderer/base/scene_source.h"
#include "renderer/command_line/cli_fwd.h"

namespace foveola {

/// Adds `render` to `app`. It runs when the command line is parsed, prints its result to standard
/// output and throws Error for faults that the user can mend. A requested `stop` ends its work
/// early, with a partial result. The other commands likewise.
void add_render(CLI::App& app, const SceneFinder& find_scene, const std::stop_token& stop);

/// Adds `compare` to `app`.
void add_compare(CLI::App& app);

/// Adds the command that merges the films of a render's parts into an image.
void add_merge_images(CLI::App& app);

/// Adds `preview` to `app`. It runs in the thread that parses the command line, the program's
/// first, until its window is closed or `stop` is requested.
void add_preview(CLI::App& app, const SceneFinder& find_scene, const std::stop_token& stop);

/// Returns the text of a scene's descriptor, with a remark for each of its objects.
using DescriptorText =
    std::function<std::string(const SceneSource& source, const std::vector<std::string>& remarks)>;

/// Adds `describe` to the command `scene`; see add_render.
void add_scene_describe(CLI::App& scene, const DescriptorText& descriptor_text,
                        const std::stop_token& stop);

/// Adds `info` to the command `scene`; see add_render.
void add_scene_info(CLI::App& scene, const SceneFinder& find_scene, const std::stop_token& stop);

/// Adds `pick` to the command `scene`; see add_render.
void add_scene_pick(CLI::App& scene, const SceneFinder& find_scene, const std::stop_token& stop);

/// Adds `sheet` to the command `scene`; see add_render. Its default are all `scenes`.
void add_scene_sheet(CLI::App& scene, const std::vector<std::string>& scenes,
                     const SceneFinder& find_scene, const std::stop_token& stop);

/// Adds `tracker list` and `tracker watch` to `app`.
void add_tracker_commands(CLI::App& app, const std::stop_token& stop);

}  // namespace foveola
