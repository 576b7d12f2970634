// Tabulates the study's results: means, counts, correlations and exclusions. The last column of
// each table names the kind of participants: human, pilot or simulated.
#pragma once

#include <string_view>
#include <vector>

#include "analysis/dataset/comparisons.h"
#include "analysis/dataset/session_columns.h"
#include "analysis/dataset/study_tables.h"
#include "analysis/koskela2018/background.h"
#include "analysis/publication/data_quality/data_quality_checks.h"
#include "analysis/tables/table.h"
#include "study/record/read/study_records.h"

namespace foveola::analysis {

/// times_by_scene: as Table 2 of the paper (Koskela et al. 2018, section 5.2), for every mark.
Table times_by_scene(const StudyTables& tables);

/// times_by_method: as its Fig. 5 (section 5.2), for every mark.
Table times_by_method(const StudyTables& tables);

/// time_to_mark: for every mark and method, with trials in which the mark was never reached.
Table time_to_mark_table(const StudyTables& tables);

/// ratings_by_method: as its Fig. 6 (section 5.3), for every rating in numbers.
Table ratings_by_method(const StudyTables& tables);

/// rating_counts: frequency of each answer, for ratings with countable points.
Table rating_counts(const StudyTables& tables);

/// background_correlation.
Table background_correlation(const StudyTables& tables, const Background& background);

Table data_quality_table(const StudyTables& tables, const DataQualityReport& report);
Table latency_table(const StudyTables& tables, const DataQualityReport& report);
Table catch_trials_table(const StudyTables& tables, const DataQualityReport& report);
Table outlying_times_table(const StudyTables& tables, const DataQualityReport& report);
Table reaction_times_table(const StudyTables& tables, const DataQualityReport& report);

// The tests: a row for each comparison, omnibus test and order effect.
Table comparisons_table(const StudyTables& tables, const Comparisons& comparisons);
/// models: the models fitted by R; no rows if R did not run.
Table models_table(const StudyTables& tables, const Comparisons& comparisons);
/// model_versions: versions of R and its packages.
Table model_versions_table(const StudyTables& tables, const Comparisons& comparisons);
Table omnibus_table(const StudyTables& tables, const Comparisons& comparisons);
Table order_effects_table(const StudyTables& tables, const Comparisons& comparisons);

/// exclusions: sessions and values that no number uses.
Table exclusions(const StudyTables& tables);

/// amended_sessions: sessions whose texts or time-outs differ from the study's protocol.
Table amended_sessions(const StudyTables& tables);

/// Returns all tables of an analysis except those written row by row, in the order of OUTPUTS.md.
std::vector<Table> result_tables(const study::StudyRecords& records, const StudyTables& tables,
                                 const Background& background, const Comparisons& comparisons,
                                 const DataQualityReport& checks);

/// Returns the table with this id, which must be among them.
const Table& table_named(const std::vector<Table>& tables, std::string_view id);

/// Returns the table with its methods' labels in place of their ids.
Table with_method_labels(Table table);

template <typename Item>
ColumnOf<Item> kind_of_all(const StudyTables& tables) {
  return {kind_column(), [kind = tables.set.kind](const Item& /*row*/) { return kind; }};
}

}  // namespace foveola::analysis
