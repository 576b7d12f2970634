// How the figures of two runs of benchmarks compare, and which of them moved.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

/// A number in what a bench command prints with --json.
struct BenchFigure {
  std::string place;  ///< where it stands: "runs[threads=2].seconds"
  double value = 0.0;
  std::optional<Interval> interval;
  bool is_exact = false;
};

/// Whether a member of an array's element tells it from the others, as a name does.
using IsIdentity = bool (*)(std::string_view key, const nlohmann::ordered_json& value);

/// Appends the figures of `node`, which stands at `place`; identities are not figures.
void collect_figures(const nlohmann::ordered_json& node, const std::string& place,
                     IsIdentity is_identity, std::vector<BenchFigure>& figures);

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

struct BenchComparison {
  std::vector<BenchRatio> ratios;      ///< in the order of the earlier run's figures
  std::vector<std::string> differing;  ///< settings and facts: "width: 1024, now 2048"
  std::vector<std::string> unmatched;  ///< figures that only one run has
  double level_of_each = 0.0;          ///< of the intervals that hold together with 95 %

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

}  // namespace foveola::analysis
