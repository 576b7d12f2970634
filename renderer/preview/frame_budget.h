// How many samples a frame has time for, learned from what those before it took.
#pragma once

#include <cstdint>

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

}  // namespace foveola
