#include "renderer/commands/render_command.h"

#include <algorithm>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/commands/picture_faults.h"
#include "renderer/commands/render_arguments.h"
#include "renderer/commands/render_report.h"
#include "renderer/image/image_file.h"
#include "renderer/progressive/headless_render.h"

namespace foveola {
namespace {

void run_replay(const RenderArguments& arguments, const RenderSettings& settings,
                const SceneFinder& find_scene, const std::stop_token& stop) {
  const SampleAddress address = parse_sample("--replay", arguments.replay);
  require(settings.budget.seconds == 0.0, "--seconds", "does not go with --replay; use --samples");
  const ReplayedPath path =
      replay(lit_scene(arguments.scene, arguments.look, find_scene), settings, address, stop);
  if (arguments.json) {
    fmt::print("{}\n", json_path(path).dump(2));
  } else {
    print_path(path);
  }
}

/// Whether a file is written as a display shows it.
bool is_shown(const std::string& file) { return !file.empty() && !holds_radiance(file); }

/// Radiances have no exposure, and neither has a single path, unless adaptive sampling asks what is
/// seen of them.
bool needs_exposure(const RenderArguments& arguments, const RenderSettings& settings) {
  const bool is_replay = !arguments.replay.empty();
  return settings.progressive.adaptive ||
         (!is_replay && (is_shown(arguments.output) || is_shown(arguments.view)));
}

void require_writable_image(const std::string& file) {
  require_image_extension(file);
  require_writable(file);
}

void write(const Rendering& rendering, const RenderSettings& settings,
           const RenderArguments& arguments) {
  ImageFacts facts = facts_of(rendering.report, settings, arguments.scene);
  facts.merge(light_facts(arguments.look));
  const ToneCurve curve = tone_curve(arguments.look);
  const double stops = rendering.report.exposure.stops;
  write_film_image(arguments.output, rendering.image, stops, facts, curve);
  if (settings.view) {
    write_image(arguments.view, rendering.view, stops, curve);
  }
}

void run_render(const CLI::App& command, const RenderArguments& arguments,
                const SceneFinder& find_scene, const std::stop_token& stop) {
  RenderSettings settings = settings_from(command, arguments);
  if (!needs_exposure(arguments, settings)) {
    settings.exposure.reset();
  }
  if (!arguments.replay.empty()) {
    run_replay(arguments, settings, find_scene, stop);
    return;
  }
  require(!arguments.output.empty(), "--output", "is required");
  require_writable_image(arguments.output);
  if (!arguments.view.empty()) {
    require_writable_image(arguments.view);
  }
  Rendering rendering =
      render(lit_scene(arguments.scene, arguments.look, find_scene), settings, stop);
  RenderReport& report = rendering.report;
  if (report.samples == 0) {
    return;
  }
  write(rendering, settings, arguments);
  if (is_shown(arguments.output) && report.is_lit) {
    const std::vector<std::string> faults =
        picture_faults(rendering.image, report.exposure.stops, report.is_enclosed);
    report.warnings.insert(report.warnings.end(), faults.begin(), faults.end());
  }
  const RenderNames names{.scene = arguments.scene, .output = arguments.output};
  if (arguments.json) {
    fmt::print("{}\n", json_report(report, settings, names).dump(2));
  } else {
    print_report(report, settings, names);
  }
}

}  // namespace

void add_render(CLI::App& app, const SceneFinder& find_scene, const std::stop_token& stop) {
  const auto arguments = std::make_shared<RenderArguments>();
  CLI::App* command =
      app.add_subcommand("render", "Render a picture, or a 360-degree image, without a window");
  add_render_options(*command, *arguments);
  command->footer(
      "Examples: foveola render scene.glb -o picture.png --fov 50\n"
      "          foveola render arcade -o arcade.exr --method fv --gaze 20,-5 --spp 4");
  command->callback([command, arguments, find_scene, stop] {
    run_render(*command, *arguments, find_scene, stop);
  });
}

}  // namespace foveola
