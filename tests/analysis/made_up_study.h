// Studies for tests, built in code or from the golden files; no person took part in them.
#pragma once

#include <string>

#include "study/record/study_records.h"

namespace foveola::analysis {

/// data/golden's study, all of kind "human": eight completed sessions with missing values and an
/// interrupted one.
study::StudyRecords golden_study_records();

/// A complete study of people without gaps: participants P1 ... Pn, scenes "aula" and "barn",
/// methods od, vp and fv, both background questions.
study::StudyRecords complete_study(int participants);

/// The row of one trial, for changing it. The row must exist.
study::TrialRow& trial_of(study::StudyRecords& records, const std::string& participant,
                          const std::string& scene, const std::string& method);

}  // namespace foveola::analysis
