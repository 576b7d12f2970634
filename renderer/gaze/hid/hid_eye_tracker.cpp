#include "renderer/gaze/hid/hid_eye_tracker.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace foveola {
namespace {

/// Plausible widths of a screen, from a wrist watch's to a cinema's; others were never set.
bool is_size_of_screen(const std::optional<double>& size_m) {
  return size_m && *size_m >= 0.01 && *size_m <= 100.0;
}

/// The shape of the report at the beginning of `bytes`; null if none has this id.
const HidReportShape* shape_at(const std::vector<HidReportShape>& shapes,
                               std::span<const std::uint8_t> bytes) {
  const auto found = std::ranges::find_if(shapes, [&](const HidReportShape& shape) {
    return fit_of(shape, bytes) != HidReportFit::wrong_id;
  });
  return found != shapes.end() ? &*found : nullptr;
}

bool is_padding(std::span<const std::uint8_t> bytes) {
  return std::ranges::all_of(bytes, [](std::uint8_t byte) { return byte == 0; });
}

/// Maximum time before the thread can stop.
constexpr std::chrono::milliseconds read_timeout{50};

std::size_t longest_input(const HidEyeReports& reports) {
  std::size_t size_bytes = 0;
  for (const HidReportShape& shape : reports.inputs) {
    size_bytes = std::max(size_bytes, shape.size_bytes);
  }
  return size_bytes;
}

/// The content of a feature report; nullopt if the device lacks it or does not provide it.
template <typename Report>
auto get_feature(HidDevice& device, const std::optional<Report>& report)
    -> decltype(read_report(*report, {})) {
  if (!report) {
    return std::nullopt;
  }
  const auto bytes = device.get_feature_report(report->shape.id, report->shape.size_bytes);
  return bytes ? read_report(*report, *bytes) : std::nullopt;
}

/// Returns whether the device accepted the request, or needs none.
bool request_gaze(HidDevice& device, const std::optional<HidControlReport>& control) {
  return !control || device.send_feature_report(control->shape.id, encode_gaze_request(*control));
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
}

std::vector<GazeSample> HidGazeStream::receive(std::span<const std::uint8_t> bytes,
                                               Nanoseconds arrival) {
  std::vector<GazeSample> samples;
  do {
    const HidReportShape* shape = shape_at(reports_.inputs, bytes);
    if (shape == nullptr || bytes.size() < shape->size_bytes) {
      return samples;
    }
    const auto report = bytes.first(shape->size_bytes);
    if (const auto data = read_report(reports_.tracking, report)) {
      samples.push_back(take_tracking(*data, arrival));
    }
    take_status(report);
    bytes = bytes.subspan(shape->size_bytes);
  } while (!is_padding(bytes));
  return samples;
}

GazeSample HidGazeStream::take_tracking(const HidTrackingData& data, Nanoseconds arrival) {
  GazeSample sample{.time = arrival};
  if (data.sensor_time_s && settings_.use_sensor_clock) {
    sample.time = clock_.host_time(*data.sensor_time_s, arrival);
  }
  sample.time -= nanoseconds_from_seconds(settings_.latency_s);
  const Screen& screen = settings_.screen;
  if (data.gaze_point_m && screen.width_m > 0.0 && screen.height_m > 0.0) {
    sample.direction = direction_at(screen, fraction_of(screen, *data.gaze_point_m));
    sample.valid = true;
  }
  return sample;
}

void HidGazeStream::take_status(std::span<const std::uint8_t> report) {
  if (reports_.status_input) {
    if (const auto status = read_report(*reports_.status_input, report)) {
      learn(*status);
    }
  }
}

HidEyeTracker::HidEyeTracker(Opener open, const Clock& clock, const HidTrackerSettings& settings)
    : open_(std::move(open)),
      clock_(&clock),
      settings_(settings),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

void HidEyeTracker::poll(Nanoseconds /*now*/, std::vector<GazeSample>& arrived) {
  const std::lock_guard lock(mutex_);
  samples_.take(arrived);
}

HidTrackerState HidEyeTracker::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

void HidEyeTracker::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    note_disconnected(connect_and_read(stop));
    wait_to_retry(stop);
  }
}

std::string HidEyeTracker::connect_and_read(const std::stop_token& stop) {
  try {
    const std::optional<HidConnection> connection = open_();
    if (!connection) {
      return "no eye tracker is attached";
    }
    const HidEyeReports reports =
        find_eye_reports(parse_report_descriptor(connection->report_descriptor));
    set_up(*connection, reports);
    read_until_gone(stop, *connection->device, longest_input(reports));
    return "the eye tracker was unplugged";
  } catch (const std::exception& error) {
    return error.what();
  }
}

void HidEyeTracker::set_up(const HidConnection& connection, const HidEyeReports& reports) {
  HidDevice& device = *connection.device;
  const auto configuration = get_feature(device, reports.configuration);
  const auto status = get_feature(device, reports.status_feature);
  // Only now: a host reads the configuration before it requests measurements.
  const bool will_measure = request_gaze(device, reports.control);
  if (stream_) {
    stream_->reconnect(reports);
  } else {
    stream_.emplace(reports, settings_.gaze);
  }
  stream_->learn(configuration.value_or(HidConfiguration{}));
  stream_->learn(status.value_or(HidStatus{}));

  const std::lock_guard lock(mutex_);
  state_.is_connected = true;
  state_.device = connection.info;
  state_.status = stream_->status();
  state_.configuration = configuration;
  state_.status_text = will_measure ? "" : "the eye tracker refuses to be asked for gaze";
}

void HidEyeTracker::read_until_gone(const std::stop_token& stop, HidDevice& device,
                                    std::size_t longest_report_bytes) {
  std::vector<std::uint8_t> buffer(longest_report_bytes);
  while (!stop.stop_requested()) {
    const std::optional<std::size_t> size_bytes = device.read(buffer, read_timeout);
    if (!size_bytes) {
      return;
    }
    if (*size_bytes > 0) {
      take(std::span(buffer).first(*size_bytes));
    }
  }
}

void HidEyeTracker::take(std::span<const std::uint8_t> bytes) {
  const std::vector<GazeSample> samples = stream_->receive(bytes, clock_->now());
  const std::lock_guard lock(mutex_);
  samples_.push(samples);
  state_.status = stream_->status();
}

void HidEyeTracker::note_disconnected(const std::string& status_text) {
  const std::lock_guard lock(mutex_);
  state_.is_connected = false;
  state_.status_text = status_text;
}

void HidEyeTracker::wait_to_retry(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  retry_.wait_for(lock, stop, settings_.retry, [] { return false; });
}

}  // namespace foveola
