// Everything that was recorded, as data for other programs: a row for each trial, for each answer
// and for each participant, with the protocol's own names, units and scales.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "analysis/dataset/dataset.h"
#include "analysis/dataset/scoring.h"
#include "analysis/publication/gaze_by_trial.h"
#include "analysis/tables/table.h"
#include "study/record/study_records.h"

namespace foveola::analysis {

/// The columns of trials_long and of trials_timed_again, and the rows of a study: the values of
/// every mark and rating, of test, practice and catch trials, of all sessions whose data were read;
/// and what is known of the gaze in them, which is nothing in withdrawn sessions.
class TrialColumns {
 public:
  /// All must outlive it.
  TrialColumns(const study::StudyRecords& records, const Dataset& set,
               std::span<const study::AttemptGazeRow> gaze = {});

  const std::vector<Column>& columns() const { return columns_; }
  /// Of the row's index in the records' trials.
  Row row(std::size_t trial) const;

  static constexpr std::size_t of_the_participant = 3;  ///< So many columns come first.

 private:
  const study::StudyRecords& records_;
  const Dataset& set_;
  GazeOfTrials gaze_;
  std::vector<std::optional<std::size_t>> participants_;  ///< [session]
  std::vector<Column> columns_;
};

/// The columns of one measure's values. A mark's end in _s or _censored, and a rating's in _rating;
/// no other column beside them does, so that ids are free.
std::vector<Column> columns_of(const Measure& measure, const std::string& scale_in_words);

/// The columns and rows of answers_long: every answer of every questionnaire.
class AnswerColumns {
 public:
  /// Both must outlive it.
  AnswerColumns(const study::StudyRecords& records, const Dataset& set);

  const std::vector<Column>& columns() const { return columns_; }
  /// Of the row's index in the records' answers.
  Row row(std::size_t answer) const;

 private:
  const study::StudyRecords& records_;
  const Dataset& set_;
  std::vector<std::optional<std::size_t>> participants_;          ///< [session]
  std::map<std::pair<std::string, std::string>, Measure> asked_;  ///< [questionnaire, question]
  std::vector<Column> columns_;
};

/// answers_by_question: the mean of every question's numbers, over the analysed participants.
Table answers_by_question(const study::StudyRecords& records, const Dataset& set);

/// questionnaire_scores: of the published questionnaires that have a key, of every session, with
/// whether it is analysed.
Table questionnaire_scores(const study::StudyRecords& records, const Dataset& set);

/// The columns and rows of participants_wide: for each analysed participant every value, in a
/// column named MEASURE.SCENE.METHOD, and every number of a questionnaire, QUESTIONNAIRE.QUESTION.
class ParticipantColumns {
 public:
  /// Both must outlive it.
  ParticipantColumns(const study::StudyRecords& records, const Dataset& set);

  const std::vector<Column>& columns() const { return columns_; }
  /// The index of the first column of a questionnaire.
  std::size_t first_answer() const { return columns_.size() - answers_.size(); }
  /// Of the participant's index in the set.
  Row row(std::size_t participant) const;

 private:
  const study::StudyRecords& records_;
  const Dataset& set_;
  std::vector<Column> columns_;
  std::vector<std::vector<std::optional<double>>> answers_;  ///< [question][participant]
};

}  // namespace foveola::analysis
