#include "study/person/devices/session_window.h"

#include <nlohmann/json.hpp>

#include "renderer/base/build_info.h"
#include "renderer/window/x_display.h"
#include "study/person/devices/source_commit.h"
#include "study/person/forms/words.h"
#include "study/preflight/system_state.h"
#include "study/record/log/gaze_filter_json.h"

namespace foveola::study {
namespace {

template <typename Value>
nlohmann::ordered_json json_of(const std::optional<Value>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

nlohmann::ordered_json json_of(const MeasuredDisplay& measured) {
  return {{"date", measured.date},
          {"instrument", measured.instrument},
          {"white_cd_m2", json_of(measured.white_cd_m2)},
          {"black_cd_m2", json_of(measured.black_cd_m2)},
          {"gamma", json_of(measured.gamma)},
          {"refresh_rate_hz", json_of(measured.refresh_rate_hz)}};
}

constexpr int frames_to_measure = RefreshEstimator::enough_swaps + 8;

}  // namespace

void measure_refreshes(SessionDisplay& display, const Texts& texts, const std::stop_token& stop) {
  for (int i = 0; i < frames_to_measure && !stop.stop_requested(); ++i) {
    display.show({.screen = notice_screen(Notice::loading, texts)});
  }
}

nlohmann::ordered_json display_json(const SessionDisplay& display, const DisplayProfile& profile) {
  const ViewGeometry& geometry = display.geometry();
  const RadialLens& lens = geometry.lens;
  nlohmann::ordered_json json = {
      {"profile", profile.name},
      {"framebuffer", {display.framebuffer().x, display.framebuffer().y}},
      {"horizontal_fov_deg", geometry.horizontal_fov_deg},
      {"vertical_fov_deg", geometry.vertical_fov_deg},
      {"lens", {lens.axis.x, lens.axis.y, lens.k1, lens.k2}},
      {"refresh_rate_hz", display.refresh().rate_hz()},
      {"refresh_is_measured", display.refresh().is_measured()},
      {"graphics", display.graphics()}};
  if (profile.width_m > 0.0) {
    constexpr double mm_per_m = 1e3;
    json["size_mm"] = {mm_per_m * profile.width_m, mm_per_m * profile.height_m};
    json["distance_mm"] = mm_per_m * profile.viewing_distance_m;
  }
  if (geometry.seen) {
    json["seen"] = geometry.seen->rows();
  }
  if (profile.measured) {
    json["measured"] = json_of(*profile.measured);
  }
  if (const std::optional<TimingPatch>& patch = display.timing_patch()) {
    json["timing_patch"] = {{"corner", name_of(patch->corner)}, {"size_px", patch->size_px}};
  }
  return json;
}

nlohmann::ordered_json machine_json(int threads) {
  const MachineInfo machine = machine_info();
  const DesktopFacts desktop = desktop_facts();
  return {{"processor", machine.processor},
          {"cores", machine.cores},
          {"threads", threads},
          {"operating_system", machine.system},
          {"governor", cpu_governor()},
          {"windows", desktop.windows},
          {"keyboard_layout", desktop.keyboard_layout},
          {"program", program_name(build_info())},
          {"commit", source_commit()}};
}

nlohmann::ordered_json headset_json(const HeadsetFacts& facts) {
  nlohmann::ordered_json eyes = nlohmann::ordered_json::array();
  for (std::size_t eye = 0; eye < facts.eyes.size(); ++eye) {
    const FieldOfView& seen = facts.eyes[eye];
    eyes.push_back({{"picture_px", {facts.eye_px[eye].x, facts.eye_px[eye].y}},
                    {"horizontal_fov_deg", seen.horizontal_deg},
                    {"vertical_fov_deg", seen.vertical_deg},
                    {"axis", {seen.lens.axis.x, seen.lens.axis.y}},
                    {"outwards_deg", facts.cant_deg(eye)}});
  }
  return {{"name", facts.headset},
          {"runtime", facts.runtime},
          {"has_eye_tracker", facts.has_eye_tracker},
          {"display_delay_ms", 1e3 * seconds(facts.display_delay)},
          {"eyes", std::move(eyes)}};
}

nlohmann::ordered_json tracker_json(const std::string& profile, const GazeFilterSettings& filter) {
  nlohmann::ordered_json json = {{"profile", profile}};
  if (filter != GazeFilterSettings{}) {
    json["filter"] = json_of(filter);
  }
  return json;
}

}  // namespace foveola::study
