#include "study/preflight/preflight_checks.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "renderer/base/transformed.h"

namespace foveola::study {
namespace {

using Json = nlohmann::ordered_json;

// Default limits of Foveola, where the protocol has none: those that the analysis flags, or those
// of the gaze's validation.
constexpr double default_late_percent = 1.0;
constexpr double default_gaze_loss = 0.3;
constexpr double default_gaze_age_s = 0.05;
constexpr double default_free_gb = 1.0;
/// Of the 360-degree image on the horizon. The fovea resolves thirty times finer, so that coarser
/// pixels look like blocks after any rendering time.
constexpr double default_film_pixel_deg = 0.5;
/// Minimum rate of a tracker, as a fraction of its profile's.
constexpr double default_gaze_rate = 0.9;

constexpr double bytes_per_gb = 1e9;
constexpr IVec2 min_window_px{160, 120};

/// Judges by the protocol's limit if it has one, else by the default one.
PreflightVerdict judged(bool has_gate, bool is_good) {
  return is_good    ? PreflightVerdict::good
         : has_gate ? PreflightVerdict::refused
                    : PreflightVerdict::warned;
}

std::string whose(bool has_gate) { return has_gate ? "the protocol's" : "ours"; }

PreflightCheck check_frames(const Preflight& preflight, const PreflightGate& gate) {
  const auto worst = std::ranges::max_element(preflight.speeds, [](const auto& a, const auto& b) {
    return a.late_percent() < b.late_percent();
  });
  const auto slowest = std::ranges::min_element(preflight.speeds, [](const auto& a, const auto& b) {
    return a.frame_rate_hz() < b.frame_rate_hz();
  });
  const double limit = gate.max_late_percent.value_or(default_late_percent);
  return {.name = "frames in time",
          .found = fmt::format("{:.1f} % late at most ({} with {}); {:.1f} frames a second of "
                               "{:.1f} at least",
                               worst->late_percent(), worst->scene, worst->method,
                               slowest->frame_rate_hz(), preflight.found_display.refresh_rate_hz),
          .limit = fmt::format("at most {:g} % late, {}", limit,
                               whose(gate.max_late_percent.has_value())),
          .verdict = judged(gate.max_late_percent.has_value(), worst->late_percent() <= limit)};
}

/// Returns the slowest scene of each method, in the order of the measurements.
std::vector<TrialSpeed> slowest_by_method(const std::vector<TrialSpeed>& speeds) {
  std::vector<TrialSpeed> slowest;
  for (const TrialSpeed& speed : speeds) {
    const auto known = std::ranges::find(slowest, speed.method, &TrialSpeed::method);
    if (known == slowest.end()) {
      slowest.push_back(speed);
    } else if (speed.samples_per_second() < known->samples_per_second()) {
      *known = speed;
    }
  }
  return slowest;
}

PreflightCheck check_samples(const Preflight& preflight, const PreflightGate& gate) {
  std::vector<std::string> found;
  bool is_good = true;
  for (const TrialSpeed& speed : slowest_by_method(preflight.speeds)) {
    found.push_back(
        fmt::format("{} {:.3g} in {}", speed.method, speed.samples_per_second(), speed.scene));
    is_good = is_good && speed.samples_per_second() >= gate.min_samples_per_second.value_or(0.0);
  }
  PreflightCheck check{.name = "samples a second",
                       .found = fmt::format("{}", fmt::join(found, ", "))};
  if (gate.min_samples_per_second) {
    check.limit = fmt::format("at least {:g}, the protocol's", *gate.min_samples_per_second);
    check.verdict = judged(true, is_good);
  }
  return check;
}

PreflightCheck check_eye(const Preflight& preflight, const PreflightGate& gate) {
  const std::string eye = eye_of(preflight.tracker.source);
  return {.name = "eye",
          .found = fmt::format("{} ({})", eye, preflight.tracker.name),
          .limit = fmt::format("tracked, {}", whose(gate.tracked_eye)),
          .verdict = judged(gate.tracked_eye, eye == "tracked")};
}

PreflightCheck check_gaze_rate(const Preflight& preflight, const PreflightGate& gate) {
  const double least_hz =
      gate.min_gaze_rate_hz.value_or(default_gaze_rate * preflight.tracker.rate_hz);
  const LiveGaze& gaze = preflight.gaze;
  return {.name = "gaze rate",
          .found = fmt::format("{:.1f} Hz{}", gaze.rate_hz(),
                               gaze.status.empty() ? "" : ": " + gaze.status),
          .limit = fmt::format("at least {:g} Hz, {}", least_hz,
                               gate.min_gaze_rate_hz ? "the protocol's" : "by its profile"),
          .verdict = judged(gate.min_gaze_rate_hz.has_value(), gaze.rate_hz() >= least_hz)};
}

PreflightCheck check_gaze_loss(const Preflight& preflight, const PreflightGate& gate) {
  const double limit = gate.max_gaze_loss.value_or(default_gaze_loss);
  return {.name = "gaze lost",
          .found = fmt::format("{:.0f} %", 100.0 * preflight.gaze.loss()),
          .limit = fmt::format("at most {:g} %, {}", 100.0 * limit,
                               whose(gate.max_gaze_loss.has_value())),
          .verdict = judged(gate.max_gaze_loss.has_value(), preflight.gaze.loss() <= limit)};
}

PreflightCheck check_gaze_age(const Preflight& preflight, const PreflightGate& gate) {
  constexpr double ms_per_s = 1e3;
  const double limit_s = gate.max_gaze_age_s.value_or(default_gaze_age_s);
  const std::optional<double>& age_s = preflight.gaze.median_age_s;
  return {.name = "gaze age",
          .found = age_s ? fmt::format("{:.1f} ms, the median", ms_per_s * *age_s)
                         : "no valid gaze came",
          .limit = fmt::format("at most {:g} ms, {}", ms_per_s * limit_s,
                               whose(gate.max_gaze_age_s.has_value())),
          .verdict = judged(gate.max_gaze_age_s.has_value(), age_s && *age_s <= limit_s)};
}

PreflightCheck check_display(const Preflight& preflight, const PreflightGate& gate) {
  const std::vector<std::string> differences =
      display_differences(preflight.display, preflight.found_display);
  return {
      .name = "display",
      .found = differences.empty() ? "as stated" : fmt::format("{}", fmt::join(differences, "; ")),
      .limit = fmt::format("as the profile {} states, {}", preflight.display.name,
                           whose(gate.stated_display)),
      .verdict = judged(gate.stated_display, differences.empty())};
}

PreflightCheck check_angles(const Preflight& preflight, const PreflightGate& gate) {
  const DVec2& view = preflight.view_deg;
  PreflightCheck check{.name = "angles",
                       .found = fmt::format("{:.1f} x {:.1f} degrees", view.x, view.y)};
  if (gate.fov_deg) {
    check.limit = fmt::format("{:g} x {:g} degrees within {:g}, the protocol's", gate.fov_deg->x,
                              gate.fov_deg->y, gate.fov_tolerance_deg);
    check.verdict = judged(true, std::abs(view.x - gate.fov_deg->x) <= gate.fov_tolerance_deg &&
                                     std::abs(view.y - gate.fov_deg->y) <= gate.fov_tolerance_deg);
  }
  return check;
}

/// A window that is too small cannot be judged, whatever the protocol requires.
PreflightCheck check_window(const Preflight& preflight, const PreflightGate& gate) {
  const FoundDisplay& found = preflight.found_display;
  const bool has_gate = gate.full_screen;
  const bool is_large =
      found.window_px.x >= min_window_px.x && found.window_px.y >= min_window_px.y;
  return {.name = "window",
          .found = fmt::format("{} x {} pixels, {}", found.window_px.x, found.window_px.y,
                               found.is_full_screen ? "full screen" : "not full screen"),
          .limit = fmt::format("at least {} x {}{}", min_window_px.x, min_window_px.y,
                               has_gate ? ", full screen, the protocol's" : ", ours"),
          .verdict = judged(true, is_large && (found.is_full_screen || !has_gate))};
}

/// No protocol limits it: the film is the protocol's own.
PreflightCheck check_film(const Preflight& preflight) {
  const double pixel_deg = 360.0 / preflight.film_px.x;
  return {.name = "film",
          .found = fmt::format("{} x {} pixels of {:.2g} degrees", preflight.film_px.x,
                               preflight.film_px.y, pixel_deg),
          .limit = fmt::format("at most {:g} degrees, ours: see [film]", default_film_pixel_deg),
          .verdict = judged(false, pixel_deg <= default_film_pixel_deg)};
}

PreflightCheck check_disk(const Preflight& preflight, const PreflightGate& gate) {
  const double free_gb = static_cast<double>(preflight.free_bytes) / bytes_per_gb;
  const double limit_gb = gate.min_free_gb.value_or(default_free_gb);
  return {
      .name = "disk",
      .found = fmt::format("{:.1f} GB free", free_gb),
      .limit = fmt::format("at least {:g} GB, {}", limit_gb, whose(gate.min_free_gb.has_value())),
      .verdict = judged(gate.min_free_gb.has_value(), free_gb >= limit_gb)};
}

PreflightCheck check_clock(const Preflight& preflight, const PreflightGate& gate) {
  const std::optional<bool>& is_set = preflight.is_clock_set;
  return {.name = "clock",
          .found = !is_set   ? "the system does not say whether it is synchronised"
                   : *is_set ? "synchronised"
                             : "not synchronised",
          .limit = fmt::format("synchronised, {}", whose(gate.set_clock)),
          .verdict = judged(gate.set_clock, is_set.value_or(false))};
}

const char* name_of(PreflightVerdict verdict) {
  switch (verdict) {
    case PreflightVerdict::warned:
      return "warned";
    case PreflightVerdict::refused:
      return "refused";
    case PreflightVerdict::good:
      break;
  }
  return "good";
}

Json json_of(const TrialSpeed& speed) {
  return {{"scene", speed.scene},
          {"method", speed.method},
          {"frames", speed.frames},
          {"late", speed.late},
          {"frames_per_second", speed.frame_rate_hz()},
          {"samples_per_second", speed.samples_per_second()}};
}

Json json_of(const LiveGaze& gaze) {
  return {{"samples", gaze.samples},
          {"rate_hz", gaze.rate_hz()},
          {"loss", gaze.loss()},
          {"median_age_s", gaze.median_age_s ? Json(*gaze.median_age_s) : Json()}};
}

Json json_of(const PreflightCheck& check) {
  return {{"check", check.name},
          {"found", check.found},
          {"limit", check.limit},
          {"verdict", name_of(check.verdict)}};
}

std::string upper_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
  return text;
}

std::string framed(const std::vector<std::string>& lines) {
  std::size_t width = 0;
  for (const std::string& line : lines) {
    width = std::max(width, line.size());
  }
  const std::string edge(width + 6, '*');
  std::string box = edge + "\n";
  for (const std::string& line : lines) {
    box += fmt::format("*  {:<{}}  *\n", line, width);
  }
  return box + edge + "\n";
}

std::string eye_line(const TrackerProfile& tracker) {
  const std::string eye = eye_of(tracker.source);
  return eye == "pointer"
             ? upper_case("the mouse pointer replaces the eye")
             : upper_case(fmt::format("the eye is {}: no person's gaze is measured", eye));
}

}  // namespace

