#include "renderer/preview/refresh_estimator.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace foveola {
namespace {

/// The nominal rate, and what was measured before a pause, count as much as so many swaps.
constexpr int swaps_believed = 8;

/// The number of whole intervals that is nearest to `duration`.
double intervals_in(Nanoseconds duration, double interval_s) {
  return std::round(seconds(duration) / interval_s);
}

}  // namespace

RefreshEstimator::RefreshEstimator(double nominal_rate_hz)
    : nominal_interval_s_(1.0 / nominal_rate_hz), interval_s_(nominal_interval_s_) {
  assert(nominal_rate_hz > 0.0);
}

void RefreshEstimator::swap_completed(Nanoseconds time) {
  constexpr double longest_pause = 64.0;  // in intervals: then the error of as many adds up
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
  // No two swaps can have waited for the same refresh.
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
  const double farthest_s = 0.25 * interval_s_;  // what strays farther counts no more
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
