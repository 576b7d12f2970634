// Compares a study with the published one (Koskela et al. 2018), number by number.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/dataset/study_tables.h"
#include "analysis/koskela2018/published_study.h"
#include "study/record/study_records.h"

namespace foveola::analysis {

/// One number of the paper's beside this study's, with the standard deviation of the same values
/// where the paper gives one.
struct ComparedNumber {
  /// "Table 1", "Table 2", "Table 2, all scenes" (the geometric mean over its scenes, which we
  /// compute), or "text".
  std::string source;
  std::string section;  ///< Of the paper, as "5.2".
  std::string row;      ///< A question, a published scene, "all scenes", or what the text states.
  std::string own_row;  ///< The question or scene of this study that is compared; may be empty.
  std::string mark;     ///< Empty where there is none, as in Table 1.
  std::string method;   ///< Likewise.
  /// How this study's percentage was formed: "own ratios" or "ratio of means", of which the paper
  /// does not say which is its own; "geometric mean" over participants and scenes; of P
  /// "Pearson's r".
  std::string reading;
  std::string unit;
  Estimate published;  ///< With an interval where the paper gives a mean and its deviation.
  std::optional<double> published_deviation;
  std::optional<Estimate> study;  ///< Empty if this study has no such number.
  std::optional<double> study_deviation;
};

/// Tables 1 and 2, the latter in each reading, its geometric means over scenes, and what sections
/// 5, 5.1 and 5.2 state in numbers. A published scene's row is the study's scene of that name, else
/// Foveola's counterpart of it.
std::vector<ComparedNumber> compare_with_published(const study::StudyRecords& records,
                                                   const StudyTables& tables,
                                                   const PublishedStudy& published);

/// The study's number less the published one. Empty where the study has none.
std::optional<double> difference_of(const ComparedNumber& number);

/// The same of the standard deviations.
std::optional<double> difference_of_deviations(const ComparedNumber& number);

/// The study's time, percentage or speed-up over the published one. Empty for other numbers.
std::optional<double> times_published(const ComparedNumber& number);

/// Whether the study's number lies in the published one's interval; empty if there is none.
std::optional<bool> is_study_in_published_interval(const ComparedNumber& number);

/// Whether the published number lies in the interval of the study's; empty if there is none.
std::optional<bool> is_published_in_study_interval(const ComparedNumber& number);

/// A study's mean is near a published one if neither is more than this many times the other.
inline constexpr double near_factor = 1.5;

/// How many of a part of the paper's means this study meets.
struct MetMeans {
  std::string means;  ///< Which: "Table 1", "Table 2, OD", "Table 2, VP and FV, own ratios", ...
  std::size_t published = 0;
  std::size_t compared = 0;  ///< Those of which the study has its own.
  std::size_t study_in_published_interval = 0;
  std::size_t published_in_study_interval = 0;
  std::size_t in_both_intervals = 0;
  std::optional<std::size_t> near;  ///< Within near_factor; not counted in Table 1.
};

/// Of Table 1; of Table 2's OD; of its VP and FV in each reading.
std::vector<MetMeans> count_met_means(const std::vector<ComparedNumber>& numbers);

/// A sentence, as "Table 2, VP and FV, own ratios: of 20 published means, ...".
std::string in_words(const MetMeans& met);

}  // namespace foveola::analysis
