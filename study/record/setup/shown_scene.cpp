#include "study/record/setup/shown_scene.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/files/digest.h"
#include "study/record/log/json_member.h"

namespace foveola::study {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Vec2& v) { return Json::array({v.x, v.y}); }
Json json_of(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }
Json json_of(const AzimuthElevation& place) {
  return {{"azimuth_rad", place.azimuth_rad}, {"elevation_rad", place.elevation_rad}};
}

template <typename Value>
Json json_of(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

Json json_of(const RectangleLight& light) {
  return {{"center", json_of(light.center)},
          {"size", json_of(light.size)},
          {"normal", json_of(light.normal)},
          {"radiance", json_of(light.radiance)}};
}

Json json_of(const Sun& sun) {
  Json json = json_of(sun.place);
  json["irradiance"] = json_of(sun.irradiance);
  json["angular_radius_rad"] = sun.angular_radius_rad;
  return json;
}

Json json_of(const ObjectOfInterest& object) {
  return {{"name", object.name},
          {"position", json_of(object.position)},
          {"radius_deg", object.radius_deg}};
}

template <typename Item>
Json json_of(const std::vector<Item>& items) {
  Json json = Json::array();
  for (const Item& item : items) {
    json.push_back(json_of(item));
  }
  return json;
}

Json environment_of(const SceneSource& source) {
  if (source.environment_radiance) {
    return {{"radiance", json_of(*source.environment_radiance)}};
  }
  if (source.environment_file) {
    return {{"file_name", source.environment_file->filename().string()},
            {"file_sha256", sha256_of_file(*source.environment_file)}};
  }
  if (source.sky) {
    return {{"sun", json_of(source.sky->sun)},
            {"turbidity", source.sky->turbidity},
            {"ground_albedo", source.sky->ground_albedo}};
  }
  return {};
}

Json added_to(const SceneSource& source) {
  Json added = {{"metres_per_unit", source.metres_per_unit},
                {"environment", environment_of(source)},
                {"environment_rotation_rad", source.environment_rotation_rad},
                {"environment_strength", source.environment_strength},
                {"light_radius_m", json_of(source.light_radius_m)},
                {"sun_angular_radius_rad", json_of(source.sun_angular_radius_rad)},
                {"lights", json_of(source.lights)},
                {"suns", json_of(source.suns)}};
  if (source.light_units) {
    added["light_units"] =
        *source.light_units == LightUnits::photometric ? "photometric" : "radiometric";
  }
  if (source.time_s) {
    added["time_s"] = *source.time_s;
  }
  if (!source.clip.empty()) {
    added["clip"] = source.clip;
  }
  return added;
}

Json camera_of(const SceneSource& source) {
  Json camera = {{"position", source.camera_position ? json_of(*source.camera_position) : Json()}};
  camera.update(json_of(source.heading));
  return camera;
}

std::optional<Vec3> position_in(const Json& json) {
  const Json position = member_or_null(json, "position");
  return has_numbers(position, 3)
             ? std::optional(Vec3(position[0].get<float>(), position[1].get<float>(),
                                  position[2].get<float>()))
             : std::nullopt;
}

/// On one line. Names may hold what is no Unicode.
std::string text_of(const Json& json) {
  constexpr int on_one_line = -1;
  return json.dump(on_one_line, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string shown_as(const SceneSource& source) {
  return text_of({{"camera", camera_of(source)},
                  {"exposure_stops", source.exposure_stops.value_or(0.0)},
                  {"objects", json_of(source.objects)},
                  {"added", added_to(source)}});
}

std::string added_to_file(const SceneSource& source) { return text_of(added_to(source)); }

Vec3 direction_of(const ObjectOfInterest& object, const Vec3& viewpoint) {
  return glm::normalize(object.position - viewpoint);
}

std::optional<SeenObject> object_in(const std::string& shown_as, const std::string& name) {
  const Json shown = parse_json(shown_as);
  const std::optional<Vec3> viewpoint = position_in(member_or_null(shown, "camera"));
  for (const Json& entry : member_or_null(shown, "objects")) {
    const std::optional<Vec3> position = position_in(entry);
    const Json radius = member_or_null(entry, "radius_deg");
    if (member_or_null(entry, "name") == name && viewpoint && position && *position != *viewpoint &&
        radius.is_number()) {
      return SeenObject{.direction = direction_of({.position = *position}, *viewpoint),
                        .radius_deg = radius.get<double>()};
    }
  }
  return std::nullopt;
}

std::string difference(const std::string& recorded, const std::string& now) {
  const Json before = parse_json(recorded);
  const Json after = Json::parse(now);
  if (!before.is_object()) {
    return fmt::format("{}, now {}", recorded, now);
  }
  const Json steps = Json::diff(before, after);
  if (steps.empty()) {
    return {};
  }
  const Json::json_pointer place(steps[0]["path"].get<std::string>());
  const auto value = [&](const Json& json) {
    return json.contains(place) ? text_of(json.at(place)) : "nothing";
  };
  return fmt::format("{}: {}, now {}", place.to_string().substr(1), value(before), value(after));
}

}  // namespace foveola::study
