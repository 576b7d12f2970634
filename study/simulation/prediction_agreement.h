// A study's main numbers in short, and how well those of a predicted study agree with a rendered
// one's.
#pragma once

#include <string>
#include <vector>

#include "study/record/study_records.h"

namespace foveola::study {

/// Computed over the trials that both studies have, with marks that both have and that no time-out
/// cut off.
struct MarkAgreement {
  std::string mark;    ///< the mark's id
  std::string method;  ///< empty: all methods
  int trials = 0;
  double rendered_median_s = 0.0;
  double predicted_median_s = 0.0;
  double median_ratio = 0.0;      ///< median of predicted over rendered times, trial by trial
  double rank_correlation = 0.0;  ///< Spearman's; 0 for fewer than two trials
};

/// For each mark, of all methods together and of each. Trials are paired by participant, scene and
/// method.
std::vector<MarkAgreement> prediction_agreement(const StudyRecords& rendered,
                                                const StudyRecords& predicted);

/// Spearman's rank correlation, ties sharing their mean rank; 0 for fewer than two pairs, or if all
/// of one side are alike. Both have as many values.
double rank_correlation(const std::vector<double>& a, const std::vector<double>& b);

struct MethodMean {
  std::string mark;  ///< the mark's id
  std::string method;
  int pairs = 0;            ///< trials of the baseline and the method with one person and one scene
  double baseline_s = 0.0;  ///< geometric mean; 0 without pairs
  double percent = 0.0;     ///< geometric mean of the ratios; 0 without pairs
};

/// For each mark, each method but the first, which is the baseline. Trials that a time-out cut off
/// are left out, and what they would be compared with.
std::vector<MethodMean> method_means(const StudyRecords& records);

}  // namespace foveola::study
