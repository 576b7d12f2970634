#include "study/person/run_equipment.h"

#include <limits>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "study/preflight/preflight.h"

namespace foveola::study {
namespace {

constexpr const char* default_tracker = "pointer";
constexpr const char* headsets_tracker = "openxr";
constexpr const char* default_display = "desktop";

}  // namespace

DisplayProfile display_of(const RunSettings& settings, const Protocol& protocol) {
  if (settings.display.empty() && protocol.display.profile) {
    return *protocol.display.profile;
  }
  return read_display_profile(settings.display.empty() ? default_display : settings.display);
}

TrackerProfile tracker_of(const RunSettings& settings, const Protocol& protocol) {
  if (settings.tracker.empty() && protocol.tracker.profile) {
    return *protocol.tracker.profile;
  }
  if (!settings.tracker.empty()) {
    return read_tracker_profile(settings.tracker);
  }
  const bool is_headset = display_of(settings, protocol).kind == DisplayKind::openxr;
  return read_tracker_profile(is_headset ? headsets_tracker : default_tracker);
}

Protocol protocol_of(const RunSettings& settings) {
  Protocol protocol = load_protocol(settings.protocol);
  if (settings.gaze_filter) {
    protocol.tracker.filter = *settings.gaze_filter;
  }
  return protocol;
}

IVec2 smallest_film(const Protocol& protocol) {
  IVec2 smallest{std::numeric_limits<int>::max()};
  for (const SceneEntry& scene : protocol.scenes) {
    for (const std::string& method : protocol.methods) {
      const FilmSettings film = settings_of(protocol, scene.name, method).film;
      if (film.width < smallest.x) {
        smallest = {film.width, film.height};
      }
    }
  }
  return smallest;
}

bool is_nobodys_eye(TrackerSource source) {
  return source == TrackerSource::simulated || source == TrackerSource::recorded;
}

void require_real_gaze(const TrackerProfile& tracker, SessionKind kind) {
  if (kind == SessionKind::human && is_nobodys_eye(tracker.source)) {
    throw Error("--tracker",
                fmt::format("the gaze of profile {} is {}", tracker.name, eye_of(tracker.source)),
                "name the connected tracker, or rehearse with --pilot");
  }
}

std::vector<std::string> notes_of_eye(const TrackerProfile& tracker) {
  if (!is_nobodys_eye(tracker.source)) {
    return {};
  }
  const bool is_simulated = tracker.source == TrackerSource::simulated;
  return {fmt::format("THE EYE IS {}, by the profile {}", is_simulated ? "SIMULATED" : "RECORDED",
                      tracker.name)};
}

}  // namespace foveola::study
