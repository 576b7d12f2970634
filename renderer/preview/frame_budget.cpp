#include "renderer/preview/frame_budget.h"

#include <algorithm>
#include <cmath>

namespace foveola {

void CostEstimate::add(double cost) {
  // RFC 6298's gains: 1/8 for the mean, 1/4 for the deviation, which is first of the old mean.
  constexpr double mean_gain = 0.125;
  constexpr double deviation_gain = 0.25;
  if (count_++ == 0) {
    mean_ = cost;
    deviation_ = 0.5 * cost;
    return;
  }
  deviation_ += deviation_gain * (std::abs(cost - mean_) - deviation_);
  mean_ += mean_gain * (cost - mean_);
}

std::uint64_t FrameBudget::first_batch(Nanoseconds left) const {
  constexpr double share = 0.75;
  constexpr double fewest = 64.0;
  constexpr double shortest_s = 1e-3;
  if (sample_s_.empty()) {
    return first_of_all;
  }
  const double at_least =
      std::clamp(samples_for(shortest_s), fewest, static_cast<double>(first_of_all));
  return static_cast<std::uint64_t>(std::max(at_least, share * samples_in(left)));
}

std::uint64_t FrameBudget::next_batch(Nanoseconds left) const {
  constexpr double shortest_s = 2.5e-4;
  const double samples = samples_in(left);
  return samples >= 1.0 && samples >= samples_for(shortest_s) ? static_cast<std::uint64_t>(samples)
                                                              : 0;
}

void FrameBudget::batch_took(std::uint64_t samples, Nanoseconds time) {
  sample_s_.add(seconds(time) / static_cast<double>(samples));
}

void FrameBudget::rest_took(Nanoseconds time) { rest_s_.add(seconds(time)); }

void FrameBudget::frame_ended(bool is_late) {
  constexpr double late_share = 0.005;
  constexpr double step_s = 2e-4;
  constexpr double largest_s = 5e-3;
  const double change_s = is_late ? step_s : -step_s * late_share / (1.0 - late_share);
  reserve_s_ = std::clamp(reserve_s_ + change_s, 0.0, largest_s);
}

double FrameBudget::samples_in(Nanoseconds left) const {
  const double left_s = seconds(left) - rest_s_.seldom_exceeded() - reserve_s_;
  return sample_s_.empty() || left_s <= 0.0 ? 0.0 : left_s / sample_s_.seldom_exceeded();
}

}  // namespace foveola
