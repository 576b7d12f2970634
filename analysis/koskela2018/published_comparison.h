// Compares a study with the published one (Koskela et al. 2018), number by number.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/dataset/study_tables.h"
#include "analysis/koskela2018/published_study.h"
#include "study/record/read/study_records.h"

namespace foveola::analysis {

/// One number of the paper beside this study's, with the standard deviation of the same values if
/// the paper has one.
struct ComparedNumber {
  /// "Table 1", "Table 2", "Table 2, all scenes" (the geometric mean over its scenes, computed by
  /// us), or "text".
  std::string source;
  std::string section;  ///< Of the paper, as "5.2".
  std::string row;      ///< A question, a published scene, "all scenes", or the text's statement.
  std::string own_row;  ///< The compared question or scene of this study; may be empty.
  std::string mark;     ///< Empty if there is none, as in Table 1.
  std::string method;   ///< Likewise.
  /// The formula of this study's percentage: "own ratios" or "ratio of means", of which the paper
  /// does not say which is its own; "geometric mean" over participants and scenes; of P "Pearson's
  /// r".
  std::string reading;
  std::string unit;
  Estimate published;  ///< With an interval if the paper has a mean and its deviation.
  std::optional<double> published_deviation;
  std::optional<Estimate> study;  ///< Empty if this study has no such number.
  std::optional<double> study_deviation;
};

/// Returns Tables 1 and 2, the latter in each reading, its geometric means over scenes, and the
/// numbers of sections 5, 5.1 and 5.2. A published scene's row is the study's scene of that name,
/// else Foveola's counterpart of it.
std::vector<ComparedNumber> compare_with_published(const study::StudyRecords& records,
                                                   const StudyTables& tables,
                                                   const PublishedStudy& published);

/// Returns the study's number less the published one; empty if the study has none.
std::optional<double> difference_of(const ComparedNumber& number);

std::optional<double> difference_of_deviations(const ComparedNumber& number);

/// Returns the study's time, percentage or speed-up over the published one; empty for other
/// numbers.
std::optional<double> times_published(const ComparedNumber& number);

/// Returns whether the study's number lies in the published one's interval; empty if there is none.
std::optional<bool> is_study_in_published_interval(const ComparedNumber& number);

/// Returns whether the published number lies in the interval of the study's; empty if there is
/// none.
std::optional<bool> is_published_in_study_interval(const ComparedNumber& number);

}  // namespace foveola::analysis
