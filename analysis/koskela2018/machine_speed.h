// Fits the simulated machine's speed, in samples per second, at which OD's times are those of the
// paper's Table 2. Nothing of VP or FV is used.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/koskela2018/published_comparison.h"

namespace foveola::analysis {

/// Returns OD's cells of Table 2, of one mark, or, without a mark, of both. Throws Error if the
/// study lacks any.
std::vector<ComparedNumber> baseline_cells(const std::vector<ComparedNumber>& numbers,
                                           const std::string& mark);

/// Returns ln(study's mean / published mean), the mean over each scene's cells, in the order of the
/// scenes.
std::vector<double> log_ratios_of_scenes(const std::vector<ComparedNumber>& cells);

struct MachineSpeed {
  double samples_per_second = 0.0;
  /// Over scenes; empty with fewer than two, or if they do not vary.
  std::optional<Interval> interval;
};

/// Compares a study on a machine of this speed with the paper; see compare_with_published.
using CompareAtSpeed = std::function<std::vector<ComparedNumber>(double samples_per_second)>;

/// Returns the speed at which the mean over the cells of ln(study's mean / published mean) is 0.
/// Both are arithmetic means over participants, and each cell has the same weight. Found by
/// Newton's method on the logarithm of the speed, from `first` on, to 0.2 %.
///
/// Interval: Student's of the mean of log_ratios_of_scenes at that speed, with one degree of
/// freedom less than there are scenes, divided by the slope of that mean over the speed's
/// logarithm, which is taken from a machine faster by a tenth. So it generalises to other scenes
/// and other participants; that of one mark alone is fitted separately.
///
/// Throws Error if times do not depend on the speed, or if it is not found in a dozen studies.
MachineSpeed fit_machine_speed(const CompareAtSpeed& compare, double first,
                               const std::string& mark = "");

}  // namespace foveola::analysis
