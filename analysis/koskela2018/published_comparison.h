// Compares a study with the published one, cell by cell.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/dataset/study_tables.h"
#include "analysis/koskela2018/background.h"
#include "analysis/koskela2018/published_means.h"
#include "analysis/koskela2018/published_tables.h"

namespace foveola::analysis {

/// One number of the paper's beside this study's.
struct ComparedCell {
  std::string source;    ///< "Table 1", "Table 2", or "text": the ranges of the mean times.
  std::string row;       ///< A question, a published scene, or "all scenes".
  std::string own_row;   ///< The question or scene of this study that is compared; may be empty.
  std::string mark;      ///< Empty in Table 1.
  std::string method;    ///< Empty in Table 1.
  std::string quantity;  ///< "mean" or "sd".
  /// A percentage is "own ratios" or "ratio of means"; the paper does not say which its own are.
  std::string reading;
  std::string unit;
  std::optional<Interval> published;  ///< Both ends equal for a number; empty if not at hand.
  std::optional<double> study;        ///< Empty if this study has none.
};

/// Each cell of Tables 1 and 2 in each reading, and the ranges of the text. A published scene's row
/// is the study's scene of that name, else Foveola's counterpart of it.
std::vector<ComparedCell> compare_with_published(const StudyTables& tables,
                                                 const std::vector<BackgroundAnswer>& answers,
                                                 const PublishedTables& published,
                                                 const std::vector<PublishedMean>& means);

/// The study's number less the published one, or less the nearer end of its range; 0 within it.
/// Empty where one of the two is missing.
std::optional<double> difference_of(const ComparedCell& cell);

/// The reason why a cell has no difference, as "the published number is not at hand"; or "".
std::string what_is_missing(const ComparedCell& cell);

}  // namespace foveola::analysis
