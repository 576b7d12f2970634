// Presents times to marks including right-censored ones: as a table, in print, as a figure.
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

PrintedTable printed_time_to_mark(const Table& time_to_mark);

/// time_to_MARK: Kaplan-Meier curves, the share of trials without the mark by time for each method.
/// `mark`: index of the set's measures. Empty without times. Throws Error if gnuplot is missing.
std::optional<Figure> survival_figure(const StudyTables& tables, std::size_t mark);

/// Returns the file name of that figure, without extension.
std::string survival_figure_name(const Measure& mark);

}  // namespace foveola::analysis
