// Whether participants' background is correlated with how much sooner a method lets them mark.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/dataset/dataset.h"
#include "analysis/statistics/correlation.h"
#include "study/record/study_records.h"

namespace foveola::analysis {

/// An answer of a questionnaire that is a number.
struct BackgroundAnswer {
  std::string participant;
  std::string question;
  double value = 0.0;
};

/// Those of the questionnaire of this id, in the order in which they were given.
std::vector<BackgroundAnswer> answers_in_numbers(const study::StudyRecords& records,
                                                 const std::string& questionnaire);

/// Those of the questionnaire "background".
std::vector<BackgroundAnswer> background_answers(const study::StudyRecords& records);

/// One row of Table 1: what the analysed participants answered to one question.
struct QuestionAnswers {
  std::string question;
  Description answers;
  std::size_t missing = 0;  ///< Participants without a number.
};

/// Table 1, in the alphabetical order of the questions.
std::vector<QuestionAnswers> describe_background(const Dataset& set,
                                                 const std::vector<BackgroundAnswer>& answers);

/// What background is held against.
enum class TimeSaved {
  /// The mean over scenes of the logarithm of the baseline's time over the method's: a factor,
  /// which does not grow only because somebody takes long for everything.
  log_ratio,
  /// The mean over scenes of baseline minus method. The paper's timing was "the difference between
  /// OD and FV" (section 5.1), without saying of which mark or how it was averaged; the mean over
  /// scenes is ours. Who takes long saves more seconds at the same factor.
  seconds_saved
};

/// "log_ratio" or "seconds_saved".
const char* name_of(TimeSaved quantity);

/// The correlation of background with a speed-up.
struct BackgroundCorrelation {
  TimeSaved quantity = TimeSaved::log_ratio;
  std::string method;
  std::string mark;              ///< Its id.
  std::size_t participants = 0;  ///< Those with an answer to every question and a complete scene.
  std::optional<Correlation> pearson;
  std::optional<Correlation> spearman;
};

/// The correlation of the mean answer to `questions` with the speed-up of a mark with a method,
/// both indices of the set. Throws Error if an answer is not finite.
BackgroundCorrelation correlate_background(const Dataset& set,
                                           const std::vector<BackgroundAnswer>& answers,
                                           const std::vector<std::string>& questions,
                                           TimeSaved quantity, std::size_t mark,
                                           std::size_t method);

/// What participants answered, and the one correlation that the protocol states: of its scale with
/// the log ratio of its first planned comparison of times with the baseline.
struct Background {
  std::vector<std::string> scale;        ///< The protocol's questions; empty if it states none.
  std::vector<QuestionAnswers> answers;  ///< Table 1.
  std::optional<BackgroundCorrelation> correlation;
};

/// Adds the participants who did not answer all of the scale to the set's exclusions. Throws Error
/// if an answer is not finite.
Background analyse_background(const std::vector<BackgroundAnswer>& answers,
                              const study::AnalysisPlan& plan, Dataset& set);

}  // namespace foveola::analysis
