#include "study/record/setup/session_devices.h"

#include <array>
#include <string_view>

#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "study/record/log/json_member.h"

namespace foveola::study {
namespace {

constexpr std::string_view going_on = "goes on with ";

struct RendererField {
  const char* key;
  std::string BuildInfo::* text;
};
constexpr std::array renderer_fields{
    RendererField{"ray_tracer", &BuildInfo::ray_tracer},
    RendererField{"instruction_set", &BuildInfo::instruction_set},
    RendererField{"ray_instructions", &BuildInfo::ray_instructions},
};

/// Null if all is seen. Throws Error for one that there cannot be.
std::shared_ptr<const SeenPart> seen_part_in(const nlohmann::ordered_json& display) {
  const nlohmann::ordered_json seen = member_or_null(display, "seen");
  if (seen.is_null()) {
    return nullptr;
  }
  std::vector<std::string> rows;
  for (const nlohmann::ordered_json& row : seen.is_array() ? seen : nlohmann::ordered_json()) {
    rows.push_back(row.is_string() ? row.get<std::string>() : "");
  }
  return std::make_shared<const SeenPart>(std::move(rows));
}

}  // namespace

std::optional<FieldOfView> field_of_view_in(const std::string& devices) {
  const nlohmann::ordered_json display = member_or_null(parse_json(devices), "display");
  const nlohmann::ordered_json horizontal = member_or_null(display, "horizontal_fov_deg");
  const nlohmann::ordered_json vertical = member_or_null(display, "vertical_fov_deg");
  if (!horizontal.is_number() || !vertical.is_number()) {
    return std::nullopt;
  }
  FieldOfView view{.horizontal_deg = horizontal.get<double>(),
                   .vertical_deg = vertical.get<double>()};
  if (const auto lens = member_or_null(display, "lens"); !lens.is_null()) {
    if (!has_numbers(lens, 4)) {
      return std::nullopt;
    }
    view.lens = {.axis = {lens[0].get<float>(), lens[1].get<float>()},
                 .k1 = lens[2].get<float>(),
                 .k2 = lens[3].get<float>()};
  }
  try {
    view.seen = seen_part_in(display);
    const Viewport shown(AzimuthElevation{}, view);
  } catch (const Error&) {
    return std::nullopt;
  }
  return view;
}

std::string tracker_in(const std::string& devices) {
  const nlohmann::ordered_json profile =
      member_or_null(member_or_null(parse_json(devices), "tracker"), "profile");
  return profile.is_string() ? profile.get<std::string>() : "";
}

bool is_experimenter_blind(const std::string& devices) {
  return member_or_null(parse_json(devices), "experimenter_is_blind") == true;
}

BuildInfo with_renderer_in(const std::string& devices, BuildInfo build) {
  const nlohmann::ordered_json renderer = member_or_null(parse_json(devices), "renderer");
  for (const auto& [key, text] : renderer_fields) {
    const nlohmann::ordered_json value = member_or_null(renderer, key);
    build.*text = value.is_string() ? value.get<std::string>() : "";
  }
  return build;
}

std::string with_renderer(const std::string& devices, const BuildInfo& build) {
  nlohmann::ordered_json json = parse_json(devices);
  for (const auto& [key, text] : renderer_fields) {
    if (!(build.*text).empty()) {
      json["renderer"][key] = build.*text;
    }
  }
  return json.dump();
}

std::string note_of_devices(const std::string& devices) { return std::string(going_on) + devices; }

std::optional<std::string> devices_in_note(const std::string& note) {
  if (!note.starts_with(going_on)) {
    return std::nullopt;
  }
  std::string devices = note.substr(going_on.size());
  return parse_json(devices).is_object() ? std::optional(std::move(devices)) : std::nullopt;
}

}  // namespace foveola::study
