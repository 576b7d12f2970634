#include "renderer/base/numbers/exact_sum.h"

#include <cmath>
#include <utility>

namespace foveola {
namespace {

/// A rounded sum and its error: together they are exact (Shewchuk 1997, figure 4).
struct TwoSum {
  double sum;
  double rest;
};

TwoSum two_sum(double a, double b) {
  if (std::abs(a) < std::abs(b)) {
    std::swap(a, b);
  }
  const double sum = a + b;
  return {.sum = sum, .rest = b - (sum - a)};
}

}  // namespace

void ExactSum::add(double value) {
  std::size_t kept = 0;
  for (const double part : parts_) {
    const auto [sum, rest] = two_sum(value, part);
    if (rest != 0.0) {
      parts_[kept++] = rest;
    }
    value = sum;
  }
  parts_.resize(kept);
  if (value != 0.0) {
    parts_.push_back(value);
  }
}

void ExactSum::add(const ExactSum& other) {
  for (const double part : other.parts_) {
    add(part);
  }
}

double ExactSum::rounded() const {
  if (parts_.empty()) {
    return 0.0;
  }
  // From the largest down, until something is lost: then the rest decides a tie.
  std::size_t next = parts_.size() - 1;
  double sum = parts_[next];
  double rest = 0.0;
  while (next > 0 && rest == 0.0) {
    const TwoSum step = two_sum(sum, parts_[--next]);
    sum = step.sum;
    rest = step.rest;
  }
  const bool is_tie_to_break = next > 0 && (rest < 0.0) == (parts_[next - 1] < 0.0);
  if (is_tie_to_break) {
    const double twice = 2.0 * rest;
    const double other = sum + twice;
    if (twice == other - sum) {
      return other;
    }
  }
  return sum;
}

}  // namespace foveola
