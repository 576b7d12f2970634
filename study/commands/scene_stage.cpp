#include "study/commands/scene_stage.h"

#include <cassert>

#include <fmt/format.h>

#include "renderer/base/digest.h"
#include "renderer/base/files.h"
#include "renderer/measure/reference.h"
#include "renderer/scene/load_scene.h"

namespace foveola::study {
namespace {

std::vector<OfferedObject> objects_on_offer(const SceneSource& source) {
  std::vector<OfferedObject> offered;
  for (const ObjectOfInterest& object : source.objects) {
    offered.push_back({.name = object.name,
                       .direction = glm::normalize(object.position - *source.camera_position),
                       .radius_deg = object.radius_deg});
  }
  return offered;
}

std::string text_of(const Vec3& v) { return fmt::format("{},{},{};", v.x, v.y, v.z); }

/// All that the radiance depends on beside the settings: the file and what the source adds to it.
std::string scene_key(const Scene& scene, const SceneSource& source) {
  std::string key = scene.sha256 + ";";
  if (source.environment_radiance) {
    key += "environment:" + text_of(*source.environment_radiance);
  }
  if (source.sky) {
    key +=
        fmt::format("sky:{},{},{},{};", source.sky->sun.azimuth_rad, source.sky->sun.elevation_rad,
                    source.sky->turbidity, source.sky->ground_albedo);
  }
  if (source.environment_file) {
    key += "environment:" + sha256_of_file(*source.environment_file) + ";";
  }
  key += fmt::format("rotation:{};strength:{};radii:{},{};", source.environment_rotation_rad,
                     source.environment_strength, source.light_radius_m.value_or(-1.0F),
                     source.sun_angular_radius_rad.value_or(-1.0F));
  for (const RectangleLight& light : source.lights) {
    key += fmt::format("light:{},{};", light.size.x, light.size.y) + text_of(light.center) +
           text_of(light.normal) + text_of(light.radiance);
  }
  for (const Sun& sun : source.suns) {
    key += fmt::format("sun:{},{},{};", sun.place.azimuth_rad, sun.place.elevation_rad,
                       sun.angular_radius_rad) +
           text_of(sun.irradiance);
  }
  return key;
}

}  // namespace

SceneStage::SceneStage(SceneSource source, const Workers& workers)
    : source_(std::move(source)),
      scene_(load_scene(source_)),
      tracer_(scene_, workers),
      objects_(objects_on_offer(source_)) {
  assert(source_.camera_position && !objects_.empty());
}

void SceneStage::render_reference(const Protocol& protocol, const Workers& workers,
                                  const std::function<void(double)>& progress,
                                  const std::stop_token& stop) {
  ReferenceSettings settings;
  settings.viewpoint = viewpoint();
  settings.width = protocol.film.width;
  settings.height = protocol.film.height;
  settings.max_depth = protocol.film.max_depth;
  settings.samples_per_pixel = protocol.reference.samples_per_pixel;
  settings.samples_per_interest = static_cast<std::uint64_t>(protocol.reference.samples_per_object);
  for (const OfferedObject& object : objects_) {
    settings.interests.push_back(object.direction);
  }
  reference_ = reference_image(tracer_, scene_key(scene_, source_), settings, workers,
                               cache_folder() / "references", progress, stop)
                   .color;
}

}  // namespace foveola::study
