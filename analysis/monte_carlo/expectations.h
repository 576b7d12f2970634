// What a planner expects of a study by a protocol, and what a pilot shows of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/monte_carlo/expected_study.h"
#include "study/record/study_records.h"

namespace foveola::analysis {

/// What is expected of one measure with one method: of a mark, its time in per cent of that with
/// the first method; of a rating, the points that its answers lie above those with the first.
struct MeasureExpectation {
  std::string measure;
  std::string method;
  double value = 0.0;
};

/// Reads "MEASURE:METHOD:VALUE", as "material:fv:25"; METHOD may have colons in it. Throws
/// UsageError.
MeasureExpectation parse_expectation(const std::string& text);

struct Expectations {
  /// The time with each method but the first, in per cent of that with the first, for all marks.
  double ratio_percent = 50.0;
  std::vector<MeasureExpectation> measures;  ///< Take the place of it.
  /// Geometric means of times with the first method, mark by mark; each mark that is not there
  /// takes twice as long as the one before.
  std::optional<std::vector<double>> baseline_s;
  // Factors, from 1, by which ratios or times vary: two thirds lie within it.
  std::optional<double> participants_factor;  ///< Of participants' own ratios between methods.
  std::optional<double> scenes_factor;        ///< Of scenes' own ratios.
  std::optional<double> trials_factor;        ///< Of single times.
  /// ExpectedStudy::later_marks_variation, by which the marks of a trial depend on each other.
  std::optional<double> mark_variation;
  std::optional<double> withdrawals;  ///< The probability that a participant withdraws.
  std::optional<int> scenes;          ///< Their number, if not that of the protocol.
};

/// The study that is expected. What is not stated takes the default, or, with a pilot of the same
/// protocol, what its times and ratings show: geometric means with the first method, the variances
/// of people, scenes and trials (crossed_model, averaged over marks and methods), and the share of
/// participants who withdrew; effects are never taken from it. Throws Error for a value that is
/// impossible, for marks that would not come one after the other, and if nothing is expected of a
/// planned comparison.
ExpectedStudy expect(const study::Protocol& protocol, const Expectations& expectations,
                     const study::StudyRecords* pilot = nullptr);

}  // namespace foveola::analysis
