// Answers to questionnaires, as data for other programs and as results.
#pragma once

#include <cstddef>

#include "analysis/dataset/dataset.h"
#include "analysis/tables/table.h"
#include "study/record/read/study_records.h"

namespace foveola::analysis {

// Columns of tables that may be too large for memory. Their sources must outlive them.

/// answers_long: every answer of every questionnaire.
ColumnsOf<study::AnswerRow> answer_columns(const study::StudyRecords& records, const Dataset& set);

/// Every numeric answer of a questionnaire, in a column named QUESTIONNAIRE.QUESTION.
ColumnsOf<std::size_t> participant_answer_columns(const study::StudyRecords& records,
                                                  const Dataset& set);

/// answers_by_question: the mean of every question's numbers, over the analysed participants.
Table answers_by_question(const study::StudyRecords& records, const Dataset& set);

/// questionnaire_scores: of published questionnaires with a key, for every session, with whether it
/// is analysed.
Table questionnaire_scores(const study::StudyRecords& records, const Dataset& set);

}  // namespace foveola::analysis
