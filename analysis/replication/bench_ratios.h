// Compares the figures of two benchmark runs, and finds those that changed.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

/// A number in the --json output of a bench command.
struct BenchFigure {
  std::string place;  ///< its place: "runs[threads=2].seconds"
  double value = 0.0;
  std::optional<Interval> interval;
  bool is_exact = false;
};

/// Returns whether a member identifies its array element, as a name does.
using IsIdentity = bool (*)(std::string_view key, const nlohmann::ordered_json& value);

/// Appends the figures of `node` at `place`; identities are not figures.
void collect_figures(const nlohmann::ordered_json& node, const std::string& place,
                     IsIdentity is_identity, std::vector<BenchFigure>& figures);

/// Known uncertainty of a figure.
enum class BenchFigureKind {
  exact,             ///< a bare number: identical on one machine with one build
  with_interval,     ///< measured, in both runs with a 95 % confidence interval
  without_interval,  ///< measured, without an interval in one of the runs, for want of repetitions
};

enum class BenchMove {
  none,
  alone,     ///< beyond its own 95 % confidence interval, as one figure in twenty is by chance
  together,  ///< beyond the simultaneous interval of all figures
  exactly,   ///< an exact figure differs
  without_interval,  ///< it differs, by an amount of unknown significance
};

struct BenchRatio {
  std::string figure;  ///< its place: "runs[threads=2].seconds"
  double before = 0.0;
  double after = 0.0;
  std::optional<double> ratio;       ///< after / before; empty unless both have the same sign
  std::optional<Interval> interval;  ///< interval of the ratio, if both figures have one
  std::optional<Interval> together;  ///< the same, widened to hold for all figures simultaneously
  BenchFigureKind kind = BenchFigureKind::exact;
  BenchMove move = BenchMove::none;
};

struct BenchComparison {
  std::vector<BenchRatio> ratios;      ///< in the order of the earlier run's figures
  std::vector<std::string> differing;  ///< settings and facts: "width: 1024, now 2048"
  std::vector<std::string> unmatched;  ///< figures that only one run has
  double level_of_each = 0.0;          ///< of the intervals that hold simultaneously with 95 %

  std::size_t count(BenchFigureKind kind) const;
  std::vector<BenchRatio> moved(BenchMove move) const;
};

/// Compares the --json outputs of two runs of a bench command. Elements of arrays are matched by
/// name, scene, gaze, configuration, region, metric, level, kind, threads and so on, whatever their
/// order. Figures are the numbers in top-level arrays and the measured ones ({"value": 3, "low": 2,
/// "high": 4}, "median" or "percent" for "value", null for unknown ends) at the top. Everything
/// else is a setting, except the date. The interval is that of a ratio of independent estimates, on
/// the logarithm (Zou and Donner 2008, "Construction of confidence limits about effect measures",
/// eq. 9 for a difference). If a ratio has none, as around 0, the difference decides whether the
/// figure changed. The simultaneous intervals have the level 0.95^(1/n) of Sidak (1967) for n
/// figures, and are widened as normal logarithms are. Names name the texts in errors. Throws Error
/// for a text that is not a JSON object, and if the two have no figure in common.
BenchComparison compare_benches(const std::string& before, const std::string& before_name,
                                const std::string& after, const std::string& after_name);

}  // namespace foveola::analysis