std::vector<PreflightCheck> check_preflight(const Preflight& preflight, const PreflightGate& gate) {
  return {check_frames(preflight, gate),    check_samples(preflight, gate),
          check_eye(preflight, gate),       check_gaze_rate(preflight, gate),
          check_gaze_loss(preflight, gate), check_gaze_age(preflight, gate),
          check_display(preflight, gate),   check_angles(preflight, gate),
          check_window(preflight, gate),    check_film(preflight),
          check_disk(preflight, gate),      check_clock(preflight, gate)};
}

void require_gate(const std::vector<PreflightCheck>& checks) {
  std::vector<std::string> missed;
  for (const PreflightCheck& check : checks) {
    if (check.verdict == PreflightVerdict::refused) {
      missed.push_back(check.name);
    }
  }
  if (!missed.empty()) {
    throw Error("preflight",
                fmt::format("fails the protocol's limits, so no session was begun: {}",
                            fmt::join(missed, ", ")),
                "correct the refused checks of the table, or rehearse with --pilot");
  }
}

nlohmann::ordered_json preflight_json(const Preflight& preflight,
                                      const std::vector<PreflightCheck>& checks) {
  const Json speeds(
      transformed(preflight.speeds, [&](const TrialSpeed& speed) { return json_of(speed); }));
  const Json verdicts(
      transformed(checks, [&](const PreflightCheck& check) { return json_of(check); }));
  const FoundDisplay& found = preflight.found_display;
  return {{"speeds", speeds},
          {"eye", eye_of(preflight.tracker.source)},
          {"gaze", json_of(preflight.gaze)},
          {"monitor_px", {found.monitor_px.x, found.monitor_px.y}},
          {"monitor_width_m", found.monitor_width_m},
          {"full_screen", found.is_full_screen},
          {"film_px", {preflight.film_px.x, preflight.film_px.y}},
          {"free_bytes", preflight.free_bytes},
          {"clock_is_set", preflight.is_clock_set ? Json(*preflight.is_clock_set) : Json()},
          {"checks", verdicts}};
}

