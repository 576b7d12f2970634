// What a good machine shows before a session.
#pragma once

#include "study/preflight/preflight.h"

namespace foveola::test {

inline DisplayProfile stated_monitor() {
  return {.name = "desk",
          .kind = DisplayKind::monitor,
          .width_px = 1920,
          .height_px = 1080,
          .refresh_rate_hz = 60.0,
          .width_m = 0.5313,
          .height_m = 0.2989,
          .viewing_distance_m = 0.6};
}

inline study::FoundDisplay found_monitor() {
  return {.window_px = {1280, 720},
          .monitor_px = {1920, 1080},
          .monitor_width_m = 0.53,
          .refresh_rate_hz = 59.9};
}

inline study::Preflight good_preflight() {
  return {.speeds = {{.scene = "hall",
                      .method = "od",
                      .frames = 60,
                      .late = 0,
                      .duration_s = 1.0,
                      .samples = 1'000'000},
                     {.scene = "hall",
                      .method = "fv",
                      .frames = 60,
                      .late = 0,
                      .duration_s = 1.0,
                      .samples = 800'000}},
          .tracker = {.name = "camera", .source = TrackerSource::hid, .rate_hz = 120.0},
          .gaze = {.samples = 240, .valid = 230, .duration_s = 2.0, .median_age_s = 0.012},
          .display = stated_monitor(),
          .found_display = found_monitor(),
          .film_px = {2048, 1024},
          .free_bytes = 50'000'000'000,
          .is_clock_set = true};
}

}  // namespace foveola::test
