// Times to marks with those that were never reached: as a table, as people read it, as a figure.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "analysis/dataset/study_tables.h"
#include "analysis/publication/figures.h"
#include "analysis/tables/printed_table.h"
#include "analysis/tables/table.h"

namespace foveola::analysis {

/// time_to_mark: for every mark and method.
Table time_to_mark_table(const StudyTables& tables);

/// That table, as people read it.
PrintedTable printed_time_to_mark(const Table& time_to_mark);

/// time_to_MARK: the share of trials without the mark by time, a Kaplan-Meier curve for each
/// method; `mark` is an index of the set's measures. Empty without times. Throws Error if gnuplot
/// is missing.
std::optional<Figure> survival_figure(const StudyTables& tables, std::size_t mark);

/// The name of that figure.
std::string survival_figure_name(const Measure& mark);

}  // namespace foveola::analysis
