// A study beside the published one, cell by cell: for `study simulate --report`.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/publication/published_means.h"
#include "analysis/publication/published_tables.h"
#include "analysis/publication/study_tables.h"

namespace foveola::analysis {

/// One number of the paper's beside this study's.
struct ComparedCell {
  std::string source;    ///< "Table 1", "Table 2", or "text": the ranges of the mean times
  std::string row;       ///< a question, a published scene, or "all scenes"
  std::string own_row;   ///< the question or scene of this study that stands beside it; or empty
  std::string mark;      ///< empty in Table 1
  std::string method;    ///< empty in Table 1
  std::string quantity;  ///< "mean" or "sd"
  /// Of a percentage: "own ratios" or "ratio of means"; the paper does not say which is its own.
  std::string reading;
  std::string unit;
  std::optional<Interval> published;  ///< both ends alike for a number; empty if not at hand
  std::optional<double> study;        ///< empty if this study has none
};

/// Each cell of Tables 1 and 2 in each reading, and the ranges of the text. A published scene's row
/// is the study's scene of that name, else Foveola's counterpart of it.
std::vector<ComparedCell> compare_with_published(const StudyTables& tables,
                                                 const std::vector<study::BackgroundRow>& answers,
                                                 const PublishedTables& published,
                                                 const std::vector<PublishedMean>& means);

/// How far the study's number lies outside the published one, or outside its range: 0 within. Empty
/// where one of the two is missing.
std::optional<double> difference_of(const ComparedCell& cell);

/// Why a cell has no difference, or "": "the published number is not at hand" and the like.
std::string what_is_missing(const ComparedCell& cell);

/// The comparison as CSV with one row per cell.
std::string comparison_csv(const StudyTables& tables, const std::vector<ComparedCell>& cells);

/// The comparison as a page of its own.
std::string comparison_html(const StudyTables& tables, const std::vector<ComparedCell>& cells);

/// Reads a study's file and writes published_comparison.html and .csv to `folder`, which is made if
/// its parent exists. Returns lines for the terminal, each ended by a line break. Throws Error as
/// analyze_study does.
std::string report_published_comparison(const std::filesystem::path& database,
                                        const std::filesystem::path& folder);

}  // namespace foveola::analysis
