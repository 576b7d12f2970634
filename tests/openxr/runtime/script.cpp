#include "tests/openxr/runtime/script.h"

#include <algorithm>
#include <fstream>
#include <initializer_list>
#include <limits>
#include <map>
#include <stdexcept>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/trigonometric.hpp>
#include <nlohmann/json.hpp>
#include <openxr/openxr_reflection.h>

#include "tests/openxr/runtime/interface.h"

namespace foveola::test::openxr {
namespace {

using nlohmann::json;

/// The header's list is a macro that takes a macro for each of its items.
const std::map<std::string, XrResult>& results() {
#define FOVEOLA_NAME_AND_VALUE(name, value) {#name, name},
  static const std::map<std::string, XrResult> all = {
      XR_LIST_ENUM_XrResult(FOVEOLA_NAME_AND_VALUE)};
#undef FOVEOLA_NAME_AND_VALUE
  return all;
}

/// An object of no other keys.
const json& checked(const json& object, std::initializer_list<std::string_view> keys) {
  for (const auto& [key, value] : object.items()) {
    if (std::ranges::find(keys, key) == keys.end()) {
      throw std::runtime_error(fmt::format("the script: key '{}' means nothing", key));
    }
  }
  return object;
}

template <typename Item>
std::vector<Item> read_list(const json& script, const char* key,
                            std::initializer_list<std::string_view> keys,
                            Item (*read)(const json& object)) {
  std::vector<Item> items;
  for (const json& object : script.value(key, json::array())) {
    items.push_back(read(checked(object, keys)));
  }
  return items;
}

bool is_first_word(const json& object, const char* key, const char* first, const char* second) {
  const std::string word = object.at(key);
  if (word != first && word != second) {
    throw std::runtime_error(fmt::format("the script: '{}' is not a {}", word, key));
  }
  return word == first;
}

ScriptedEye read_eye(const json& eye, bool is_left) {
  checked(eye, {"recommended_px", "fov_deg", "offset_m", "cant_deg", "mask"});
  const auto size = eye.value("recommended_px", std::array{640U, 720U});
  // Eyes see farther to their own side than to the nose.
  const json fov = eye.value("fov_deg", json{{"left", is_left ? -46.0 : -43.0},
                                             {"right", is_left ? 43.0 : 46.0},
                                             {"up", 44.0},
                                             {"down", -46.0}});
  const auto side = [&](const char* key) { return glm::radians(fov.at(key).get<float>()); };
  const auto offset = eye.value("offset_m", std::array{is_left ? -0.0315 : 0.0315, 0.0, 0.0});
  ScriptedEye read{.width_px = size[0],
                   .height_px = size[1],
                   .fov = {side("left"), side("right"), side("up"), side("down")},
                   .offset_m = {offset[0], offset[1], offset[2]},
                   .cant_deg = eye.value("cant_deg", 0.0)};
  if (eye.contains("mask")) {
    const json& mask = checked(eye.at("mask"), {"vertices", "indices"});
    for (const auto& [x, y] : mask.at("vertices").get<std::vector<std::array<float, 2>>>()) {
      read.mask_vertices.push_back({x, y});
    }
    read.mask_indices = mask.at("indices").get<std::vector<std::uint32_t>>();
  }
  return read;
}

TurnKey read_turn(const json& key) {
  return {key.at("time"),
          {key.value("yaw_deg", 0.0), key.value("pitch_deg", 0.0), key.value("roll_deg", 0.0)}};
}

GazeGap read_gap(const json& gap) {
  return {gap.at("from"), gap.at("to"), is_first_word(gap, "kind", "blink", "lost")};
}

SampleTimeStep read_sample_time(const json& step) {
  return {step.at("time"), is_first_word(step, "policy", "true", "zero"),
          1e-3 * step.value("delay_ms", 0.0)};
}

InputStep read_input(const json& input) {
  InputStep step{input.at("time"), input.at("path")};
  if (input.contains("xy")) {
    step.value = {input["xy"].at(0), input["xy"].at(1)};
  } else {
    step.value.x = input.at("pressed").get<bool>() ? 1.0F : 0.0F;
  }
  return step;
}

ScriptedEvent read_event(const json& event) {
  return {event.at("time"), event.at("event"), event.value("session", 1),
          event.value("yaw_deg", 0.0)};
}

ScriptedFailure read_failure(const json& failure) {
  return {failure.at("function"), results().at(failure.at("result")), failure.value("time", -1.0),
          failure.value("times", std::numeric_limits<int>::max())};
}

Turn turn_at(const std::vector<TurnKey>& keys, double time_s) {
  if (keys.empty()) {
    return {};
  }
  const auto after = std::ranges::upper_bound(keys, time_s, {}, &TurnKey::time_s);
  if (after == keys.begin() || after == keys.end()) {
    return (after == keys.begin() ? keys.front() : keys.back()).turn;
  }
  const auto& [from_s, from] = *std::prev(after);
  const auto& [to_s, to] = *after;
  const double share = (time_s - from_s) / (to_s - from_s);
  return {glm::mix(from.yaw_deg, to.yaw_deg, share), glm::mix(from.pitch_deg, to.pitch_deg, share),
          glm::mix(from.roll_deg, to.roll_deg, share)};
}

}  // namespace

std::vector<std::string> known_extensions() {
  return {XR_KHR_OPENGL_ENABLE_EXTENSION_NAME, XR_EXT_EYE_GAZE_INTERACTION_EXTENSION_NAME,
          XR_KHR_CONVERT_TIMESPEC_TIME_EXTENSION_NAME, XR_KHR_VISIBILITY_MASK_EXTENSION_NAME,
#ifdef XR_EXT_user_presence
          XR_EXT_USER_PRESENCE_EXTENSION_NAME
#endif
  };
}

Script read_script(const std::filesystem::path& file) {
  std::ifstream stream(file);
  const json object = json::parse(stream);
  checked(object, {"starts_with", "system_name", "refresh_hz", "real_time", "extensions",
                   "interaction_profiles", "eyes", "head", "gaze", "gaze_gaps", "gaze_sample_time",
                   "inputs", "events", "failures", "save_pictures"});
  const json eyes = object.value("eyes", json{json::object(), json::object()});
  return {
      .starts_with = object.value("starts_with", std::string()),
      .system_name = object.value("system_name", std::string("Test headset")),
      .refresh_hz = object.value("refresh_hz", 90.0),
      .is_real_time = object.value("real_time", true),
      .extensions = object.value("extensions", known_extensions()),
      .interaction_profiles =
          object.value("interaction_profiles",
                       std::vector<std::string>{"/interaction_profiles/khr/simple_controller",
                                                "/interaction_profiles/microsoft/xbox_controller"}),
      .eyes = {read_eye(eyes.at(0), true), read_eye(eyes.at(1), false)},
      .head = read_list(object, "head", {"time", "yaw_deg", "pitch_deg", "roll_deg"}, read_turn),
      .gaze = read_list(object, "gaze", {"time", "yaw_deg", "pitch_deg"}, read_turn),
      .gaze_gaps = read_list(object, "gaze_gaps", {"from", "to", "kind"}, read_gap),
      .gaze_sample_times =
          read_list(object, "gaze_sample_time", {"time", "policy", "delay_ms"}, read_sample_time),
      .inputs = read_list(object, "inputs", {"time", "path", "pressed", "xy"}, read_input),
      .events = read_list(object, "events", {"time", "event", "session", "yaw_deg"}, read_event),
      .failures =
          read_list(object, "failures", {"function", "result", "time", "times"}, read_failure),
      .saves_pictures = object.value("save_pictures", false)};
}

std::string result_name(XrResult result) {
  const auto found =
      std::ranges::find(results(), result, [](const auto& named) { return named.second; });
  return found == results().end() ? std::to_string(result) : found->first;
}

Pose Script::head_at(double time_s) const { return {rotation(turn_at(head, time_s))}; }

Pose Script::gaze_at(double time_s) const {
  const std::optional<GazeGap> gap = gaze_gap_at(time_s);
  return {rotation(turn_at(gaze, gap ? gap->from_s : time_s))};
}

std::optional<GazeGap> Script::gaze_gap_at(double time_s) const {
  const auto found = std::ranges::find_if(
      gaze_gaps, [&](const GazeGap& gap) { return time_s >= gap.from_s && time_s < gap.to_s; });
  return found == gaze_gaps.end() ? std::nullopt : std::optional(*found);
}

SampleTimeStep Script::sample_time_at(double time_s) const {
  SampleTimeStep latest;
  for (const SampleTimeStep& step : gaze_sample_times) {
    latest = step.time_s <= std::max(time_s, 0.0) ? step : latest;
  }
  return latest;
}

XrVector2f Script::input_at(const std::string& path, double time_s) const {
  XrVector2f latest{0.0F, 0.0F};
  for (const InputStep& step : inputs) {
    latest = step.path == path && step.time_s <= time_s ? step.value : latest;
  }
  return latest;
}

}  // namespace foveola::test::openxr
