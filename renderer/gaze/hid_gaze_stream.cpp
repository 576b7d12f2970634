#include "renderer/gaze/hid_gaze_stream.h"

#include <algorithm>
#include <cstddef>

namespace foveola {
namespace {

/// Over how many reports the rate is measured: half a second at 120 Hz.
constexpr std::size_t rate_reports = 61;
/// The fewest arrivals from which the period is judged.
constexpr std::size_t least_rate_reports = 16;

constexpr double gap_periods = 1.5;

/// Widths of a screen between a wrist watch's and a cinema's; others were never set.
bool is_size_of_screen(const std::optional<double>& size_m) {
  return size_m && *size_m >= 0.01 && *size_m <= 100.0;
}

/// The shape of the report that `bytes` begin with; null if there is none with this id.
const HidReportShape* shape_at(const std::vector<HidReportShape>& shapes,
                               std::span<const std::uint8_t> bytes) {
  const auto found = std::find_if(shapes.begin(), shapes.end(), [&](const HidReportShape& shape) {
    return fit_of(shape, bytes) != HidReportFit::wrong_id;
  });
  return found != shapes.end() ? &*found : nullptr;
}

bool is_padding(std::span<const std::uint8_t> bytes) {
  return std::all_of(bytes.begin(), bytes.end(), [](std::uint8_t byte) { return byte == 0; });
}

}  // namespace

HidGazeStream::HidGazeStream(const HidEyeReports& reports, const HidGazeSettings& settings)
    : reports_(reports), settings_(settings), clock_(sensor_clock_period_s(reports.tracking)) {}

void HidGazeStream::learn(const HidStatus& status) {
  if (status.sampling_frequency_hz) {
    status_.sampling_frequency_hz = status.sampling_frequency_hz;
  }
  if (status.configuration) {
    status_.configuration = status.configuration;
  }
}

void HidGazeStream::learn(const HidConfiguration& configuration) {
  if (is_size_of_screen(configuration.screen_width_m) &&
      is_size_of_screen(configuration.screen_height_m)) {
    settings_.screen.width_m = *configuration.screen_width_m;
    settings_.screen.height_m = *configuration.screen_height_m;
  }
}

void HidGazeStream::reconnect(const HidEyeReports& reports) {
  reports_ = reports;
  clock_ = HidSensorClock(sensor_clock_period_s(reports.tracking));
  status_ = {};
  arrivals_.clear();
}

std::vector<GazeSample> HidGazeStream::receive(std::span<const std::uint8_t> bytes,
                                               Nanoseconds arrival) {
  std::vector<GazeSample> samples;
  do {
    const HidReportShape* shape = shape_at(reports_.inputs, bytes);
    if (shape == nullptr) {
      ++counters_.wrong_ids;
      return samples;
    }
    if (bytes.size() < shape->size_bytes) {
      ++counters_.short_reads;
      return samples;
    }
    const auto report = bytes.first(shape->size_bytes);
    if (const auto data = read_report(reports_.tracking, report)) {
      samples.push_back(take_tracking(*data, arrival));
    } else {
      ++counters_.other_reports;
    }
    take_status(report);
    bytes = bytes.subspan(shape->size_bytes);
  } while (!is_padding(bytes));
  return samples;
}

GazeSample HidGazeStream::take_tracking(const HidTrackingData& data, Nanoseconds arrival) {
  ++counters_.reports;
  GazeSample sample{.time = arrival};
  std::optional<double> sensor_interval_s;
  if (data.sensor_time_s && settings_.use_sensor_clock) {
    sample.time = clock_.host_time(*data.sensor_time_s, arrival);
    sensor_interval_s = clock_.last_interval_s();
  }
  sample.time -= nanoseconds_from_seconds(settings_.latency_s);
  const Screen& screen = settings_.screen;
  if (data.gaze_point_m && screen.width_m > 0.0 && screen.height_m > 0.0) {
    sample.direction = direction_at(screen, fraction_of(screen, *data.gaze_point_m));
    sample.valid = true;
  }
  count_interval(sensor_interval_s, arrival);
  count_rate(arrival);
  return sample;
}

void HidGazeStream::take_status(std::span<const std::uint8_t> report) {
  if (reports_.status_input) {
    if (const auto status = read_report(*reports_.status_input, report)) {
      learn(*status);
    }
  }
}

void HidGazeStream::count_interval(std::optional<double> sensor_interval_s, Nanoseconds arrival) {
  const std::optional<double> period = period_s();
  if (arrivals_.empty() || !period) {
    return;
  }
  const double interval_s = sensor_interval_s.value_or(seconds(arrival - arrivals_.back()));
  if (interval_s > gap_periods * *period) {
    ++counters_.gaps;
  }
}

void HidGazeStream::count_rate(Nanoseconds arrival) {
  arrivals_.push_back(arrival);
  if (arrivals_.size() > rate_reports) {
    arrivals_.pop_front();
  }
  const double span_s = seconds(arrivals_.back() - arrivals_.front());
  counters_.rate_hz = span_s > 0.0 ? static_cast<double>(arrivals_.size() - 1) / span_s : 0.0;
}

std::optional<double> HidGazeStream::period_s() const {
  const double stated_hz = status_.sampling_frequency_hz.value_or(0.0);
  if (stated_hz > 0.0) {
    return 1.0 / stated_hz;
  }
  const bool is_known = arrivals_.size() >= least_rate_reports && counters_.rate_hz > 0.0;
  return is_known ? std::optional(1.0 / counters_.rate_hz) : std::nullopt;
}

}  // namespace foveola
