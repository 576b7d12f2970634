// How many samples a frame has time for, learned from what those before it took, and when a display
// refreshes: measured, not assumed.
#pragma once

#include <cstdint>
#include <optional>

#include "renderer/base/clock.h"

namespace foveola {

/// A cost that varies: its smoothed mean, and what it seldom exceeds, which is that and four
/// smoothed deviations, as a packet's round trip in TCP (Jacobson 1988, "Congestion Avoidance and
/// Control", appendix A; RFC 6298, section 2).
class CostEstimate {
 public:
  void add(double cost);
  bool empty() const { return count_ == 0; }
  double mean() const { return mean_; }
  /// What it exceeds now and then: one deviation more than its mean.
  double usual() const { return mean_ + deviation_; }
  double seldom_exceeded() const { return mean_ + 4.0 * deviation_; }

 private:
  std::uint64_t count_ = 0;
  double mean_ = 0.0;
  double deviation_ = 0.0;
};

/// Cuts a frame's tracing into batches: a large one, and then what fits the time that is left. A
/// frame's deadline is then missed only by what the last one takes longer than expected.
///
/// Where drawing leaves less of the time between two refreshes than is wanted for tracing, frame
/// after frame, frames aim at a later refresh: so that tracing has the wanted part of each as long
/// as frames take no more than longest_wanted_frame_s, and at least half in any case.
class FrameBudget {
 public:
  /// What is traced while nothing is known of the machine and the scene.
  static constexpr std::uint64_t first_of_all = 1024;
  /// What is wanted where drawing takes no time from tracing, as on a graphics card: frames in
  /// time.
  static constexpr double least_share = 0.1;
  /// What is wanted where both are the processor's work.
  static constexpr double shared_processor_share = 2.0 / 3.0;
  static constexpr double longest_wanted_frame_s = 1.0 / 15.0;

  /// traced_share: the part of the time between two refreshes that is to be left for tracing, in
  /// [least_share, 0.9].
  explicit FrameBudget(double traced_share = least_share) : traced_share_(traced_share) {}

  /// A frame begins, `left` before its deadline, on a display that refreshes every `interval`.
  /// Returns what its batches are to take for the time left: `left`, or more if drawing is too
  /// slow.
  Nanoseconds begin_frame(Nanoseconds left, Nanoseconds interval);

  /// How many samples the frame's first batch has, `left` before its deadline. There are some
  /// however late it is, so that a restart is seen in the next frame: what is traced within a
  /// millisecond, but at least 64 and at most first_of_all.
  std::uint64_t first_batch(Nanoseconds left) const;
  /// How many samples the next batch has; 0 if there is no time for one that is worth its
  /// beginning: what is traced within a quarter of a millisecond or, where drawing is too slow, ten
  /// times that.
  std::uint64_t next_batch(Nanoseconds left) const;

  /// What a batch of `samples` took from directions to film; samples > 0.
  void batch_took(std::uint64_t samples, Nanoseconds time);
  /// What the frame took between its last batch and its deadline's event.
  void rest_took(Nanoseconds time);
  /// Whether the frame missed its deadline. Time is kept in reserve so that one of 200 does: more
  /// after each that was late, less after the others (Robbins and Monro 1951, "A stochastic
  /// approximation method").
  void frame_ended(bool is_late);

  /// Whether the rest of frames leaves tracing too little between two refreshes. It takes a few
  /// dozen such frames in a row to say so, and a rest that is clearly shorter to take it back.
  bool is_drawing_too_slow() const { return is_drawing_too_slow_; }
  /// A budget to begin another preview with in the same window: one that has to learn what samples
  /// cost, but knows already if drawing is too slow.
  FrameBudget for_another_preview() const;
  /// What the rest of a frame takes on average; 0 before the first.
  Nanoseconds drawing_time() const { return nanoseconds_from_seconds(rest_s_.mean()); }

 private:
  /// Judges by a frame that ended.
  void judge_drawing();
  /// Refreshes that a frame takes if its rest takes so long.
  double refreshes_for(double rest_s) const;
  /// Samples that are done in time, were they traced now.
  double samples_in(Nanoseconds left) const;
  /// Samples that take so long, on average.
  double samples_for(double time_s) const { return time_s / sample_s_.mean(); }

  double traced_share_;
  CostEstimate sample_s_;
  CostEstimate rest_s_;
  double reserve_s_ = 0.0;
  double interval_s_ = 0.0;  ///< time between refreshes, in the frame that began last
  double slow_share_ = 0.0;  ///< smoothed share of frames whose rest took too long
  bool is_drawing_too_slow_ = false;
};

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
