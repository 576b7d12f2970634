// Studies for tests, built in code or from the golden files; no person took part in them.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "study/record/read/study_records.h"

namespace foveola::analysis {

/// data/golden's study, all of kind "human": eight completed sessions with missing values and an
/// interrupted one. The published marks and rating.
study::StudyRecords golden_study_records();

/// A complete study of people without gaps: participants P1 ... Pn, scenes "aula" and "barn",
/// methods od, vp and fv, the published marks and rating, both background questions, which the plan
/// states as its scale; it plans no comparison.
study::StudyRecords complete_study(int participants);

/// The row of one trial, for changing it. The row must exist.
study::TrialRow& trial_of(study::StudyRecords& records, const std::string& participant,
                          const std::string& scene, const std::string& method);

/// The value of one measure in one trial, for changing it. It must exist.
study::Value& value_of(study::StudyRecords& records, const std::string& participant,
                       const std::string& scene, const std::string& method,
                       const std::string& measure);

study::Value measured(double number);
study::Value right_censored(double seconds);

/// Calls `change` for the value of one measure in every trial.
void change_values(study::StudyRecords& records, const std::string& measure,
                   const std::function<void(study::Value&)>& change);

/// Removes all other trials.
void keep_trials(study::StudyRecords& records,
                 const std::function<bool(const study::TrialRow&)>& is_kept);

/// The same study, all of whose sessions are of this kind.
study::StudyRecords of_kind(study::StudyRecords records, const std::string& kind);

/// The same study with the method od alone.
study::StudyRecords with_od_alone(study::StudyRecords records);

/// The same study, its sessions, trials and answers stored in another order.
study::StudyRecords reordered(const study::StudyRecords& records, unsigned seed);

// The indices of the published measures.
inline constexpr std::size_t outline_index = 0;
inline constexpr std::size_t material_index = 1;
inline constexpr std::size_t artifacts_index = 2;

/// The index of a text in the records' words; adds it if it is new.
std::uint32_t word_in(study::StudyRecords& records, const std::string& text);

/// Adds an answer in numbers; the participant must have a session.
void add_answer(study::StudyRecords& records, const std::string& participant,
                const std::string& questionnaire, const std::string& question, double number,
                int step = 0);

/// Adds an answer in words; the participant must have a session.
void add_answer_in_words(study::StudyRecords& records, const std::string& participant,
                         const std::string& questionnaire, const std::string& question,
                         const std::string& words, int step = 0);

}  // namespace foveola::analysis
