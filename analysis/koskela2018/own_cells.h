// Matches a study's cells with the published Table 2, and counts the published means that the study
// reproduces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/dataset/study_tables.h"
#include "analysis/koskela2018/published_comparison.h"
#include "analysis/koskela2018/published_study.h"
#include "analysis/statistics/logarithms.h"

namespace foveola::analysis {

/// Returns the index of the study's mark of this id; empty if it has none.
std::optional<std::size_t> mark_index(const Dataset& set, const std::string& mark);

/// Returns the index of the study's scene for the row: that of the same name, else Foveola's
/// counterpart of it; empty if it has neither.
std::optional<std::size_t> scene_of(const Dataset& set, const PublishedTime& row);

/// A cell of a study: indices in the data set's measures, scenes and methods.
struct OwnCell {
  std::size_t mark = 0;
  std::size_t scene = 0;
  std::size_t method = 0;
};

/// Returns the study's cell for a cell of Table 2; empty if the study has none, or its baseline is
/// not OD.
std::optional<OwnCell> cell_of(const Dataset& set, const PublishedTime& row);

/// How a cell's number is computed. seconds: mean time. own_ratios: mean of the participants' times
/// in per cent of their own with the baseline. ratio_of_means: mean time in per cent of the
/// baseline's.
enum class Reading : std::uint8_t { seconds, own_ratios, ratio_of_means };

/// Returns "" for seconds, which need no distinction, "own ratios" or "ratio of means".
const char* name_of(Reading reading);

/// Returns seconds for "od", both readings of per cent for the others.
std::vector<Reading> readings_of(const std::string& method);

/// Returns the logarithm of the cell's mean over participants, in seconds or per cent; empty
/// without times.
std::optional<LogOfMeans> log_mean_of_cell(const Dataset& set, const OwnCell& cell,
                                           Reading reading);

struct MeanAndDeviation {
  std::optional<Estimate> mean;
  std::optional<double> deviation;
};

/// Returns the mean over participants, in seconds, or in per cent and percentage points. Both are
/// empty without times.
MeanAndDeviation mean_of_cell(const StudyTables& tables, const OwnCell& cell, Reading reading);

/// A study's mean is near a published one if neither is more than this many times the other.
inline constexpr double near_factor = 1.5;

/// How many published means of one part of the paper the study reproduces.
struct ReproducedMeans {
  std::string means;  ///< the part: "Table 1", "Table 2, OD", "Table 2, VP and FV, own ratios", ...
  std::size_t published = 0;
  std::size_t compared = 0;  ///< Means that the study has as well.
  std::size_t study_in_published_interval = 0;
  std::size_t published_in_study_interval = 0;
  std::size_t in_both_intervals = 0;
  std::optional<std::size_t> near;  ///< Within near_factor; not counted in Table 1.
};

/// Returns the counts for Table 1, for Table 2's OD, and for its VP and FV in each reading.
std::vector<ReproducedMeans> count_reproduced_means(const std::vector<ComparedNumber>& numbers);

/// Returns a sentence, for example "Table 2, VP and FV, own ratios: of 20 published means, ...".
std::string in_words(const ReproducedMeans& met);

}  // namespace foveola::analysis
