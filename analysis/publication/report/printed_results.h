// The study's results as people read them, the same in the report, in LaTeX and on the terminal.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/dataset/comparisons.h"
#include "analysis/dataset/study_tables.h"
#include "analysis/koskela2018/background.h"
#include "analysis/koskela2018/published_study.h"
#include "analysis/tables/printed_table.h"
#include "analysis/tables/table.h"

namespace foveola::analysis {

// `mark` and `rating` are indices of the set's measures; `published` is what stands beside the
// study, empty for one that does not measure what was published.

/// The times until a mark in each scene: the baseline's in seconds, the others' in per cent of each
/// participant's own; the last row has the geometric means over scenes. Below a scene that is a
/// published one or the counterpart of one stands its row of the published Table 2.
PrintedTable printed_times(const StudyTables& tables, std::size_t mark,
                           const std::optional<PublishedStudy>& published);

/// The other reading of the percentages: means over the baseline's mean, likewise.
PrintedTable printed_ratios_of_means(const StudyTables& tables, std::size_t mark,
                                     const std::optional<PublishedStudy>& published);

/// The geometric means over scenes with their intervals, beside those of the published Table 2.
PrintedTable printed_geometric_means(const StudyTables& tables,
                                     const std::optional<PublishedStudy>& published);

/// The table time_to_mark.
PrintedTable printed_time_to_mark(const Table& time_to_mark);

/// One rating's answers and their summary, a row for each method.
PrintedTable printed_ratings(const StudyTables& tables, std::size_t rating);

/// The questions of all questionnaires that have answers in numbers; `answers` is the table
/// answers_by_question.
PrintedTable printed_answers(const Table& answers);

/// The mean scores of questionnaires with a published key; `scores` is questionnaire_scores.
PrintedTable printed_scores(const Table& scores);

/// The answers to the published Table 1's questions beside it; no rows without `published`, or
/// where none of them was answered.
PrintedTable printed_background_answers(const Background& background,
                                        const std::optional<PublishedStudy>& published);

/// The correlation that the protocol states; no rows without one. `correlation` is the table
/// background_correlation.
PrintedTable printed_background(const StudyTables& tables, const Table& correlation);

/// The primary analyses of the planned comparisons, and of the exploratory ones. `results` has the
/// tables of an analysis.
std::vector<PrintedTable> primary_tables(const std::vector<Table>& results,
                                         const Comparisons& comparisons);

/// All other tests of the comparisons, in the report's order; some may have no rows.
std::vector<PrintedTable> sensitivity_tables(const std::vector<Table>& results,
                                             const Comparisons& comparisons);

}  // namespace foveola::analysis
