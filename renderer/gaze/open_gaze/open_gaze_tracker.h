// Gaze from a tracker whose program speaks the Open Gaze API, over TCP.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/gaze/device_clocks.h"
#include "renderer/gaze/eye_tracker.h"
#include "renderer/gaze/open_gaze/open_gaze_records.h"
#include "renderer/gaze/open_gaze/tcp_connection.h"

namespace foveola {

struct OpenGazeSettings {
  OpenGazeAddress address;
  Screen screen;  ///< the screen of the records' fractions
  /// Minimum latency from eye position to arrival of its record; subtracted from sample times.
  Nanoseconds latency{0};
  /// Time for which the fastest delivery counts as without delay.
  Nanoseconds alignment_window = std::chrono::seconds(10);
  Nanoseconds reconnect_after = std::chrono::milliseconds(500);
  /// A connection without data for this time is replaced.
  Nanoseconds longest_silence = std::chrono::seconds(2);
};

struct OpenGazeCounters {
  std::uint64_t records = 0;
  std::uint64_t garbage = 0;     ///< lines that are not elements
  std::uint64_t unreadable = 0;  ///< records with points that are not numbers
  bool is_connected = false;
};

/// Decodes the bytes of one connection into samples.
class OpenGazeDecoder {
 public:
  /// Starts counting at `counters`.
  OpenGazeDecoder(const OpenGazeSettings& settings, OpenGazeCounters counters);

  /// The samples of the records that end in `bytes`, which arrived at `arrival`. A sample's time is
  /// the record's own, else the arrival, minus the latency. When a record comes faster than all
  /// before it, times step back accordingly. Arrivals must not decrease.
  std::vector<GazeSample> decode(std::string_view bytes, Nanoseconds arrival);
  /// The initial counters plus those since.
  OpenGazeCounters counters() const;

 private:
  GazeSample sample_from(const OpenGazeRecord& record, Nanoseconds arrival);

  Screen screen_;
  Nanoseconds latency_;
  OpenGazeStream stream_;
  ClockAlignment alignment_;
  OpenGazeCounters counters_;
  std::map<std::string, std::string, std::less<>> last_attributes_;  ///< of the last record
};

/// Receives in a thread of its own. Without a connection it retries at each of the host's addresses
/// in turn. Sample times are those of SteadyClock.
class OpenGazeTracker final : public EyeTracker {
 public:
  /// Does not wait for the connection. Throws Error if the host is unknown.
  explicit OpenGazeTracker(const OpenGazeSettings& settings);

  /// Appends all samples that arrived before the call; ignores `now`.
  void poll(Nanoseconds now, std::vector<GazeSample>& arrived) override;
  std::string status() const override;
  OpenGazeCounters counters() const;

 private:
  void run(const std::stop_token& stop);
  /// Handles one connection from its beginning to its end.
  void converse(const TcpAddress& address, const std::stop_token& stop);
  void listen(const TcpConnection& connection, const std::stop_token& stop);
  void publish(std::span<const GazeSample> samples, const OpenGazeCounters& counters);

  OpenGazeSettings settings_;
  std::vector<TcpAddress> addresses_;

  mutable std::mutex mutex_;
  SampleQueue samples_;
  OpenGazeCounters counters_;

  std::jthread thread_;  ///< last: it ends before the members that it uses
};

}  // namespace foveola
