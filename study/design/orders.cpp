#include "study/design/orders.h"

#include <cassert>
#include <cstddef>
#include <numeric>

namespace foveola::study {
namespace {

Permutation counted_up(int n) {
  Permutation row(static_cast<std::size_t>(n));
  std::iota(row.begin(), row.end(), 0);
  return row;
}

/// Returns the square's row, modulo their number.
Permutation shifted(Permutation row, int by) {
  const int n = static_cast<int>(row.size());
  for (int& thing : row) {
    thing = (thing + by) % n;
  }
  return row;
}

/// Returns 0, 1, n-1, 2, n-2, ...: all differences of neighbours are different.
Permutation zigzag(int n) {
  Permutation row;
  for (int i = 0; i < n; ++i) {
    row.push_back(i % 2 == 1 ? (i + 1) / 2 : (n - i / 2) % n);
  }
  return row;
}

Square shifts_of(const Permutation& first) {
  Square square;
  for (int by = 0; by < static_cast<int>(first.size()); ++by) {
    square.push_back(shifted(first, by));
  }
  return square;
}

/// Returns the square of an order; without rows for random orders.
Square square_of(Order order, int n) {
  switch (order) {
    case Order::fixed:
      return {counted_up(n)};
    case Order::latin:
      return cyclic_square(n);
    case Order::williams:
      return williams_square(n);
    case Order::random:
      break;
  }
  return {};
}

}  // namespace

Square cyclic_square(int n) { return shifts_of(counted_up(n)); }

Square williams_square(int n) {
  Square square = shifts_of(zigzag(n));
  const bool is_balanced = n % 2 == 0 || n == 1;
  for (int i = 0; i < n && !is_balanced; ++i) {
    square.emplace_back(square[i].rbegin(), square[i].rend());
  }
  return square;
}

int row_count(Order order, int n) { return static_cast<int>(square_of(order, n).size()); }

Permutation row_of(Order order, int n, int row) {
  const Square square = square_of(order, n);
  assert(!square.empty());
  return square[static_cast<std::size_t>(row) % square.size()];
}

Permutation crossed_row_of(Order order, int n, int scene, int row) {
  const int rows = row_count(order, n);
  const int halves = rows / n;
  if (halves == 0) {  // one fixed order
    return row_of(order, n, row);
  }
  const int first_row = n * (scene / n % halves);
  return shifted(row_of(order, n, row % rows + first_row), scene % n);
}

}  // namespace foveola::study
