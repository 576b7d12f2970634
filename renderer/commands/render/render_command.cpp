#include <algorithm>
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "renderer/base/files/files.h"
#include "renderer/base/text/print.h"
#include "renderer/base/work/work_scope.h"
#include "renderer/commands/commands.h"
#include "renderer/commands/render/film_parts.h"
#include "renderer/commands/render/render_arguments.h"
#include "renderer/commands/render/render_report.h"
#include "renderer/image/image_file.h"
#include "renderer/progressive/headless_render.h"

namespace foveola {
namespace {

void run_replay(const RenderArguments& arguments, const RenderSettings& settings,
                const SceneFinder& find_scene, const std::stop_token& stop) {
  const SampleAddress address = parse_sample("--replay", arguments.replay);
  require(settings.budget.seconds == 0.0, "--seconds",
          "cannot be combined with --replay; use --samples");
  const ReplayedPath path =
      replay(lit_scene(arguments.scene, arguments.look, find_scene), settings, address, stop);
  if (arguments.json) {
    print_text("{}\n", json_path(path).dump(2));
  } else {
    print_path(path);
  }
}

/// Whether a file is written for display.
bool is_shown(const std::string& file) {
  return !file.empty() && !holds_radiance(file) && !is_film(file);
}

/// A film stores the exposure chosen at its rendering. Radiances have no exposure, and neither has
/// a single path, unless adaptive sampling needs it.
bool needs_exposure(const RenderArguments& arguments, const RenderSettings& settings) {
  const bool is_replay = !arguments.replay.empty();
  return settings.progressive.adaptive ||
         (!is_replay &&
          (is_shown(arguments.output) || is_shown(arguments.view) || is_film(arguments.output)));
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

/// Throws UsageError for options that do not suit the output's kind of file.
void require_kind_of_output(const RenderArguments& arguments) {
  if (!is_film(arguments.output)) {
    require_writable_image(arguments.output);
    require(arguments.shard.empty(), "--shard", "needs a .film as its --output");
    require(!arguments.resume, "--resume", "needs a .film as its --output");
    return;
  }
  require_writable(arguments.output);
  require(arguments.adaptive_contrast == 0.0, "--adaptive", "cannot be continued in a .film");
  require(!arguments.seconds, "--seconds", "cannot be continued in a .film; use --spp");
}

/// Renders into a film, continuing an earlier run, and stores it at intervals.
Rendering render_film(const SceneSource& source, RenderSettings settings,
                      const RenderArguments& arguments, const std::stop_token& stop) {
  std::optional<FilmOrigin> so_far;
  if (arguments.resume && std::filesystem::exists(arguments.output)) {
    so_far = read_film(arguments.output);
    settings.so_far = &so_far->progress;
  }
  const auto identity = [&](const RenderReport& report) {
    ImageFacts facts = facts_of(report, settings, arguments.scene);
    facts.merge(light_facts(arguments.look));
    return identity_of(report, settings, std::move(facts), tone_curve(arguments.look));
  };
  settings.begin = [&, loaded = std::move(settings.begin)](const RenderReport& report) {
    loaded(report);
    if (so_far) {
      require_same_render(arguments.output, *so_far, identity(report), settings.part);
    }
  };
  settings.save = [&](const RenderReport& report, const RenderProgress& progress) {
    write_film(arguments.output,
               {.identity = identity(report), .part = settings.part, .progress = progress});
  };
  return render(source, settings, stop);
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
  require_kind_of_output(arguments);
  if (!arguments.view.empty()) {
    require_writable_image(arguments.view);
  }
  const SceneSource source = lit_scene(arguments.scene, arguments.look, find_scene);
  std::optional<StuckLoadExit> loading(std::in_place, stop);
  settings.begin = [&](const RenderReport&) { loading.reset(); };
  Rendering rendering = is_film(arguments.output) ? render_film(source, settings, arguments, stop)
                                                  : render(source, settings, stop);
  RenderReport& report = rendering.report;
  if (report.samples == 0) {
    return;
  }
  if (!is_film(arguments.output)) {
    write(rendering, settings, arguments);
  }
  if (is_shown(arguments.output) && report.is_lit) {
    const std::vector<std::string> faults =
        picture_faults(rendering.image, report.exposure.stops, report.is_enclosed);
    report.warnings.insert(report.warnings.end(), faults.begin(), faults.end());
  }
  const RenderNames names{.scene = arguments.scene, .output = arguments.output};
  if (arguments.json) {
    print_text("{}\n", json_report(report, settings, names).dump(2));
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
