#include "renderer/window/live/preview_panels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "renderer/view/acuity.h"

namespace foveola {
namespace {

constexpr std::size_t max_messages = 4;

std::optional<Nanoseconds> end_of(Nanoseconds now, MessageStay stay) {
  switch (stay) {
    case MessageStay::long_enough:
      return now + std::chrono::seconds(15);
    case MessageStay::until_key:
      return std::nullopt;
    case MessageStay::briefly:
      break;
  }
  return now + std::chrono::seconds(4);
}

/// The frames that began within a second of the last one.
std::span<const LiveFrame> last_second(std::span<const LiveFrame> frames) {
  if (frames.empty()) {
    return frames;
  }
  const Nanoseconds begin = frames.back().start - std::chrono::seconds(1);
  const auto first = std::find_if(frames.rbegin(), frames.rend(), [&](const LiveFrame& frame) {
                       return frame.start < begin;
                     }).base();
  return {first, frames.end()};
}

std::string time_line(const std::string& name, std::span<const LiveFrame> frames,
                      const std::function<Nanoseconds(const LiveFrame&)>& time_of) {
  Nanoseconds sum{0};
  Nanoseconds longest{0};
  for (const LiveFrame& frame : frames) {
    sum += time_of(frame);
    longest = std::max(longest, time_of(frame));
  }
  return fmt::format("{:<11}{:6.2f} ms  up to {:6.2f}", name,
                     1e3 * seconds(sum) / static_cast<double>(frames.size()),
                     1e3 * seconds(longest));
}

std::string latency_line(const LatencySpread& spread) {
  return fmt::format("{:<22}{:8.1f}{:8.1f}{:8.1f} ms{}", spread.name, 1e3 * spread.best_s,
                     1e3 * spread.median_s, 1e3 * spread.worst_s,
                     spread.provenance == Provenance::assumed ? "  assumed" : "");
}

std::vector<std::string> warning_lines(std::span<const std::string> warnings) {
  std::vector<std::string> lines = {warnings.empty() ? "no warnings of the scene"
                                                     : "warnings of the scene"};
  for (const std::string& warning : warnings) {
    lines.push_back("- " + warning);
  }
  return lines;
}

/// The knee of the published acuity model, and round numbers beyond.
constexpr std::array acuity_rings_deg = {reddy_knee_deg, 10.0, 20.0, 40.0};

}  // namespace

void PreviewMessages::tell(Nanoseconds now, std::string text, MessageStay stay) {
  std::erase_if(messages_, [&](const Message& one) {
    return one.text == text || (one.end && *one.end <= now);
  });
  messages_.push_back({.text = std::move(text), .end = end_of(now, stay)});
  if (messages_.size() > max_messages) {
    messages_.erase(messages_.begin());
  }
}

void PreviewMessages::answer_key() {
  std::erase_if(messages_, [](const Message& one) { return !one.end; });
}

std::vector<std::string> PreviewMessages::lines(Nanoseconds now) const {
  std::vector<std::string> lines;
  for (const Message& one : messages_) {
    if (!one.end || now < *one.end) {
      lines.push_back(one.text);
    }
  }
  return lines;
}

std::vector<std::string> frame_time_lines(std::span<const LiveFrame> frames,
                                          const std::string& method) {
  const std::span<const LiveFrame> last = last_second(frames);
  if (last.empty()) {
    return {method};
  }
  const auto late =
      std::ranges::count_if(last, [](const LiveFrame& frame) { return frame.is_late(); });
  return {
      method,
      fmt::format("{} frames in the last second, {} late", last.size(), late),
      fmt::format("{} samples in the last frame", last.back().report.samples),
      time_line("polling", last, [](const LiveFrame& frame) { return frame.polling; }),
      time_line("tracing", last, [](const LiveFrame& frame) { return frame.tracing; }),
      time_line("drawing", last, [](const LiveFrame& frame) { return frame.resampling; }),
      time_line("presenting", last, [](const LiveFrame& frame) { return frame.presenting; }),
      time_line("gaze's age", last, [](const LiveFrame& frame) { return frame.report.gaze_age; })};
}

std::string gaze_quality_line(const GazeQuality& quality) {
  if (!quality.figures) {
    return "the tracker saw no eye look at any target";
  }
  return fmt::format("accuracy {:.2f} degrees, precision {:.2f}, {:.0f} % lost",
                     quality.figures->accuracy_deg, quality.figures->precision_rms_deg,
                     100.0 * quality.data_loss);
}

std::string gaze_correction_line(const GazeCorrection& correction) {
  const auto sum = [](const DVec3& row) {
    return fmt::format("{:.2f} {:+.3f} a {:+.3f} e", row.x, row.y, row.z);
  };
  return fmt::format("azimuth {}, elevation {}", sum(correction.azimuth),
                     sum(correction.elevation));
}

std::vector<std::string> latency_lines(std::span<const LiveFrame> frames,
                                       const TrackerProfile& tracker,
                                       const DisplayProfile& display) {
  std::vector<LatencyStages> latencies;
  for (const LiveFrame& frame : last_second(frames)) {
    if (follows_eye(frame.report)) {
      latencies.push_back(frame_latency(frame, tracker, display));
    }
  }
  if (latencies.empty()) {
    return {"no frame follows the eye"};
  }
  const LatencyReport report = latency_report(latencies);
  std::vector<std::string> lines = {
      fmt::format("{:<22}{:>8}{:>8}{:>8}", "", "best", "median", "worst")};
  for (const LatencySpread& stage : report.stages) {
    lines.push_back(latency_line(stage));
  }
  lines.push_back(latency_line(report.total));
  return lines;
}

std::vector<std::string> density_lines(std::span<const LiveFrame> frames) {
  constexpr double sphere_deg2 = 4.0 * 180.0 * 180.0 / std::numbers::pi;
  const std::span<const LiveFrame> last = last_second(frames);
  // The scale's ends and its three quarters, below density_map's decades.
  std::vector<std::string> lines = {"1/100   1/10        1         10       100",
                                    "sample density relative to uniform"};
  const Nanoseconds took = last.empty() ? Nanoseconds(0) : last.back().shown - last.front().start;
  if (took > Nanoseconds(0)) {
    double samples = 0.0;
    for (const LiveFrame& frame : last) {
      samples += static_cast<double>(frame.report.samples);
    }
    lines.push_back(fmt::format("1: {:.3g} per second and square degree",
                                samples / seconds(took) / sphere_deg2));
  }
  return lines;
}

std::vector<std::string> view_lines(const ShownNow& shown) {
  return {shown.view,
          fmt::format("camera {:.4g}, {:.4g}, {:.4g}; moves at {:.3g} m/s", shown.camera.x,
                      shown.camera.y, shown.camera.z, shown.speed_m_per_s),
          fmt::format("head {:.1f}, {:.1f} degrees", degrees(shown.head.azimuth_rad),
                      degrees(shown.head.elevation_rad)),
          fmt::format("exposure {:+.1f} stops, {} tone curve", shown.exposure_stops,
                      shown.curve == ToneCurve::filmic ? "filmic" : "plain"),
          std::isfinite(shown.largest_radiance)
              ? fmt::format("samples clamped at {:.3g}: no specks, but too dark",
                            shown.largest_radiance)
              : "samples not clamped"};
}

std::string view_options(const ShownNow& shown) {
  const std::string options = fmt::format(
      "--camera {:.6g},{:.6g},{:.6g} --head {:.5g},{:.5g}", shown.camera.x, shown.camera.y,
      shown.camera.z, degrees(shown.head.azimuth_rad), degrees(shown.head.elevation_rad));
  return shown.horizontal_fov_deg
             ? fmt::format("{} --fov {:.4g}", options, *shown.horizontal_fov_deg)
             : options;
}

std::vector<TextPanel> preview_panels(const PreviewChoices& choices,
                                      const PanelContents& contents) {
  std::vector<TextPanel> panels;
  const auto show = [&](PanelPlace place, std::vector<std::string> lines) {
    panels.push_back({.place = place, .lines = std::move(lines)});
  };
  if (!contents.notes.empty()) {
    show(PanelPlace::bottom_left, contents.notes);
  }
  if (choices.shows_warnings) {
    show(PanelPlace::middle, warning_lines(contents.warnings));
  }
  if (choices.shows_help) {
    show(PanelPlace::middle, help_lines());
  }
  if (choices.shows_frame_times) {
    show(PanelPlace::top_left, frame_time_lines(contents.frames, method_text(choices)));
  }
  if (choices.shows_latency) {
    show(PanelPlace::top_right, latency_lines(contents.frames, contents.tracker, contents.display));
  }
  if (choices.shows_view) {
    show(PanelPlace::top_left, view_lines(contents.shown));
  }
  if (choices.shows_density) {
    show(PanelPlace::bottom_right, density_lines(contents.frames));
    panels.back().has_density_scale = true;
  }
  return panels;
}

ViewOverlays preview_overlays(const PreviewChoices& choices, const Preview& preview) {
  constexpr int density_cells = 48;
  ViewOverlays overlays{.gaze = preview.gaze(), .shows_gaze = choices.shows_gaze};
  if (choices.shows_rings) {
    for (const double ring_deg : acuity_rings_deg) {
      overlays.rings_rad.push_back(static_cast<float>(radians(ring_deg)));
    }
  }
  if (choices.shows_density) {
    overlays.density =
        density_map(preview.sampler(), preview.viewport(), density_cells, density_cells);
  }
  return overlays;
}

}  // namespace foveola
