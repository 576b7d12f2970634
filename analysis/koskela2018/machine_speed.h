// Fits the simulated machine's speed, in samples per second, at which OD's mean times match Table 2
// of the paper. Only OD's times are used.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/koskela2018/published_comparison.h"

namespace foveola::analysis {

/// Returns OD's cells of Table 2, of `mark`, or of all marks if it is empty. Throws Error if there
/// are none, or the study lacks one.
std::vector<ComparedNumber> baseline_cells(const std::vector<ComparedNumber>& numbers,
                                           const std::string& mark);

/// Returns each scene's mean of ln(study's mean / published mean) over its cells, in the order of
/// the scenes. Every cell has a number of the study, as those of baseline_cells.
std::vector<double> log_ratios_of_scenes(const std::vector<ComparedNumber>& cells);

struct MachineSpeed {
  double samples_per_second = 0.0;
  /// 95 % confidence interval over scenes; empty with fewer than two, or if they do not vary.
  std::optional<Interval> interval;
};

/// Compares a study on a machine of this speed with the paper; see compare_with_published.
using CompareAtSpeed = std::function<std::vector<ComparedNumber>(double samples_per_second)>;

/// Returns the speed at which the mean over the cells of ln(study's mean / published mean) is 0.
/// Both are arithmetic means over participants, and each cell has the same weight. The search is
/// Newton's method on the logarithm of the speed. It begins at `first` (> 0) and ends at a mean
/// within 0.002.
///
/// The interval is Student's, of the mean of log_ratios_of_scenes at that speed. Its limits are
/// converted to speeds by the slope of the mean over ln(speed), which is measured with a machine
/// that is faster by a tenth. The interval generalises to other scenes and participants. For a mark
/// alone, speed and interval are fitted to its own cells.
///
/// Throws Error as baseline_cells, if a faster machine does not make times shorter, or if no speed
/// is found in 13 studies.
MachineSpeed fit_machine_speed(const CompareAtSpeed& compare, double first,
                               const std::string& mark = "");

}  // namespace foveola::analysis
