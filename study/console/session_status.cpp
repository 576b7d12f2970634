#include "study/console/session_status.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/transformed.h"

namespace foveola::study {
namespace {

constexpr double ms_per_s = 1e3;

nlohmann::ordered_json json_of(const FrameStatus& frames) {
  nlohmann::ordered_json json = {{"rate_hz", nullptr},
                                 {"refresh_rate_hz", frames.refresh_rate_hz},
                                 {"frames", frames.frames},
                                 {"late", frames.late}};
  if (frames.rate_hz) {
    json["rate_hz"] = *frames.rate_hz;
  }
  return json;
}

nlohmann::ordered_json json_of(const GazeStatus& gaze) {
  nlohmann::ordered_json json = {{"eye", gaze.eye}, {"valid", nullptr}, {"age_s", nullptr}};
  if (gaze.valid) {
    json["valid"] = *gaze.valid;
  }
  if (gaze.age_s) {
    json["age_s"] = *gaze.age_s;
  }
  return json;
}

/// Any substitute for a person's eye must not be overlooked.
std::string in_large_letters(const std::string& eye) {
  if (eye == "pointer") {
    return "THE MOUSE POINTER REPLACES THE EYE";
  }
  if (eye == "simulated") {
    return "THE EYE IS SIMULATED";
  }
  return eye == "recorded" ? "THE EYE IS RECORDED" : eye;
}

}  // namespace

const char* name_of(WarningKind kind) {
  switch (kind) {
    case WarningKind::no_focus:
      return "no_focus";
    case WarningKind::no_key:
      return "no_key";
    case WarningKind::awaits_gaze:
      return "awaits_gaze";
    case WarningKind::no_gaze:
      return "no_gaze";
    case WarningKind::late_frames:
      return "late_frames";
    case WarningKind::slow_drawing:
      return "slow_drawing";
    case WarningKind::slow_record:
      break;
  }
  return "slow_record";
}

std::string words_for(const FrameStatus& frames) {
  std::string words = frames.rate_hz ? fmt::format("{:.1f} a second of {:.4g}", *frames.rate_hz,
                                                   frames.refresh_rate_hz)
                                     : "measuring";
  if (frames.frames > 0) {
    words += fmt::format("; {} of {} late in this trial", frames.late, frames.frames);
  }
  return words;
}

std::string words_for(const GazeStatus& gaze) {
  std::string words = in_large_letters(gaze.eye) + "; ";
  words += gaze.valid ? fmt::format("{:.0f} % valid", 100.0 * *gaze.valid) : "no samples";
  if (gaze.age_s) {
    words += *gaze.age_s < 1.0 ? fmt::format(", the newest {:.0f} ms old", ms_per_s * *gaze.age_s)
                               : fmt::format(", the newest {:.0f} s old", *gaze.age_s);
  }
  return words;
}

std::optional<StatusWarning> warning_of(const FrameStatus& frames) {
  constexpr double max_late = 0.01;
  // A single late frame says nothing about the machine.
  constexpr std::uint64_t fewest = 3;
  if (frames.late < fewest ||
      static_cast<double>(frames.late) <= max_late * static_cast<double>(frames.frames)) {
    return std::nullopt;
  }
  return StatusWarning{
      WarningKind::late_frames,
      fmt::format("{} of this trial's {} frames missed their refresh. The machine is too slow for "
                  "this window, or busy: pause, and check for other programs.",
                  frames.late, frames.frames)};
}

std::optional<StatusWarning> warning_of(Nanoseconds since_last_key) {
  constexpr std::chrono::minutes longest(3);
  if (since_last_key < longest) {
    return std::nullopt;
  }
  return StatusWarning{
      WarningKind::no_key,
      fmt::format("The participant has not pressed a key for {} minutes. Ask whether all is well.",
                  std::chrono::duration_cast<std::chrono::minutes>(since_last_key).count())};
}

std::vector<StatusWarning> new_warnings(const std::vector<StatusWarning>& before,
                                        const std::vector<StatusWarning>& now) {
  std::vector<StatusWarning> all;
  std::ranges::copy_if(now, std::back_inserter(all), [&](const StatusWarning& one) {
    return std::ranges::none_of(
        before, [&](const StatusWarning& former) { return former.kind == one.kind; });
  });
  return all;
}

nlohmann::ordered_json json_of(const SessionStatus& status) {
  const nlohmann::ordered_json warnings(
      transformed(status.warnings, [&](const StatusWarning& warning) {
        return nlohmann::ordered_json{{"kind", name_of(warning.kind)}, {"text", warning.text}};
      }));
  return {{"participant", status.participant},
          {"time_s", seconds(status.time)},
          {"paused", status.is_paused},
          {"now", status.now},
          {"then", status.then},
          {"next_key", status.next_key},
          {"frames", json_of(status.frames)},
          {"gaze", json_of(status.gaze)},
          {"last_mark", status.last_mark},
          {"warnings", warnings}};
}

}  // namespace foveola::study
