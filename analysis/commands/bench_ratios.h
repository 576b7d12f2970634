// How the figures of two runs of benchmarks compare, and which of them moved.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

/// What is known of a figure's uncertainty.
enum class BenchFigureKind {
  exact,             ///< a bare number: the same to the last bit on one machine with one build
  with_interval,     ///< measured, in both runs with a 95 % interval
  without_interval,  ///< measured, in one of the runs too seldom for an interval
};

enum class BenchMove {
  none,
  alone,             ///< beyond its own 95 % interval, as one figure in twenty is by chance
  together,          ///< beyond the interval that holds for all figures together
  exactly,           ///< an exact figure differs
  without_interval,  ///< it differs, and nobody knows by how much it would by chance
};

/// A figure that both runs have.
struct BenchRatio {
  std::string figure;  ///< where it stands: "runs[threads=2].seconds"
  double before = 0.0;
  double after = 0.0;
  std::optional<double> ratio;       ///< after / before; none unless both have the same sign
  std::optional<Interval> interval;  ///< the ratio's, where both figures have one of their own
  std::optional<Interval> together;  ///< the same, widened to hold for all figures together
  BenchFigureKind kind = BenchFigureKind::exact;
  BenchMove move = BenchMove::none;
};

/// A setting, or a fact of the machine or the program, that is not the same in both runs.
struct BenchDifference {
  std::string text;                ///< "width: 1024, now 2048"
  std::vector<std::string> files;  ///< of folders, those in which it differs
};

struct BenchComparison {
  std::vector<BenchRatio> ratios;  ///< in the order of the earlier run's figures
  std::vector<BenchDifference> differing;
  std::vector<std::string> unmatched;    ///< figures that only one run has
  std::vector<std::string> only_before;  ///< of folders, files that the other has not
  std::vector<std::string> only_after;
  double level_of_each = 0.0;  ///< of the intervals that hold together with 95 %

  std::size_t count(BenchFigureKind kind) const;
  std::vector<BenchRatio> moved(BenchMove move) const;
};

/// Compares what any of the bench commands prints with --json. The elements of arrays belong
/// together if they are of the same name, scene, gaze, configuration, region, metric, level, kind,
/// threads and so on, wherever they stand; figures are the numbers in top-level arrays and the
/// measured ones ({"value": 3, "low": 2, "high": 4}, "median" or "percent" for "value", null for
/// ends that are not known) at the top. Everything else is a setting, but for the date. The
/// interval is that of a ratio of independent estimates, on the logarithm (Zou and Donner 2008,
/// "Construction of confidence limits about effect measures", eq. 9 for a difference); where a
/// ratio has none, as of numbers around 0, the difference says whether the figure moved. The
/// intervals that hold together have the level 0.95^(1/n) of Sidak (1967) for n figures, and are as
/// much wider as those of normal logarithms. Names name the texts in errors. Throws Error for what
/// is no JSON object, and if the two have no figure in common.
BenchComparison compare_benches(const std::string& before, const std::string& before_name,
                                const std::string& after, const std::string& after_name);

/// The same of two files, or of the .json files of the same names in two folders, all of whose
/// figures are judged together. Throws Error too for a folder beside a file, and for two folders
/// without a file of the same name.
BenchComparison compare_bench_files(const std::string& before, const std::string& after);

}  // namespace foveola::analysis
