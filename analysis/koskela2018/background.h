// Correlates participants' background with the time that a method saves them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/dataset/dataset.h"
#include "analysis/statistics/correlation.h"
#include "study/record/read/study_records.h"

namespace foveola::analysis {

/// A numeric answer of a questionnaire.
struct BackgroundAnswer {
  std::string participant;
  std::string question;
  double value = 0.0;
};

/// Returns those of the questionnaire of this id, in the order in which they were given.
std::vector<BackgroundAnswer> answers_in_numbers(const study::StudyRecords& records,
                                                 const std::string& questionnaire);

/// Returns those of the questionnaire "background".
std::vector<BackgroundAnswer> background_answers(const study::StudyRecords& records);

/// One row of Table 1: the analysed participants' answers to one question.
struct QuestionAnswers {
  std::string question;
  Description answers;
  std::size_t missing = 0;  ///< Participants without a number.
};

/// Returns Table 1, in the alphabetical order of the questions.
std::vector<QuestionAnswers> describe_background(const Dataset& set,
                                                 const std::vector<BackgroundAnswer>& answers);

/// The quantity that background is correlated with.
enum class TimeSaved {
  /// The mean over scenes of the logarithm of the baseline's time over the method's: a factor,
  /// which does not grow with a participant's general slowness.
  log_ratio,
  /// The mean over scenes of baseline minus method. The paper's timing was "the difference between
  /// OD and FV" (section 5.1), without the mark or the kind of average; the mean over scenes is
  /// ours. Slow participants save more seconds at the same factor.
  seconds_saved
};

/// Returns "log_ratio" or "seconds_saved".
const char* name_of(TimeSaved quantity);

/// The correlation of background with a speed-up.
struct BackgroundCorrelation {
  TimeSaved quantity = TimeSaved::log_ratio;
  std::string method;
  std::string mark;              ///< Its id.
  std::size_t participants = 0;  ///< Number with an answer to every question and a complete scene.
  std::optional<Correlation> pearson;
  std::optional<Correlation> spearman;
};

/// Returns the correlation of the mean answer to `questions` with the speed-up of a mark with a
/// method, both indices of the set. Throws Error if an answer is not finite.
BackgroundCorrelation correlate_background(const Dataset& set,
                                           const std::vector<BackgroundAnswer>& answers,
                                           const std::vector<std::string>& questions,
                                           TimeSaved quantity, std::size_t mark,
                                           std::size_t method);

/// Participants' answers, and the correlation that the protocol states: of its scale with the log
/// ratio of its first planned comparison of times with the baseline.
struct Background {
  std::vector<std::string> scale;        ///< The protocol's questions; empty if it states none.
  std::vector<QuestionAnswers> answers;  ///< Table 1.
  std::optional<BackgroundCorrelation> correlation;
};

/// Analyses the background. Adds participants without all answers of the scale to the set's
/// exclusions. Throws Error if an answer is not finite.
Background analyse_background(const std::vector<BackgroundAnswer>& answers,
                              const study::AnalysisPlan& plan, Dataset& set);

}  // namespace foveola::analysis
