// Tabulates the tests: a row per comparison, omnibus test and order effect.
#pragma once

#include "analysis/dataset/comparisons.h"
#include "analysis/dataset/study_tables.h"
#include "analysis/tables/table.h"

namespace foveola::analysis {

Table comparisons_table(const StudyTables& tables, const Comparisons& comparisons);
/// models: the models fitted by R; no rows if R did not run.
Table models_table(const StudyTables& tables, const Comparisons& comparisons);
/// model_versions: versions of R and its packages.
Table model_versions_table(const StudyTables& tables, const Comparisons& comparisons);
Table omnibus_table(const StudyTables& tables, const Comparisons& comparisons);
Table order_effects_table(const StudyTables& tables, const Comparisons& comparisons);

}  // namespace foveola::analysis
