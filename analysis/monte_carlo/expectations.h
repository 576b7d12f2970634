// A planner's expectations of a study by a protocol, and estimates from a pilot.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/monte_carlo/expected_study.h"
#include "study/record/read/study_records.h"

namespace foveola::analysis {

/// The expectation of one measure with one method. Of a mark: its time in per cent of that with the
/// first method. Of a rating: its mean answer above that with the first method, in points.
struct MeasureExpectation {
  std::string measure;
  std::string method;
  double value = 0.0;
};

/// Parses "MEASURE:METHOD:VALUE", as "material:fv:25"; METHOD may contain colons. Throws
/// UsageError.
MeasureExpectation parse_expectation(const std::string& text);

struct Expectations {
  /// Time with each method but the first, in per cent of that with the first, for all marks.
  double ratio_percent = 50.0;
  std::vector<MeasureExpectation> measures;  ///< Override ratio_percent.
  /// Geometric means of times with the first method, by mark. Each missing mark takes twice as long
  /// as the previous one.
  std::optional<std::vector<double>> baseline_s;
  // Geometric standard deviations, from 1, of ratios or times.
  std::optional<double> participants_factor;  ///< Of participants' own ratios between methods.
  std::optional<double> scenes_factor;        ///< Of scenes' own ratios.
  std::optional<double> trials_factor;        ///< Of single times.
  /// ExpectedStudy::later_marks_variation, by which the marks of a trial depend on each other.
  std::optional<double> mark_variation;
  std::optional<double> withdrawals;  ///< Probability that a participant withdraws.
  std::optional<int> scenes;          ///< Number of scenes, if not the protocol's.
};

/// Returns the expected study. Unstated expectations take the default, or, with a pilot of the same
/// protocol, estimates from it: geometric means with the first method, the variances of people,
/// scenes and trials (crossed_model, averaged over marks and methods), and the share of
/// participants who withdrew; effects are never estimated. Throws Error for an impossible value,
/// for marks out of order, and if a planned comparison has no expectation.
ExpectedStudy expect(const study::Protocol& protocol, const Expectations& expectations,
                     const study::StudyRecords* pilot = nullptr);

}  // namespace foveola::analysis
