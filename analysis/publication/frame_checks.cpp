#include "analysis/publication/frame_checks.h"

#include <utility>

#include <fmt/format.h>

#include "analysis/dataset/wording.h"

namespace foveola::analysis {
namespace {

// These limits are Foveola's own, for want of published ones, except that of the latency: at 50 to
// 70 ms people begin to notice foveation (Albert, Patney, Luebke, Kim 2017).
constexpr double most_late_percent = 1.0;
constexpr double most_untracked_percent = 10.0;
constexpr double longest_latency_ms = 50.0;
constexpr double longest_mark_gap_ms = 100.0;

double percent_of_frames(const study::FrameFigures& row, std::uint64_t some) {
  return 100.0 * static_cast<double>(some) / static_cast<double>(row.frames);
}

/// The participant with the largest value, and all who lie above the limit.
struct Worst {
  double value = 0.0;
  std::string participant;
  std::vector<std::string> above;
};

template <typename Value>
Worst worst_of(const std::vector<study::FrameFigures>& frames, double limit, const Value& value) {
  Worst worst;
  for (const study::FrameFigures& row : frames) {
    if (value(row) > limit) {
      worst.above.push_back(row.participant);
    }
    if (worst.participant.empty() || value(row) > worst.value) {
      worst.value = value(row);
      worst.participant = row.participant;
    }
  }
  return worst;
}

/// A check of each participant's own figure against a limit.
template <typename Value>
DataQualityCheck check_figure(const std::vector<study::FrameFigures>& frames, std::string name,
                              const char* unit, double limit, const std::string& whose,
                              const Value& value) {
  DataQualityCheck check{std::move(name), "", fmt::format("{:g} {}, {}", limit, unit, whose)};
  if (frames.empty()) {
    check.found = "no frames recorded";
    return check;
  }
  const Worst worst = worst_of(frames, limit, value);
  check.found =
      fmt::format("at most {:.3g} {}, participant {}; above the limit: {}", worst.value, unit,
                  worst.participant, worst.above.empty() ? "none" : listed(worst.above));
  check.verdict = within(worst.above.empty());
  return check;
}

}  // namespace

std::vector<DataQualityCheck> check_frames(const std::vector<study::FrameFigures>& frames) {
  return {check_figure(frames, "Frames that missed their refresh", "%", most_late_percent, "ours",
                       [](const auto& row) { return percent_of_frames(row, row.late); }),
          check_figure(frames, "Frames without a valid gaze", "%", most_untracked_percent, "ours",
                       [](const auto& row) { return percent_of_frames(row, row.untracked); }),
          check_figure(
              frames, "Latency, from the eye to the display", "ms", longest_latency_ms,
              "of 50 to 70 that Albert et al. 2017 tolerate",
              [](const auto& row) { return 1e3 * (row.mean_gaze_age_s + row.mean_to_display_s); }),
          check_figure(frames, "From a frame to the mark upon it, the longest", "ms",
                       longest_mark_gap_ms, "ours",
                       [](const auto& row) { return 1e3 * row.longest_mark_after_frame_s; })};
}

}  // namespace foveola::analysis
