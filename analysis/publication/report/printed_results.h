// Formats the study's results for readers: the same in the report, in LaTeX and on the terminal.
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

// `mark` and `rating` are indices of the set's measures. `published` is the published study to
// compare with; empty if this study measures something else.

/// Times until a mark in each scene: the baseline's in seconds, the others' in per cent of each
/// participant's own. The last row has the geometric means over scenes. A published scene, or the
/// counterpart of one, is followed by its row of the published Table 2.
PrintedTable printed_times(const StudyTables& tables, std::size_t mark,
                           const std::optional<PublishedStudy>& published);

/// The other reading of the percentages: the ratio of mean times, likewise.
PrintedTable printed_ratios_of_means(const StudyTables& tables, std::size_t mark,
                                     const std::optional<PublishedStudy>& published);

/// Geometric means over scenes with confidence intervals, beside those of the published Table 2.
PrintedTable printed_geometric_means(const StudyTables& tables,
                                     const std::optional<PublishedStudy>& published);

/// The table time_to_mark.
PrintedTable printed_time_to_mark(const Table& time_to_mark);

/// One rating's answers and their summary, a row per method.
PrintedTable printed_ratings(const StudyTables& tables, std::size_t rating);

/// All questionnaires' questions with numeric answers. `answers`: the table answers_by_question.
PrintedTable printed_answers(const Table& answers);

/// Mean scores of questionnaires with a published key. `scores`: the table questionnaire_scores.
PrintedTable printed_scores(const Table& scores);

/// Answers to the questions of the published Table 1, beside it. No rows without `published` or
/// without answers.
PrintedTable printed_background_answers(const Background& background,
                                        const std::optional<PublishedStudy>& published);

/// The correlation that the protocol states; no rows without one. `correlation`: the table
/// background_correlation.
PrintedTable printed_background(const StudyTables& tables, const Table& correlation);

/// Primary analyses of the planned comparisons, and of the exploratory ones. `results`: an
/// analysis's tables.
std::vector<PrintedTable> primary_tables(const std::vector<Table>& results,
                                         const Comparisons& comparisons);

/// All other tests of the comparisons, in the report's order; some may have no rows.
std::vector<PrintedTable> sensitivity_tables(const std::vector<Table>& results,
                                             const Comparisons& comparisons);

}  // namespace foveola::analysis
