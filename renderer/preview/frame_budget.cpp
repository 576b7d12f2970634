#include "renderer/preview/frame_budget.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace foveola {
namespace {

/// Weight of the nominal rate, and of measurements before a pause, in swaps.
constexpr int swaps_believed = 8;

/// Number of whole intervals nearest to `duration`.
double intervals_in(Nanoseconds duration, double interval_s) {
  return std::round(seconds(duration) / interval_s);
}

}  // namespace

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

Nanoseconds FrameBudget::begin_frame(Nanoseconds left, Nanoseconds interval) {
  interval_s_ = seconds(interval);
  if (!is_drawing_too_slow_) {
    return left;
  }
  const double default_rest_s = rest_s_.usual();
  // As every frame is late, none keeps a reserve.
  const double kept_s = rest_s_.seldom_exceeded() - default_rest_s + reserve_s_;
  return left +
         nanoseconds_from_seconds((refreshes_for(default_rest_s) - 1.0) * interval_s_ + kept_s);
}

double FrameBudget::refreshes_for(double rest_s) const {
  // A little less than half: batches leave some time unused, and some frames end one refresh later
  // than aimed at.
  constexpr double largest_rest_share = 0.45;
  const double wanted_rest_share = std::min(1.0 - traced_share_, largest_rest_share);
  const double wanted = std::ceil(rest_s / (wanted_rest_share * interval_s_));
  const double longest_wanted = std::floor(longest_wanted_frame_s / interval_s_);
  const double fewest = std::ceil(rest_s / (largest_rest_share * interval_s_));
  return std::max({std::min(wanted, longest_wanted), fewest, 1.0});
}

std::uint64_t FrameBudget::first_batch(Nanoseconds left) const {
  // If drawing is too slow, few batches matter more than being in time.
  const double share = is_drawing_too_slow_ ? 1.0 : 0.75;
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
  const double shortest_s = is_drawing_too_slow_ ? 2.5e-3 : 2.5e-4;
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
  judge_drawing();
  if (is_drawing_too_slow_) {
    return;  // late on purpose
  }
  const double change_s = is_late ? step_s : -step_s * late_share / (1.0 - late_share);
  reserve_s_ = std::clamp(reserve_s_ + change_s, 0.0, largest_s);
}

FrameBudget FrameBudget::for_another_preview() const {
  FrameBudget budget(traced_share_);
  if (is_drawing_too_slow_) {
    budget.rest_s_ = rest_s_;
    budget.slow_share_ = slow_share_;
    budget.is_drawing_too_slow_ = true;
  }
  return budget;
}

void FrameBudget::judge_drawing() {
  constexpr double gain = 1.0 / 16.0;
  constexpr double max_slow = 0.75;    // reached by 22 slow frames in a row
  constexpr double hysteresis = 0.78;  // factor below which it is fast again
  const double longest_rest_s = (1.0 - traced_share_) * interval_s_;
  const bool is_slow = interval_s_ > 0.0 && rest_s_.mean() >= longest_rest_s;
  slow_share_ += gain * ((is_slow ? 1.0 : 0.0) - slow_share_);
  is_drawing_too_slow_ =
      is_drawing_too_slow_ ? rest_s_.mean() >= hysteresis * longest_rest_s : slow_share_ > max_slow;
}

double FrameBudget::samples_in(Nanoseconds left) const {
  const double left_s = seconds(left) - rest_s_.seldom_exceeded() - reserve_s_;
  if (sample_s_.empty() || left_s <= 0.0) {
    return 0.0;
  }
  return left_s / (is_drawing_too_slow_ ? sample_s_.usual() : sample_s_.seldom_exceeded());
}

RefreshEstimator::RefreshEstimator(double nominal_rate_hz)
    : nominal_interval_s_(1.0 / nominal_rate_hz), interval_s_(nominal_interval_s_) {
  assert(nominal_rate_hz > 0.0);
}

void RefreshEstimator::swap_completed(Nanoseconds time) {
  constexpr double longest_pause = 64.0;  // in intervals: the error of as many adds up
  if (is_unsynchronised_) {
    return;
  }
  ++swaps_;
  const double intervals = refresh_ ? intervals_in(time - *refresh_, interval_s_) : longest_pause;
  if (intervals >= longest_pause) {
    find_anew(time);
    return;
  }
  const double off_s = seconds(time - *refresh_) - intervals * interval_s_;
  judge(intervals, off_s);
  follow(intervals, off_s);
}

void RefreshEstimator::find_anew(Nanoseconds time) {
  refresh_ = time;
  remembered_ = swaps_believed;
}

void RefreshEstimator::judge(double intervals, double off_s) {
  // Two swaps cannot have waited for the same refresh.
  constexpr double farthest_off = 0.5;
  const double off = intervals < 1.0 ? farthest_off : off_s / interval_s_;
  const auto judged = static_cast<double>(std::min<std::uint64_t>(swaps_, memory));
  mean_square_off_ += (off * off - mean_square_off_) / judged;
  const double rate_off = std::abs(nominal_interval_s_ / interval_s_ - 1.0);
  is_unsynchronised_ =
      swaps_ >= enough_swaps &&
      (rate_off > rate_tolerance || mean_square_off_ > spread_tolerance * spread_tolerance);
}

void RefreshEstimator::follow(double intervals, double off_s) {
  remembered_ = std::min(remembered_ + 1, memory);
  const double n = remembered_;
  const double alpha = 2.0 * (2.0 * n - 1.0) / (n * (n + 1.0));
  const double beta = 6.0 / (n * (n + 1.0));
  const double farthest_s = 0.25 * interval_s_;  // larger deviations are clamped
  const double counted_s = std::clamp(off_s, -farthest_s, farthest_s);
  *refresh_ += nanoseconds_from_seconds(intervals * interval_s_ + alpha * counted_s);
  interval_s_ += beta * counted_s / std::max(intervals, 1.0);
}

Nanoseconds RefreshEstimator::nearest_refresh(Nanoseconds time) const {
  if (!refresh_) {
    return time;
  }
  const double intervals = intervals_in(time - *refresh_, interval_s());
  return *refresh_ + nanoseconds_from_seconds(intervals * interval_s());
}

}  // namespace foveola
