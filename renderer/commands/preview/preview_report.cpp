#include "renderer/commands/preview/preview_report.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/numbers/quantile.h"
#include "renderer/base/transformed.h"
#include "renderer/commands/bench_facts.h"
#include "renderer/gaze/latency.h"

namespace foveola {
namespace {

using ReportJson = nlohmann::ordered_json;

constexpr double ms_per_s = 1e3;

double ms(Nanoseconds duration) { return ms_per_s * seconds(duration); }

// --- Frames ---

struct FrameFigure {
  std::string name;
  std::string unit;
  double median = 0.0;
  Median median_with_interval;  ///< as if frames were independent
  double percentile_99 = 0.0;
  double largest = 0.0;
};

template <typename Of>
FrameFigure frame_figure(const PreviewRun& run, const std::string& name, const std::string& unit,
                         const Of& of) {
  std::vector<double> values(run.frames.size());
  std::transform(run.frames.begin(), run.frames.end(), values.begin(), of);
  std::ranges::sort(values);
  return {.name = name,
          .unit = unit,
          .median = quantile(values, 0.5),
          .median_with_interval = median_of(values),
          .percentile_99 = quantile(values, 0.99),
          .largest = values.back()};
}

std::vector<FrameFigure> figures_of(const PreviewRun& run) {
  using Frame = const LiveFrame&;
  return {frame_figure(run, "polling", "ms", [](Frame f) { return ms(f.polling); }),
          frame_figure(run, "tracing", "ms", [](Frame f) { return ms(f.tracing); }),
          frame_figure(run, "resampling", "ms", [](Frame f) { return ms(f.resampling); }),
          frame_figure(run, "presenting", "ms", [](Frame f) { return ms(f.presenting); }),
          frame_figure(run, "age of the gaze used", "ms",
                       [](Frame f) { return ms(f.report.gaze_age); }),
          frame_figure(run, "samples", "a frame",
                       [](Frame f) { return static_cast<double>(f.report.samples); })};
}

std::size_t late_frames(const PreviewRun& run) {
  return static_cast<std::size_t>(
      std::ranges::count_if(run.frames, [](const LiveFrame& frame) { return frame.is_late(); }));
}

/// Number of first frames after a restart that have samples, and of all first frames.
std::pair<std::size_t, std::size_t> restarts_seen(const PreviewRun& run) {
  std::pair<std::size_t, std::size_t> seen{0, 0};
  for (const LiveFrame& frame : run.frames) {
    if (frame.report.frame == 0) {
      ++seen.second;
      seen.first += frame.report.samples > 0 ? 1 : 0;
    }
  }
  return seen;
}

// --- Latency ---

/// The latencies of the frames that follow the eye.
struct EyeFrames {
  std::vector<LatencyStages> stages;  ///< one per frame
  std::size_t with_fresh_gaze = 0;    ///< frames with a gaze no older than its limit
};

EyeFrames eye_frames(const PreviewRun& run) {
  const double limit_s = gaze_age_limit_s(run.tracker);
  EyeFrames eye;
  eye.stages.reserve(run.frames.size());
  for (const LiveFrame& frame : run.frames) {
    if (follows_eye(frame.report)) {
      eye.stages.push_back(frame_latency(frame, run.tracker, run.display));
      eye.with_fresh_gaze += seconds(frame.report.gaze_age) <= limit_s ? 1 : 0;
    }
  }
  return eye;
}

/// The stages in order of time, and their total; empty without frames.
std::vector<LatencySpread> latency_rows(const EyeFrames& eye) {
  if (eye.stages.empty()) {
    return {};
  }
  const LatencyReport report = latency_report(eye.stages);
  std::vector<LatencySpread> rows(report.stages.begin(), report.stages.end());
  rows.push_back(report.total);
  return rows;
}

const char* name_of(Provenance provenance) {
  return provenance == Provenance::measured ? "measured" : "assumed";
}

// --- Text ---

using Text = std::back_insert_iterator<std::string>;

double percent(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

void add_frames(Text text, const PreviewRun& run) {
  const std::size_t late = late_frames(run);
  const auto [seen, restarts] = restarts_seen(run);
  fmt::format_to(text, "{} frames of {:.2f} ms on {} threads: {} late, {:.2f} % in time\n",
                 run.frames.size(), ms_per_s / run.refresh_rate_hz, run.threads, late,
                 percent(run.frames.size() - late, run.frames.size()));
  fmt::format_to(text, "{} of {} starts had samples in the first frame\n", seen, restarts);
  fmt::format_to(text, "{:<22} {:>10} {:>10} {:>10}\n", "", "median", "99 %", "largest");
  for (const FrameFigure& figure : figures_of(run)) {
    fmt::format_to(text, "{:<22} {:>10.3f} {:>10.3f} {:>10.3f} {}\n", figure.name, figure.median,
                   figure.percentile_99, figure.largest, figure.unit);
  }
}

void add_latency(Text text, const PreviewRun& run) {
  const EyeFrames eye = eye_frames(run);
  const std::size_t frames = eye.stages.size();
  fmt::format_to(
      text, "\nFrom the eye's movement to light, in ms, in the {} frames that follow it\n", frames);
  fmt::format_to(text, "{:<22} {:>8} {:>8} {:>8} {:>8}\n", "", "best", "median", "95 %", "worst");
  for (const LatencySpread& row : latency_rows(eye)) {
    fmt::format_to(text, "{:<22} {:>8.2f} {:>8.2f} {:>8.2f} {:>8.2f} {}\n", row.name,
                   ms_per_s * row.best_s, ms_per_s * row.median_s, ms_per_s * row.percentile_95_s,
                   ms_per_s * row.worst_s, name_of(row.provenance));
  }
  fmt::format_to(
      text,
      "Gaze was at most {:.2f} ms old in {} of them, {:.2f} %: the tracker's period and delay\n",
      ms_per_s * gaze_age_limit_s(run.tracker), eye.with_fresh_gaze,
      percent(eye.with_fresh_gaze, frames));
  if (!run.is_resampled) {
    fmt::format_to(text, "Frames were not resampled for a display\n");
  }
}

// --- JSON ---

ReportJson json_of(const FrameFigure& figure) {
  const ReportJson interval = json_of(figure.median_with_interval);
  return {{"name", figure.name},         {"unit", figure.unit},
          {"median", figure.median},     {"low", interval.at("low")},
          {"high", interval.at("high")}, {"percentile_99", figure.percentile_99},
          {"largest", figure.largest}};
}

ReportJson json_of(const LatencySpread& row) {
  return {{"name", row.name},
          {"provenance", name_of(row.provenance)},
          {"best_ms", measured_once(ms_per_s * row.best_s)},
          {"median_ms", measured_once(ms_per_s * row.median_s)},
          {"percentile_95_ms", measured_once(ms_per_s * row.percentile_95_s)},
          {"worst_ms", measured_once(ms_per_s * row.worst_s)}};
}

template <typename Row>
ReportJson json_list(const std::vector<Row>& rows) {
  return transformed(rows, [&](const Row& row) { return json_of(row); });
}

}  // namespace

std::string preview_text(const PreviewRun& run) {
  std::string text;
  add_frames(std::back_inserter(text), run);
  add_latency(std::back_inserter(text), run);
  return text;
}

nlohmann::ordered_json preview_json(const PreviewRun& run) {
  const auto [seen, restarts] = restarts_seen(run);
  const EyeFrames eye = eye_frames(run);
  return {{"tracker", run.tracker.name},
          {"display", run.display.name},
          {"rate_hz", run.refresh_rate_hz},
          {"threads", run.threads},
          {"resampled", run.is_resampled},
          {"frames", run.frames.size()},
          {"late_frames", late_frames(run)},
          {"starts", restarts},
          {"starts_seen_in_the_first_frame", seen},
          {"frames_that_follow_the_eye", eye.stages.size()},
          {"gaze_age_limit_ms", ms_per_s * gaze_age_limit_s(run.tracker)},
          {"frames_with_gaze_within_it", eye.with_fresh_gaze},
          {"figures", json_list(figures_of(run))},
          {"latency", json_list(latency_rows(eye))}};
}

}  // namespace foveola
