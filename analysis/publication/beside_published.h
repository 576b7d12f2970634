// What stands beside a study's times in its tables: those of the published Table 2.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/dataset/study_tables.h"
#include "analysis/koskela2018/published_study.h"

namespace foveola::analysis {

/// The row of Table 2 that stands below one of a scene: its name, then the mean and deviation of
/// each of the `methods`. Empty without `published`, for a scene that is neither a published one
/// nor the counterpart of one, or if times are not relative to OD's.
std::optional<std::vector<std::string>> published_row(
    const StudyTables& tables, std::size_t mark, std::size_t scene,
    const std::vector<std::string>& methods, const std::optional<PublishedStudy>& published);

/// What these rows are, for a table's note, with a space before it; empty if there are none.
std::string published_rows_explained(const StudyTables& tables,
                                     const std::optional<PublishedStudy>& published);

/// The geometric mean over scenes of Table 2, "30.3 %", and how far the study's is from it, "+7.7
/// points"; dashes for a method or mark that Table 2 lacks. In a study whose baseline is OD.
std::vector<std::string> published_mean_and_difference(const MethodTimes& times,
                                                       const PublishedStudy& published);

}  // namespace foveola::analysis
