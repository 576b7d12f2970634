#include "study/person/preflight_measurement.h"

#include <algorithm>
#include <chrono>
#include <future>
#include <variant>

#include "renderer/base/error.h"
#include "renderer/base/numbers/quantile.h"
#include "renderer/headset/live_window.h"
#include "study/person/forms/words.h"
#include "study/person/session/live_attempt.h"

namespace foveola::study {
namespace {

using namespace std::chrono_literals;

constexpr Nanoseconds all_trials = 8s;
constexpr Nanoseconds shortest_trial = 400ms;
constexpr Nanoseconds longest_trial = 1s;
/// Lasts until the number of samples per frame has settled.
constexpr Nanoseconds warming_up = 250ms;

/// Discards everything: the measurement is not a session.
class NoRecorder final : public SessionRecorder {
 public:
  std::future<void> record(SessionEntry /*entry*/) override { return already_recorded(); }
};

/// Accumulates over frames.
class Measurement {
 public:
  explicit Measurement(const PreflightSubject& subject) : subject_(subject) {}

  TrialSpeed measure(const PlannedTrial& trial, Nanoseconds duration, const std::stop_token& stop) {
    TrialSpeed speed{.scene = trial.scene, .method = trial.method};
    NoRecorder recorder;
    LiveAttempt attempt(setting_of(trial, recorder));
    const Nanoseconds begin = show_for(attempt, warming_up, stop, [](const FrameRow& /*row*/) {});
    const Nanoseconds end = show_for(attempt, duration, stop, [&](const FrameRow& row) {
      ++speed.frames;
      speed.late += row.is_late ? 1 : 0;
      speed.samples += row.samples;
    });
    speed.duration_s = seconds(end - begin);
    return speed;
  }

  LiveGaze gaze() const {
    LiveGaze gaze = gaze_;
    gaze.status = subject_.eye.status();
    gaze.median_age_s = upper_median(ages_s_);
    return gaze;
  }

 private:
  AttemptSetting setting_of(const PlannedTrial& trial, SessionRecorder& recorder) {
    ScreenPage page = notice_screen(Notice::loading, subject_.protocol.texts);
    page.covers_picture = false;
    return {.protocol = subject_.protocol,
            .stage = *subject_.stages.at(trial.scene),
            .workers = subject_.workers,
            .clock = subject_.clock,
            .display = subject_.display,
            .eye = subject_.eye,
            .head = subject_.viewer.head(),
            .recorder = recorder,
            .trial = trial,
            .while_waiting = [this] { follow_window(); },
            .page = [page] { return std::optional(page); },
            .is_dark = true};
  }

  /// Returns the time at which the last frame was shown. The first frame only starts the clock.
  template <typename Counted>
  Nanoseconds show_for(LiveAttempt& attempt, Nanoseconds duration, const std::stop_token& stop,
                       const Counted& counted) {
    Nanoseconds shown = attempt.show({});
    for (const Nanoseconds begin = shown; shown - begin < duration;) {
      if (stop.stop_requested()) {
        throw Error("preflight", "stopped by the experimenter", "nothing was begun or recorded");
      }
      const Nanoseconds before = shown;
      shown = attempt.show({});
      counted(attempt.newest_frame());
      count_gaze(attempt, shown - before);
    }
    return shown;
  }

  void count_gaze(const LiveAttempt& attempt, Nanoseconds since_frame_before) {
    gaze_.duration_s += seconds(since_frame_before);
    for (const GazeSample& sample : attempt.arrived_gaze()) {
      ++gaze_.samples;
      gaze_.valid += sample.valid ? 1 : 0;
    }
    if (attempt.newest_frame().gaze_valid) {
      ages_s_.push_back(seconds(attempt.newest_frame().gaze_age));
    }
  }

  void follow_window() {
    for (const WindowEvent& event : subject_.events.take()) {
      constexpr bool sees_picture = false;
      subject_.viewer.follow(event, sees_picture);
      if (const auto* size = std::get_if<WindowResized>(&event.what)) {
        subject_.display.resize(size->framebuffer);
      } else if (const auto* hidden = std::get_if<WindowHidden>(&event.what)) {
        subject_.display.hide(hidden->is_hidden);
      }
    }
  }

  const PreflightSubject& subject_;
  LiveGaze gaze_;
  std::vector<double> ages_s_;  ///< of each frame with a valid gaze
};

}  // namespace

MeasuredTrials measure_trials(const PreflightSubject& subject, const std::stop_token& stop) {
  const Protocol& protocol = subject.protocol;
  const auto trials = static_cast<std::int64_t>(protocol.scenes.size() * protocol.methods.size());
  const Nanoseconds duration = std::clamp(all_trials / trials, shortest_trial, longest_trial);
  Measurement measurement(subject);
  MeasuredTrials measured;
  for (const SceneEntry& scene : protocol.scenes) {
    for (const std::string& method : protocol.methods) {
      measured.speeds.push_back(
          measurement.measure({.scene = scene.name, .method = method}, duration, stop));
    }
  }
  measured.gaze = measurement.gaze();
  return measured;
}

FoundDisplay found_display(const Window& window, const std::optional<int>& full_screen_on,
                           const DisplayProfile& stated) {
  const int monitor = full_screen_on.value_or(0);
  FoundDisplay found{.is_full_screen = full_screen_on.has_value(),
                     .refresh_rate_hz = said_refresh_rate_hz(window, monitor, stated)};
  const std::vector<MonitorInfo> monitors = window.monitors();
  const auto number = static_cast<std::size_t>(monitor);
  if (number < monitors.size()) {
    found.monitor_px = monitors[number].size_px;
    found.monitor_width_m = monitors[number].width_m;
  }
  return found;
}

FoundDisplay as_measured(FoundDisplay found, const SessionDisplay& display) {
  found.window_px = display.framebuffer();
  found.refresh_rate_hz = display.refresh().rate_hz();
  return found;
}

}  // namespace foveola::study
