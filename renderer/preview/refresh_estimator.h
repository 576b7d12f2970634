// When a display refreshes: measured, not assumed.
#pragma once

#include <cstdint>
#include <optional>

#include "renderer/base/clock.h"

namespace foveola {

/// Learns from when swaps of the display's buffers were complete, each of which waited for a
/// refresh. Swaps may miss any number of refreshes, and be heard of late by a millisecond, or by
/// several now and then. A refresh is where its swaps are heard of on average.
///
/// Refreshes are followed by an alpha-beta filter. Its gains are at first those of the straight
/// line that fits all swaps best (Brookner 1998, "Tracking and Kalman Filtering Made Easy", chapter
/// 6: growing memory), and then those of the last `memory`.
class RefreshEstimator {
 public:
  static constexpr int memory = 128;
  /// Fewer swaps are not taken for a measurement.
  static constexpr int enough_swaps = 32;
  /// How far the measured rate may be off the nominal one, as a part of it. Swaps that do not wait
  /// for the display, of frames that aim at where its refreshes are thought to be, lead the
  /// estimate away from it, faster and faster or more and more slowly.
  static constexpr double rate_tolerance = 0.02;
  /// Root mean square of how far swaps may be off the refreshes, in refresh intervals; of swaps
  /// that have nothing to do with them, it is 1 / sqrt(12) = 0.29.
  static constexpr double spread_tolerance = 0.2;

  /// nominal_rate_hz: > 0, what the display's profile or the system says.
  explicit RefreshEstimator(double nominal_rate_hz);

  /// A swap was complete at `time`. Times ascend. After a pause, refreshes are found anew.
  void swap_completed(Nanoseconds time);

  /// Whether enough swaps have been seen, and they follow the display.
  bool is_measured() const { return swaps_ >= enough_swaps && !is_unsynchronised_; }
  /// Whether swaps were found not to wait for refreshes, or for those of a display of another rate.
  /// It stays so: who paces frames by a clock instead gives their swaps that clock's intervals.
  bool is_unsynchronised() const { return is_unsynchronised_; }

  /// As measured, as far as it is; nominal if the swaps do not follow the display.
  double rate_hz() const { return 1.0 / interval_s(); }
  Nanoseconds interval() const { return nanoseconds_from_seconds(interval_s()); }

  /// The refresh nearest to `time`, before or after it. Before the first swap, `time` itself.
  Nanoseconds nearest_refresh(Nanoseconds time) const;

 private:
  double interval_s() const { return is_unsynchronised_ ? nominal_interval_s_ : interval_s_; }
  void find_anew(Nanoseconds time);
  /// By a swap that was so far off the refresh which is so many intervals after the last one.
  void judge(double intervals, double off_s);
  void follow(double intervals, double off_s);

  double nominal_interval_s_;
  double interval_s_;
  std::optional<Nanoseconds> refresh_;  ///< the last one known
  std::uint64_t swaps_ = 0;
  int remembered_ = 0;            ///< the swaps that the gains are for
  double mean_square_off_ = 0.0;  ///< mean square of swaps' deviations, in squared intervals
  bool is_unsynchronised_ = false;
};

}  // namespace foveola
