#include <array>
#include <fstream>
#include <map>

#include "tests/openxr/runtime/extensions.h"
#include "tests/openxr/runtime/interaction_profiles.h"
#include "tests/openxr/runtime/names.h"
#include "tests/openxr/runtime/script.h"
#include "tests/openxr/runtime/script_part.h"

namespace foveola::test::openxr {
namespace {

SizePx size_of(const ScriptPart& part, const char* key, SizePx otherwise) {
  const auto size = part.get(key, std::array{otherwise.width, otherwise.height});
  return {size[0], size[1]};
}

glm::dvec3 vector_of(const ScriptPart& part, const char* key, const glm::dvec3& otherwise) {
  const auto v = part.get(key, std::array{otherwise.x, otherwise.y, otherwise.z});
  return {v[0], v[1], v[2]};
}

/// One of several words.
template <typename Meaning>
Meaning word_of(const ScriptPart& part, const char* key,
                const std::map<std::string, Meaning>& words) {
  const auto found = words.find(part.need<std::string>(key));
  if (found == words.end()) {
    part.fail(fmt::format("has an unknown '{}'", key));
  }
  return found->second;
}

/// Wider to the outer side than to the nose, as eyes see.
ScriptedEye plain_eye(bool is_left) {
  ScriptedEye eye;
  eye.fov_deg = is_left ? FovDeg{-46.0, 43.0, 44.0, -46.0} : FovDeg{-43.0, 46.0, 44.0, -46.0};
  eye.offset_m.x = is_left ? -0.0315 : 0.0315;
  return eye;
}

void read_mask(const ScriptPart& part, ScriptedEye& eye) {
  if (!part.has("mask")) {
    return;
  }
  const ScriptPart mask(part.value("mask"), part.where("mask"), {"vertices", "indices"});
  for (const auto& [x, y] : mask.need<std::vector<std::array<float, 2>>>("vertices")) {
    eye.mask_vertices.push_back({x, y});
  }
  eye.mask_indices = mask.need<std::vector<std::uint32_t>>("indices");
}

ScriptedEye read_eye(const ScriptPart& part, ScriptedEye eye) {
  eye.recommended_px = size_of(part, "recommended_px", eye.recommended_px);
  eye.max_px = size_of(part, "max_px", eye.max_px);
  if (part.has("fov_deg")) {
    const ScriptPart fov(part.value("fov_deg"), part.where("fov_deg"),
                         {"left", "right", "up", "down"});
    eye.fov_deg = {fov.need<double>("left"), fov.need<double>("right"), fov.need<double>("up"),
                   fov.need<double>("down")};
  }
  eye.offset_m = vector_of(part, "offset_m", eye.offset_m);
  eye.cant_deg = part.get("cant_deg", eye.cant_deg);
  read_mask(part, eye);
  return eye;
}

void read_eyes(const ScriptPart& part, std::array<ScriptedEye, 2>& eyes) {
  const nlohmann::json list = part.get("eyes", nlohmann::json{{}, {}});
  if (!list.is_array() || list.size() != eyes.size()) {
    part.fail("needs two 'eyes'");
  }
  for (std::size_t i = 0; i < eyes.size(); ++i) {
    const nlohmann::json& eye = list[i].is_null() ? nlohmann::json::object() : list[i];
    eyes[i] = read_eye(
        ScriptPart(eye, fmt::format("{}[{}]", part.where("eyes"), i),
                   {"recommended_px", "max_px", "fov_deg", "offset_m", "cant_deg", "mask"}),
        plain_eye(i == 0));
  }
}

HeadKey read_head_key(const ScriptPart& part) {
  return {part.need<double>("time"),
          {part.get("yaw_deg", 0.0), part.get("pitch_deg", 0.0), part.get("roll_deg", 0.0)},
          vector_of(part, "position_m", glm::dvec3(0.0))};
}

GazeKey read_gaze_key(const ScriptPart& part) {
  return {part.need<double>("time"), part.get("yaw_deg", 0.0), part.get("pitch_deg", 0.0)};
}

Interval read_interval(const ScriptPart& part) {
  return {part.need<double>("from"), part.get("to", std::numeric_limits<double>::infinity())};
}

GazeGapInterval read_gaze_gap(const ScriptPart& part) {
  return {read_interval(part),
          word_of<GazeGap>(
              part, "kind",
              {{"blink", GazeGap::blink}, {"invalid", GazeGap::invalid}, {"lost", GazeGap::lost}})};
}

SampleTimeStep read_sample_time(const ScriptPart& part) {
  return {part.get("time", 0.0),
          word_of<SampleTime>(part, "policy",
                              {{"true", SampleTime::truthful},
                               {"zero", SampleTime::zero},
                               {"future", SampleTime::future},
                               {"stuck", SampleTime::stuck}}),
          part.get("delay_ms", 0.0)};
}

InputStep read_input(const ScriptPart& part) {
  InputStep step{part.need<double>("time"), part.need<std::string>("path")};
  if (part.has("xy")) {
    const auto xy = part.get("xy", std::array<float, 2>{});
    step.value = {xy[0], xy[1]};
  } else if (part.has("value")) {
    step.value.x = part.get("value", 0.0F);
  } else {
    step.value.x = part.need<bool>("pressed") ? 1.0F : 0.0F;
  }
  return step;
}

ScriptedEvent read_event(const ScriptPart& part) {
  ScriptedEvent event;
  event.time_s = part.need<double>("time");
  event.kind = word_of<EventKind>(part, "event",
                                  {{"recentre", EventKind::recentre},
                                   {"focus_lost", EventKind::focus_lost},
                                   {"focus_gained", EventKind::focus_gained},
                                   {"hidden", EventKind::hidden},
                                   {"shown", EventKind::shown},
                                   {"taken_off", EventKind::taken_off},
                                   {"put_on", EventKind::put_on},
                                   {"session_loss", EventKind::session_loss},
                                   {"instance_loss", EventKind::instance_loss},
                                   {"session_lost", EventKind::session_lost},
                                   {"exit", EventKind::exit},
                                   {"restart", EventKind::restart}});
  event.name = part.need<std::string>("event");
  event.session = part.get("session", 1);
  event.pose =
      turned({part.get("yaw_deg", 0.0), 0.0, 0.0}, vector_of(part, "position_m", glm::dvec3(0.0)));
  event.after_s = part.get("after_s", 0.0);
  return event;
}

ScriptedFailure read_failure(const ScriptPart& part) {
  ScriptedFailure failure;
  failure.function = part.need<std::string>("function");
  const std::optional<XrResult> result = result_of_name(part.need<std::string>("result"));
  if (!result) {
    part.fail("has a 'result' that OpenXR does not know");
  }
  failure.result = *result;
  if (part.has("time")) {
    failure.time_s = part.need<double>("time");
  }
  failure.times = part.get("times", failure.times);
  return failure;
}

std::vector<std::int64_t> read_formats(const ScriptPart& part) {
  const std::map<std::string, std::int64_t> known = {
      {"GL_SRGB8_ALPHA8", GL_SRGB8_ALPHA8},
      {"GL_RGBA8", GL_RGBA8},
      {"GL_RGBA16F", GL_RGBA16F},
      {"GL_DEPTH_COMPONENT24", GL_DEPTH_COMPONENT24}};
  std::vector<std::int64_t> formats;
  for (const std::string& name : part.get(
           "swapchain_formats", std::vector<std::string>{"GL_SRGB8_ALPHA8", "GL_RGBA8",
                                                         "GL_RGBA16F", "GL_DEPTH_COMPONENT24"})) {
    if (!known.contains(name)) {
      part.fail("has an unknown format in 'swapchain_formats'");
    }
    formats.push_back(known.at(name));
  }
  return formats;
}

template <typename Timed>
void require_order(const ScriptPart& part, const char* key, const std::vector<Timed>& items) {
  if (!std::is_sorted(items.begin(), items.end(),
                      [](const Timed& a, const Timed& b) { return a.time_s < b.time_s; })) {
    part.fail(fmt::format("has '{}' that are not in the order of their times", key));
  }
}

void read_headset(const ScriptPart& part, Script& script) {
  script.system_name = part.get("system_name", script.system_name);
  script.refresh_hz = part.get("refresh_hz", script.refresh_hz);
  if (!(script.refresh_hz > 0.0)) {
    part.fail("needs a positive 'refresh_hz'");
  }
  script.is_real_time = part.get("real_time", script.is_real_time);
  script.extensions = part.get("extensions", known_extensions());
  script.interaction_profiles =
      part.get("interaction_profiles",
               std::vector<std::string>{"/interaction_profiles/khr/simple_controller",
                                        "/interaction_profiles/microsoft/xbox_controller"});
  for (const std::string& profile : script.interaction_profiles) {
    if (sources_of(profile).empty()) {
      part.fail(fmt::format("has an unknown one of 'interaction_profiles': {}", profile));
    }
  }
  script.has_eye_tracker = part.get("eye_tracking", script.has_eye_tracker);
  read_eyes(part, script.eyes);
  script.max_swapchain_px = size_of(part, "max_swapchain_px", script.max_swapchain_px);
  script.swapchain_formats = read_formats(part);
  script.eye_height_m = part.get("eye_height_m", script.eye_height_m);
}

void read_wearer(const ScriptPart& part, Script& script) {
  script.head =
      part.list("head", {"time", "yaw_deg", "pitch_deg", "roll_deg", "position_m"}, read_head_key);
  script.head_gaps = part.list("head_gaps", {"from", "to"}, read_interval);
  script.gaze = part.list("gaze", {"time", "yaw_deg", "pitch_deg"}, read_gaze_key);
  script.gaze_gaps = part.list("gaze_gaps", {"from", "to", "kind"}, read_gaze_gap);
  script.gaze_sample_times =
      part.list("gaze_sample_time", {"time", "policy", "delay_ms"}, read_sample_time);
  script.inputs = part.list("inputs", {"time", "path", "pressed", "value", "xy"}, read_input);
  require_order(part, "head", script.head);
  require_order(part, "gaze", script.gaze);
  require_order(part, "gaze_sample_time", script.gaze_sample_times);
  require_order(part, "inputs", script.inputs);
}

void read_happenings(const ScriptPart& part, Script& script) {
  script.events = part.list(
      "events", {"time", "event", "session", "yaw_deg", "position_m", "after_s"}, read_event);
  require_order(part, "events", script.events);
  script.no_render = part.list("no_render", {"from", "to"}, read_interval);
  script.failures = part.list("failures", {"function", "result", "time", "times"}, read_failure);
  script.save_frames = part.get("save_frames", script.save_frames);
}

}  // namespace

Script read_script(const std::filesystem::path& file) {
  nlohmann::json content = nlohmann::json::object();
  if (!file.empty()) {
    std::ifstream stream(file);
    if (!stream) {
      throw std::runtime_error(fmt::format("the script: {} cannot be read", file.string()));
    }
    content = nlohmann::json::parse(stream);
  }
  const ScriptPart part(content, "it",
                        {"starts_with",
                         "system_name",
                         "refresh_hz",
                         "real_time",
                         "extensions",
                         "interaction_profiles",
                         "eye_tracking",
                         "eyes",
                         "head",
                         "head_gaps",
                         "max_swapchain_px",
                         "swapchain_formats",
                         "eye_height_m",
                         "gaze",
                         "gaze_gaps",
                         "gaze_sample_time",
                         "inputs",
                         "events",
                         "no_render",
                         "failures",
                         "save_frames"});
  Script script;
  script.starts_with = part.get("starts_with", std::string());
  read_headset(part, script);
  read_wearer(part, script);
  read_happenings(part, script);
  return script;
}

}  // namespace foveola::test::openxr
