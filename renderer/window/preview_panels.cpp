#include "renderer/window/preview_panels.h"

#include <algorithm>
#include <functional>

#include <fmt/format.h>

#include "renderer/preview/frame_latency.h"

namespace foveola {
namespace {

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
  return fmt::format("{:<22}{:6.1f}{:6.1f}{:6.1f} ms{}", spread.name, 1e3 * spread.best_s,
                     1e3 * spread.median_s, 1e3 * spread.worst_s,
                     spread.provenance == Provenance::assumed ? "  assumed" : "");
}

}  // namespace

std::vector<std::string> frame_time_lines(std::span<const LiveFrame> frames,
                                          const std::string& method) {
  const std::span<const LiveFrame> last = last_second(frames);
  if (last.empty()) {
    return {method};
  }
  const auto late = std::count_if(last.begin(), last.end(),
                                  [](const LiveFrame& frame) { return frame.is_late(); });
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
      fmt::format("{:<22}{:>6}{:>6}{:>6}", "", "best", "median", "worst")};
  for (const LatencySpread& stage : report.stages) {
    lines.push_back(latency_line(stage));
  }
  lines.push_back(latency_line(report.total));
  return lines;
}

}  // namespace foveola
