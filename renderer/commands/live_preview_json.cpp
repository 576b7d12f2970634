#include "renderer/commands/live_preview_json.h"

#include <utility>

namespace foveola {

using Json = nlohmann::ordered_json;

Json late_frames(const LivePreviewReport& report) {
  Json late = Json::array();
  const std::uint64_t first = report.frame_count - report.frames.size();
  for (std::size_t i = 0; i < report.frames.size(); ++i) {
    if (report.frames[i].is_late()) {
      late.push_back({{"frame", first + i}, {"refreshes", report.frames[i].missed_refreshes}});
    }
  }
  return late;
}

Json gaze_checks(const LivePreviewReport& report) {
  Json checks = Json::array();
  const auto row = [](const DVec3& weights) { return Json{weights.x, weights.y, weights.z}; };
  for (const GazeCheck& check : report.gaze_checks) {
    Json json = {{"data_loss", check.quality.data_loss}};
    if (const auto& figures = check.quality.figures) {
      json["accuracy_deg"] = figures->accuracy_deg;
      json["precision_rms_deg"] = figures->precision_rms_deg;
      json["precision_sd_deg"] = figures->precision_sd_deg;
    }
    if (check.correction) {
      json["correction"] = {{"azimuth", row(check.correction->azimuth)},
                            {"elevation", row(check.correction->elevation)}};
    }
    checks.push_back(std::move(json));
  }
  return checks;
}

Json shown_changes(const LivePreviewReport& report) {
  Json changes = Json::array();
  for (const ShownChange& change : report.changes) {
    changes.push_back(
        {{"is_refused", change.is_refused}, {"seconds_to_first_frame", seconds(change.after)}});
  }
  return changes;
}

Json slow_drawing(const LivePreviewReport& report) {
  if (!report.slow_drawing) {
    return nullptr;
  }
  constexpr double ms_per_s = 1e3;
  const SlowDrawing& slow = *report.slow_drawing;
  return {{"drawing_ms", ms_per_s * seconds(slow.drawing)},
          {"refresh_interval_ms", ms_per_s * seconds(slow.interval)},
          {"window", {slow.framebuffer.x, slow.framebuffer.y}}};
}

Json headset_changes(const LivePreviewReport& report) {
  Json changes = Json::array();
  for (const HeadsetChange change : report.headset_changes) {
    changes.push_back(words_for(change));
  }
  return changes;
}

}  // namespace foveola
