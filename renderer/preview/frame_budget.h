// Numbers of samples per frame, learned from previous frames, and the display's refresh times,
// measured and not assumed.
#pragma once

#include <cstdint>
#include <optional>

#include "renderer/base/clock.h"

namespace foveola {

/// A varying cost: its smoothed mean, and a bound that it seldom exceeds, the mean plus four
/// smoothed deviations, like a packet's round trip in TCP (Jacobson 1988, "Congestion Avoidance and
/// Control", appendix A; RFC 6298, section 2).
class CostEstimate {
 public:
  void add(double cost);
  bool empty() const { return count_ == 0; }
  double mean() const { return mean_; }
  /// Exceeded now and then: the mean plus one deviation.
  double usual() const { return mean_ + deviation_; }
  double seldom_exceeded() const { return mean_ + 4.0 * deviation_; }

 private:
  std::uint64_t count_ = 0;
  double mean_ = 0.0;
  double deviation_ = 0.0;
};

/// Splits a frame's tracing into batches: a large one, and then smaller ones that fit the remaining
/// time. A deadline is then missed at most by the last one's excess over its expected time.
///
/// If drawing persistently leaves less than the wanted share of the refresh interval for tracing,
/// frames aim at a later refresh. Tracing then has the wanted share of each frame while frames take
/// at most longest_wanted_frame_s, and at least half in any case.
class FrameBudget {
 public:
  /// Number of samples while machine and scene are unknown.
  static constexpr std::uint64_t first_of_all = 1024;
  /// Wanted share if drawing takes no time from tracing, as on a graphics card: frames in time.
  static constexpr double least_share = 0.1;
  /// Wanted share if the processor does both.
  static constexpr double shared_processor_share = 2.0 / 3.0;
  static constexpr double longest_wanted_frame_s = 1.0 / 15.0;

  /// traced_share: wanted share of the refresh interval for tracing, in [least_share, 0.9].
  explicit FrameBudget(double traced_share = least_share) : traced_share_(traced_share) {}

  /// Begins a frame, `left` before its deadline, on a display with refresh interval `interval`.
  /// Returns the remaining time for its batches: `left`, or more if drawing is too slow.
  Nanoseconds begin_frame(Nanoseconds left, Nanoseconds interval);

  /// Number of samples in the frame's first batch, `left` before its deadline: as many as a
  /// millisecond allows, but at least 64 and at most first_of_all. Some are traced however late it
  /// is, so that a restart is visible in the next frame.
  std::uint64_t first_batch(Nanoseconds left) const;
  /// Number of samples in the next batch; 0 if the remaining time allows less than a quarter of a
  /// millisecond of tracing or, if drawing is too slow, ten times that.
  std::uint64_t next_batch(Nanoseconds left) const;

  /// Records the time of a batch of `samples` from directions to film; samples > 0.
  void batch_took(std::uint64_t samples, Nanoseconds time);
  /// Records the frame's time between its last batch and its deadline's event.
  void rest_took(Nanoseconds time);
  /// Records whether the frame missed its deadline. The reserve adapts so that one of 200 does:
  /// more after each late frame, less after the others (Robbins and Monro 1951, "A stochastic
  /// approximation method").
  void frame_ended(bool is_late);

  /// Whether the rest of frames leaves too little of the refresh interval for tracing. Set after a
  /// few dozen such frames in a row, and reset by a clearly shorter rest.
  bool is_drawing_too_slow() const { return is_drawing_too_slow_; }
  /// A budget for another preview in the same window: sample costs are unknown again, but slow
  /// drawing is remembered.
  FrameBudget for_another_preview() const;
  /// Mean duration of a frame's rest; 0 before the first.
  Nanoseconds drawing_time() const { return nanoseconds_from_seconds(rest_s_.mean()); }

 private:
  /// Updates the judgement by an ended frame.
  void judge_drawing();
  /// Number of refreshes of a frame with this rest.
  double refreshes_for(double rest_s) const;
  /// Number of samples that can be traced in time from now.
  double samples_in(Nanoseconds left) const;
  /// Mean number of samples in this time.
  double samples_for(double time_s) const { return time_s / sample_s_.mean(); }

  double traced_share_;
  CostEstimate sample_s_;
  CostEstimate rest_s_;
  double reserve_s_ = 0.0;
  double interval_s_ = 0.0;  ///< refresh interval in the last frame begun
  double slow_share_ = 0.0;  ///< smoothed share of frames with too long a rest
  bool is_drawing_too_slow_ = false;
};

/// Estimates refreshes from the completion times of buffer swaps, each of which waited for a
/// refresh. Swaps may miss any number of refreshes, and their reports may be late by a millisecond
/// or, now and then, several. A refresh has the mean time of its swaps' reports.
///
/// Refreshes are tracked by an alpha-beta filter. Its gains are at first those of a least-squares
/// line through all swaps (Brookner 1998, "Tracking and Kalman Filtering Made Easy", chapter 6:
/// growing memory), and then those of the last `memory`.
class RefreshEstimator {
 public:
  static constexpr int memory = 128;
  /// Minimum number of swaps for a measurement.
  static constexpr int enough_swaps = 32;
  /// Maximum relative deviation of the measured rate from the nominal one. Swaps that do not wait
  /// for the display, of frames aimed at the estimated refreshes, make the estimate drift away ever
  /// faster.
  static constexpr double rate_tolerance = 0.02;
  /// Maximum root mean square deviation of swaps from refreshes, in refresh intervals; for
  /// unrelated swaps it is 1 / sqrt(12) = 0.29.
  static constexpr double spread_tolerance = 0.2;

  /// nominal_rate_hz: > 0, from the display's profile or the system.
  explicit RefreshEstimator(double nominal_rate_hz);

  /// Records a completed swap. Times ascend. After a pause, refreshes are found anew.
  void swap_completed(Nanoseconds time);

  /// Whether enough swaps were recorded, and they follow the display.
  bool is_measured() const { return swaps_ >= enough_swaps && !is_unsynchronised_; }
  /// Whether swaps were found not to wait for refreshes, or to follow a display of another rate.
  /// Permanent: frames paced by a clock instead record that clock's intervals.
  bool is_unsynchronised() const { return is_unsynchronised_; }

  /// The measured rate so far; nominal if the swaps do not follow the display.
  double rate_hz() const { return 1.0 / interval_s(); }
  Nanoseconds interval() const { return nanoseconds_from_seconds(interval_s()); }

  /// The refresh nearest to `time`, before or after it. Before the first swap, `time` itself.
  Nanoseconds nearest_refresh(Nanoseconds time) const;

 private:
  double interval_s() const { return is_unsynchronised_ ? nominal_interval_s_ : interval_s_; }
  void find_anew(Nanoseconds time);
  /// Judges a swap that deviates by off_s from the refresh at `intervals` after the last one.
  void judge(double intervals, double off_s);
  void follow(double intervals, double off_s);

  double nominal_interval_s_;
  double interval_s_;
  std::optional<Nanoseconds> refresh_;  ///< the last known refresh
  std::uint64_t swaps_ = 0;
  int remembered_ = 0;            ///< number of swaps behind the gains
  double mean_square_off_ = 0.0;  ///< of swaps' deviations, in squared intervals
  bool is_unsynchronised_ = false;
};

}  // namespace foveola
