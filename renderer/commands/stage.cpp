#include "renderer/commands/stage.h"

#include <algorithm>

#include <fmt/format.h>

#include "renderer/base/clock.h"
#include "renderer/commands/standpoint.h"
#include "renderer/scene/load_scene.h"
#include "renderer/scene/scene_facts.h"
#include "renderer/view/equirect.h"

namespace foveola {
namespace {

/// What any renderer can show: for comparing with others.
void make_diffuse(Material& material) {
  material.metallic = 0.0F;
  material.specular = 0.0F;
  material.transmission = 0.0F;
  material.clearcoat = 0.0F;
  material.sheen_color = Rgb(0.0F);
  material.normal_texture = {};
}

Scene load(const SceneSource& source, const RenderSettings& settings) {
  Scene scene = load_scene(source);
  if (settings.diffuse) {
    std::for_each(scene.materials.begin(), scene.materials.end(), make_diffuse);
  }
  return scene;
}

std::vector<std::string> warnings_of(const Scene& scene) {
  std::vector<std::string> warnings = scene.warnings;
  if (!has_light(scene)) {
    warnings.emplace_back(
        "nothing in the scene shines, so that pictures of it are black; --environment 1,1,1 of "
        "render and preview lights it evenly, and see their --help for daylight and images");
  }
  return warnings;
}

/// Where nobody says where to stand. Adds a warning that says it.
CameraView camera_at_standpoint(const Scene& scene, const RayScene& rays,
                                std::vector<std::string>& warnings) {
  Standpoint standpoint = choose_standpoint(scene, rays);
  const DVec3 place = DVec3(standpoint.position) + scene.origin;
  if (scene.object_count() > 0) {
    warnings.push_back(fmt::format(
        "the file has no camera: it is seen from ({:.4g}, {:.4g}, {:.4g}), {}; --camera X,Y,Z "
        "stands elsewhere",
        place.x, place.y, place.z, standpoint.reason));
  }
  return {.name = "", .position = standpoint.position, .heading = standpoint.heading};
}

CameraView choose_camera(const SceneSource& source, const Scene& scene, const RayScene& rays,
                         const RenderSettings& settings, std::vector<std::string>& warnings) {
  CameraView view;
  if (source.camera_position) {
    view = {.name = "",
            .position = scene.from_file(*source.camera_position),
            .heading = source.heading};
  } else if (!scene.cameras.empty()) {
    view = scene.cameras.front();
  } else if (!settings.camera) {
    view = camera_at_standpoint(scene, rays, warnings);
  }
  if (settings.camera) {
    view.position = scene.from_file(*settings.camera);
  }
  view.heading = settings.head.value_or(view.heading);
  return view;
}

/// How long one of `steps` takes.
template <typename Step>
auto timed(double& elapsed_s, const Step& step) {
  const SteadyClock clock;
  const Nanoseconds start = clock.now();
  auto result = step();
  elapsed_s = seconds(clock.now() - start);
  return result;
}

}  // namespace

Stage::Stage(const SceneSource& source, const RenderSettings& settings)
    : workers(settings.threads),
      scene(timed(load_seconds, [&] { return load(source, settings); })),
      tracer(timed(build_seconds, [&] { return PathTracer(scene, workers); })),
      warnings(warnings_of(scene)),
      camera(choose_camera(source, scene, tracer.ray_scene(), settings, warnings)),
      gaze(settings.gaze.value_or(camera.heading)) {}

void print_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) {
    fmt::print(stderr, "foveola: warning: {}\n", warning);
  }
}

TraceSettings trace_settings(const RenderSettings& settings) {
  return {.max_depth = settings.max_depth,
          .seed = settings.seed,
          .pixel_angle_rad = pixel_angle_rad(settings.size.x),
          .largest_radiance = settings.largest_radiance,
          .uses_general_path = settings.uses_general_path};
}

PreviewSettings preview_settings(const RenderSettings& settings, const Vec3& viewpoint,
                                 double exposure_stops) {
  PreviewSettings preview;
  preview.film_width = settings.size.x;
  preview.film_height = settings.size.y;
  preview.horizontal_fov_deg = settings.fov_deg;
  preview.vertical_fov_deg = settings.vertical_fov_deg.value_or(settings.fov_deg);
  preview.lens = settings.lens;
  preview.keep_variances = settings.variance;
  preview.viewpoint = viewpoint;
  if (settings.adaptive_contrast > 0.0) {
    preview.adaptive = VisibleNoise{.contrast = settings.adaptive_contrast};
  }
  if (settings.view) {
    preview.view_width = settings.view->x;
    preview.view_height = settings.view->y;
  }
  preview.unsampled = settings.unsampled;
  preview.exposure_stops = exposure_stops;
  preview.trace = trace_settings(settings);
  return preview;
}

}  // namespace foveola
