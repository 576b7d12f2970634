// Summarises studies, and compares a predicted study with a rendered one.
#pragma once

#include <string>
#include <vector>

#include "study/record/read/study_records.h"

namespace foveola::study {

/// Agreement over the trials that both studies have, with marks that are censored in neither.
struct MarkAgreement {
  std::string mark;    ///< the mark's id
  std::string method;  ///< empty: all methods
  int trials = 0;
  double rendered_median_s = 0.0;
  double predicted_median_s = 0.0;
  double median_ratio = 0.0;      ///< median of predicted over rendered times, trial by trial
  double rank_correlation = 0.0;  ///< Spearman's; 0 for fewer than two trials
};

/// Returns an entry per mark for all methods together and for each. Trials are paired by
/// participant, scene and method.
std::vector<MarkAgreement> prediction_agreement(const StudyRecords& rendered,
                                                const StudyRecords& predicted);

/// Returns Spearman's rank correlation, with mean ranks of ties; 0 for fewer than two pairs, or if
/// all values of one side are equal. Both have as many values.
double rank_correlation(const std::vector<double>& a, const std::vector<double>& b);

struct MethodMean {
  std::string mark;  ///< the mark's id
  std::string method;
  int pairs =
      0;  ///< pairs of trials, of the baseline and the method, with the same person and scene
  double baseline_s = 0.0;  ///< geometric mean; 0 without pairs
  double percent = 0.0;     ///< geometric mean of the ratios; 0 without pairs
};

/// Returns an entry per mark and method except the first, the baseline. Pairs with a censored time
/// are left out.
std::vector<MethodMean> method_means(const StudyRecords& records);

}  // namespace foveola::study
