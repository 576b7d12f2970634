// A sum of doubles that does not depend on their order.
#pragma once

#include <cstddef>
#include <vector>

namespace foveola {

/// Keeps the exact sum of doubles as doubles whose bits do not overlap (Shewchuk 1997, "Adaptive
/// precision floating-point arithmetic and fast robust geometric predicates", figure 6). They and
/// their sum must be finite.
class ExactSum {
 public:
  void add(double value);
  void add(const ExactSum& other);

  /// The double nearest to the sum; ties go to the even one.
  double rounded() const;

  void clear() { parts_.clear(); }

 private:
  std::vector<double> parts_;  ///< from the smallest to the largest, without zeros
};

}  // namespace foveola
