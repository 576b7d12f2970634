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
  Screen screen;  ///< what fractions of the screen are fractions of
  /// The shortest time from when the eye was there until its record can arrive.
  Nanoseconds latency{0};
  /// How long the fastest delivery stands for the one without delay.
  Nanoseconds alignment_window = std::chrono::seconds(10);
  Nanoseconds reconnect_after = std::chrono::milliseconds(500);
  /// A connection over which nothing comes for so long is given up for a new one.
  Nanoseconds longest_silence = std::chrono::seconds(2);
};

struct OpenGazeCounters {
  std::uint64_t records = 0;
  std::uint64_t garbage = 0;     ///< lines that are no elements
  std::uint64_t unreadable = 0;  ///< records whose points are no numbers
  bool is_connected = false;
};

/// Decodes the bytes of one connection into samples.
class OpenGazeDecoder {
 public:
  /// Counts in `counters`.
  OpenGazeDecoder(const OpenGazeSettings& settings, OpenGazeCounters counters);

  /// The samples of the records that end in `bytes`, which arrived at `arrival`. A sample's time is
  /// the record's own, where it has one, else the arrival; less the latency. When a record comes
  /// faster than all before it, times step back by as much. Arrivals may not go backwards.
  std::vector<GazeSample> decode(std::string_view bytes, Nanoseconds arrival);
  /// The counters given, and what came since.
  OpenGazeCounters counters() const;

 private:
  GazeSample sample_from(const OpenGazeRecord& record, Nanoseconds arrival);

  Screen screen_;
  Nanoseconds latency_;
  OpenGazeStream stream_;
  ClockAlignment alignment_;
  OpenGazeCounters counters_;
  std::map<std::string, std::string, std::less<>> last_attributes_;  ///< the last record's
};

/// Listens in a thread of its own from its beginning to its end, and while there is no connection
/// tries again and again, at each of the host's addresses in turn. Sample times are those of
/// SteadyClock.
class OpenGazeTracker final : public EyeTracker {
 public:
  /// Does not wait for the connection. Throws Error if the host is unknown.
  explicit OpenGazeTracker(const OpenGazeSettings& settings);

  /// What has arrived before the call; `now` does not matter.
  void poll(Nanoseconds now, std::vector<GazeSample>& arrived) override;
  std::string status() const override;
  OpenGazeCounters counters() const;

 private:
  void run(const std::stop_token& stop);
  /// One connection from its beginning to its end.
  void converse(const TcpAddress& address, const std::stop_token& stop);
  void listen(const TcpConnection& connection, const std::stop_token& stop);
  void publish(std::span<const GazeSample> samples, const OpenGazeCounters& counters);

  OpenGazeSettings settings_;
  std::vector<TcpAddress> addresses_;

  mutable std::mutex mutex_;
  SampleQueue samples_;
  OpenGazeCounters counters_;

  std::jthread thread_;  ///< the last, so that it ends before what it uses
};

}  // namespace foveola
