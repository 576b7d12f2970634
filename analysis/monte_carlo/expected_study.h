// Models an expected study: its design, and distributions for people, scenes and methods, from
// which its records are drawn.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "study/protocol/protocol.h"
#include "study/record/read/study_records.h"

namespace foveola::analysis {

/// The expected times of a mark of the protocol.
struct ExpectedTimes {
  double baseline_s = 0.0;     ///< Geometric mean with the first method; above zero.
  std::vector<double> ratios;  ///< [method]: geometric mean over the first method's, which is 1.
};

/// Standard deviations: of natural logarithms of times, or of ratings in fractions of the scale's
/// width. A gain is the difference between two methods, so that its spread is a
/// method-by-participant or method-by-scene interaction.
struct ExpectedSpread {
  double participants = 0.5;       ///< Between participants, the same with every method.
  double scenes = 0.5;             ///< Between scenes, the same with every method.
  double participants_gain = 0.3;  ///< Of the methods' difference, between participants.
  double scenes_gain = 0.1;        ///< Of the methods' difference, between scenes.
  double trials = 0.35;  ///< Between trials of one participant in one scene with one method.
};

/// The logarithm of a time is normal around the sum of the mark's, the method's, the participant's
/// and the scene's effects; so is a rating, before it is rounded to an answer of its scale and
/// clipped at the ends. A trial's later marks follow from its first one: the logarithm of the ratio
/// of a mark's time to the previous one's varies around its expectation, but never below zero. So a
/// late mark delays the next ones. Without censoring, the mean logarithm of the ratio of two
/// methods' times is exactly that of the expected ratios.
///
/// `times`, `ratios` and `shifts` have the sizes of the protocol's marks, methods and ratings;
/// otherwise behaviour is undefined.
struct ExpectedStudy {
  /// Scenes, methods, marks, ratings, orders, and the time-outs that censor.
  study::Protocol protocol;
  std::vector<ExpectedTimes> times;  ///< [mark]: increasing from mark to mark.
  /// [rating][method]: mean answer above that of the first method, in points.
  std::vector<std::vector<double>> shifts;
  ExpectedSpread times_spread;
  ExpectedSpread ratings_spread{.participants = 0.15,
                                .scenes = 0.05,
                                .participants_gain = 0.1,
                                .scenes_gain = 0.05,
                                .trials = 0.2};
  /// Coefficient of variation, between trials, of the logarithm of a mark's time over that of the
  /// previous mark. With 0 the marks of a trial are fully dependent.
  double later_marks_variation = 0.25;
  double change_per_trial = 0.0;  ///< Change of the logarithm of times; negative: learning.
  double withdrawals = 0.0;       ///< Probability that a participant withdraws.
};

/// Returns the correlation of single log times of a mark with those of the previous mark, with one
/// method of one participant in one scene; `mark` is not the first.
double correlation_with_mark_before(const ExpectedStudy& expected, std::size_t mark,
                                    std::size_t method);

/// Draws records of simulated sessions, complete except withdrawn ones, which have no trials. Equal
/// seeds give equal records; those of the first participants do not depend on the number of
/// participants.
study::StudyRecords draw_study(const ExpectedStudy& expected, std::size_t participants,
                               std::uint64_t seed);

/// Returns the study for checks of intervals and tests: three methods, of which the others take 32
/// and 10 % of the first one's time, in five scenes; the published marks and rating, a third mark,
/// `recognition`, and a rating of 0 to 100, `comfort`. Scenes do not differ in their gain, and no
/// time is right-censored.
ExpectedStudy example_study();

}  // namespace foveola::analysis
