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
  double seldom_exceeded() const { return mean_ + 4.0 * deviation_; }

 private:
  std::uint64_t count_ = 0;
  double mean_ = 0.0;
  double deviation_ = 0.0;
};

/// Cuts a frame's tracing into two batches: a large one, and one that fits what time it left. A
/// frame's deadline is then missed only by what the second takes longer than expected.
class FrameBudget {
 public:
  /// The first batch of every frame has at least so many samples, however late it is: a restart is
  /// seen in the next frame.
  static constexpr std::uint64_t smallest_batch = 1024;

  /// How many samples the frame's first batch has, `left` before its deadline.
  std::uint64_t first_batch(Nanoseconds left) const;
  /// And the second; 0 if there is no time for one.
  std::uint64_t second_batch(Nanoseconds left) const;

  /// What a batch of `samples` took from directions to film; samples > 0.
  void batch_took(std::uint64_t samples, Nanoseconds time);
  /// What the frame took between its last batch and its deadline's event.
  void rest_took(Nanoseconds time);
  /// Whether the frame missed its deadline. Time is kept in reserve so that one of 200 does: more
  /// after each that was late, less after the others (Robbins and Monro 1951, "A stochastic
  /// approximation method").
  void frame_ended(bool is_late);

 private:
  /// Samples that are done in time, were they traced now.
  double samples_in(Nanoseconds left) const;

  CostEstimate sample_s_;
  CostEstimate rest_s_;
  double reserve_s_ = 0.0;
};

}  // namespace foveola
