#include "renderer/gaze/open_gaze/open_gaze_tracker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace foveola {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

/// Maximum time between two checks for a stop.
constexpr milliseconds slice{50};

/// Repeats wait(slice), which returns a TcpConnection::Wait, until it succeeds, the limit has
/// passed, or the thread has to stop.
template <typename Wait>
TcpConnection::Wait wait_in_slices(const std::stop_token& stop, Nanoseconds limit,
                                   const Wait& wait) {
  const auto end = steady_clock::now() + limit;
  while (!stop.stop_requested() && steady_clock::now() < end) {
    if (const TcpConnection::Wait result = wait(slice); result != TcpConnection::Wait::not_yet) {
      return result;
    }
  }
  return TcpConnection::Wait::not_yet;
}

void pause(const std::stop_token& stop, Nanoseconds duration) {
  const auto end = steady_clock::now() + duration;
  while (!stop.stop_requested() && steady_clock::now() < end) {
    std::this_thread::sleep_for(std::min<Nanoseconds>(slice, end - steady_clock::now()));
  }
}

}  // namespace

OpenGazeDecoder::OpenGazeDecoder(const OpenGazeSettings& settings, OpenGazeCounters counters)
    : screen_(settings.screen),
      latency_(settings.latency),
      alignment_(settings.alignment_window),
      counters_(counters) {}

std::vector<GazeSample> OpenGazeDecoder::decode(std::string_view bytes, Nanoseconds arrival) {
  std::vector<GazeSample> samples;
  for (OpenGazeElement& element : stream_.take(bytes)) {
    if (element.kind != OpenGazeKind::record) {
      continue;
    }
    const OpenGazeRecord record = record_from(element);
    // A repeated record without counter and time may be of an eye at rest.
    const bool is_known = record.count || record.time_s;
    if (is_known && element.attributes == last_attributes_) {
      continue;
    }
    last_attributes_ = std::move(element.attributes);
    samples.push_back(sample_from(record, arrival));
  }
  return samples;
}

OpenGazeCounters OpenGazeDecoder::counters() const {
  OpenGazeCounters counters = counters_;
  counters.garbage += stream_.garbage();
  return counters;
}

GazeSample OpenGazeDecoder::sample_from(const OpenGazeRecord& record, Nanoseconds arrival) {
  Nanoseconds sent = arrival;
  if (record.time_s) {
    sent = alignment_.host_time(Nanoseconds(std::llround(1e9 * *record.time_s)), arrival);
  }
  const PointOfGaze gaze = combined_gaze(record);
  ++counters_.records;
  counters_.unreadable += gaze.is_unreadable ? 1 : 0;
  GazeSample sample{.time = sent - latency_, .valid = gaze.valid};
  if (gaze.valid) {
    sample.direction = direction_at(screen_, gaze.fraction);
  }
  return sample;
}

OpenGazeTracker::OpenGazeTracker(const OpenGazeSettings& settings)
    : settings_(settings),
      addresses_(resolve(settings.address.host, settings.address.port)),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

void OpenGazeTracker::poll(Nanoseconds /*now*/, std::vector<GazeSample>& arrived) {
  const std::lock_guard lock(mutex_);
  samples_.take(arrived);
}

std::string OpenGazeTracker::status() const {
  const OpenGazeCounters so_far = counters();
  const std::string place = fmt::format("{}:{}", settings_.address.host, settings_.address.port);
  if (!so_far.is_connected) {
    return "nothing speaks the Open Gaze API at " + place;
  }
  if (so_far.records == 0 && so_far.garbage > 0) {
    return place + " sends lines that are not of the Open Gaze API";
  }
  return so_far.records > 0 && so_far.unreadable == so_far.records
             ? place + " sends points of gaze that are not numbers"
             : "";
}

OpenGazeCounters OpenGazeTracker::counters() const {
  const std::lock_guard lock(mutex_);
  return counters_;
}

void OpenGazeTracker::run(const std::stop_token& stop) {
  for (std::size_t i = 0; !stop.stop_requested(); ++i) {
    converse(addresses_[i % addresses_.size()], stop);
    pause(stop, settings_.reconnect_after);
  }
}

void OpenGazeTracker::converse(const TcpAddress& address, const std::stop_token& stop) {
  const TcpConnection connection(address);
  const auto wait = [&](milliseconds patience) { return connection.wait_for_connection(patience); };
  if (wait_in_slices(stop, settings_.longest_silence, wait) != TcpConnection::Wait::ready ||
      !connection.send(open_gaze_requests())) {
    return;
  }
  OpenGazeCounters counters = this->counters();
  counters.is_connected = true;
  publish({}, counters);
  listen(connection, stop);
  counters = this->counters();
  counters.is_connected = false;
  publish({}, counters);
}

void OpenGazeTracker::listen(const TcpConnection& connection, const std::stop_token& stop) {
  OpenGazeDecoder decoder(settings_, counters());
  const SteadyClock clock;
  std::array<char, 16384> buffer{};
  const auto wait = [&](milliseconds patience) { return connection.wait_for_bytes(patience); };
  while (wait_in_slices(stop, settings_.longest_silence, wait) == TcpConnection::Wait::ready) {
    const TcpConnection::Received received = connection.receive(buffer);
    if (received.is_closed) {
      return;
    }
    const std::vector<GazeSample> samples = decoder.decode(received.bytes, clock.now());
    publish(samples, decoder.counters());
  }
}

void OpenGazeTracker::publish(std::span<const GazeSample> samples,
                              const OpenGazeCounters& counters) {
  const std::lock_guard lock(mutex_);
  counters_ = counters;
  samples_.push(samples);
}

}  // namespace foveola
