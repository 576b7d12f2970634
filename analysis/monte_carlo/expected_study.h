// A study before there are data: its design, and a model of what is expected of people, scenes and
// methods, from which its records are drawn.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "study/protocol/protocol.h"
#include "study/record/study_records.h"

namespace foveola::analysis {

/// How long a mark of the protocol is expected to take.
struct ExpectedTimes {
  double baseline_s = 0.0;     ///< Geometric mean with the first method; above zero.
  std::vector<double> ratios;  ///< [method]: geometric mean over the first method's, which is 1.
};

/// How much people, scenes and trials differ. Of times, standard deviations of natural logarithms;
/// of ratings, parts of the width of the scale. A gain is the difference between two methods.
struct ExpectedSpread {
  double participants = 0.5;
  double scenes = 0.5;
  double participants_gain = 0.3;
  double scenes_gain = 0.1;
  double trials = 0.35;  ///< Between trials of one participant in one scene with one method.
};

/// The logarithm of a time is normal around the sum of the mark's, the method's, the participant's
/// and the scene's effects; so is a rating, before it is rounded to an answer of its scale and cut
/// off at the ends. A trial's later marks follow from its first one: the logarithm of the ratio of
/// a mark's time to the one before varies around its expectation, but never below zero. So what
/// comes late in one mark comes late in the next, and the mean logarithm of the ratio of two
/// methods' times is exactly that of the expected ratios, as long as no time is right-censored.
struct ExpectedStudy {
  /// Scenes, methods, marks, ratings, orders, and the time-outs that censor.
  study::Protocol protocol;
  std::vector<ExpectedTimes> times;  ///< [mark]: longer than those of the mark before.
  /// [rating][method], in points: the mean answer above that of the first method.
  std::vector<std::vector<double>> shifts;
  ExpectedSpread times_spread;
  ExpectedSpread ratings_spread{.participants = 0.15,
                                .scenes = 0.05,
                                .participants_gain = 0.1,
                                .scenes_gain = 0.05,
                                .trials = 0.2};
  /// Coefficient of variation, between trials, of the logarithm of a mark's time over that of the
  /// mark before. With 0 the marks of a trial depend on each other entirely.
  double later_marks_variation = 0.25;
  double change_per_trial = 0.0;  ///< Of the logarithm of times; learning if below zero.
  double withdrawals = 0.0;       ///< The probability that a participant withdraws.
};

/// The correlation of single log times of a mark with those of the mark before, with one method of
/// one participant in one scene; `mark` is not the first.
double correlation_with_mark_before(const ExpectedStudy& expected, std::size_t mark,
                                    std::size_t method);

/// Records of simulated sessions, complete but for those that were withdrawn, which have no trials.
/// Same seed, same records; those of the first participants do not depend on how many there are.
study::StudyRecords draw_study(const ExpectedStudy& expected, std::size_t participants,
                               std::uint64_t seed);

/// What intervals and tests are checked with: three methods, of which the others take 32 and 10 %
/// of the first one's time, in five scenes; the published marks and rating, a third mark,
/// `recognition`, and a rating of 0 to 100, `comfort`. Scenes do not differ in their gain, and no
/// time is right-censored.
ExpectedStudy example_study();

}  // namespace foveola::analysis