std::string preflight_table(const std::vector<PreflightCheck>& checks) {
  std::size_t name_width = 0;
  for (const PreflightCheck& check : checks) {
    name_width = std::max(name_width, check.name.size());
  }
  std::string table = "Preflight\n";
  for (const PreflightCheck& check : checks) {
    const char* const mark = check.verdict == PreflightVerdict::good      ? "good"
                             : check.verdict == PreflightVerdict::refused ? "REFUSED"
                                                                          : "WARNING";
    table += fmt::format("  {:<{}}  {:<7}  {}{}\n", check.name, name_width, mark, check.found,
                         check.limit.empty() ? "" : fmt::format("  ({})", check.limit));
  }
  return table;
}

std::string preflight_banner(const Preflight& preflight, bool is_pilot) {
  std::vector<std::string> lines;
  const bool has_headset_stand_in =
      stands_in_for_headset(preflight.display, preflight.found_display);
  if (std::string(eye_of(preflight.tracker.source)) != "tracked") {
    lines.push_back(eye_line(preflight.tracker));
  } else if (preflight.gaze.samples == 0) {
    lines.push_back(
        upper_case(fmt::format("the eye tracker {} does not answer", preflight.tracker.name)));
    if (!preflight.gaze.status.empty()) {
      lines.push_back(preflight.gaze.status);
    }
  }
  if (has_headset_stand_in) {
    lines.push_back(
        upper_case(fmt::format("this window replaces the headset {}", preflight.display.name)));
    if (is_pilot) {
      lines.emplace_back("To rehearse on a monitor: --display desktop --tracker pointer");
    }
  }
  return lines.empty() ? "" : framed(lines);
}

}  // namespace foveola::study
