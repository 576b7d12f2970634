// The measures of a study: times of marks, ratings after them, answers of questionnaires.
#pragma once

#include <string>
#include <vector>

#include "study/protocol/protocol.h"

namespace foveola::study {

enum class MeasureKind {
  time,      ///< Seconds from a trial's first frame to a mark.
  response,  ///< Seconds of answering a rating, or of looking around before.
  rating,    ///< The answer to a question after a trial.
  answer,    ///< The answer to a question of a questionnaire, once or more in a session.
};

/// The id of a rating's response times is the rating's, with this suffix.
inline constexpr const char* response_suffix = "_response";
/// The id of the times of looking around before rating.
inline constexpr const char* looking_around_id = "looking_around";

/// Returns "time", "response", "rating" or "answer".
const char* name_of(MeasureKind kind);

struct Measure {
  MeasureKind kind = MeasureKind::time;
  std::string questionnaire;  ///< Id of an answer's questionnaire.
  /// The question and its scale. Of a mark's time: the mark's id and instruction; of a response
  /// time: its description.
  Question question;

  const std::string& id() const { return question.id; }
  /// Whether its values are seconds.
  bool is_time() const { return kind == MeasureKind::time || kind == MeasureKind::response; }
  /// Returns "s" for times, "points" for scales of whole points, else an empty text.
  std::string unit() const;
  /// Whether all its values are numbers: not for free text, nor for a choice whose options have no
  /// values.
  bool is_numeric() const;
  /// Returns the values of a scale's points in their order, or of a choice's options; empty if
  /// there are none, or more than 20.
  std::vector<double> points() const;
  /// Returns the protocol's label of a point or an option; empty if it has none.
  std::string label_of(double point) const;
};

/// Returns the measures of each trial: the protocol's marks, then its ratings.
std::vector<Measure> trial_measures(const std::vector<MarkEntry>& marks,
                                    const std::vector<Question>& ratings);

/// Inserts response times before the ratings of a trial's measures: those of the named ratings, and
/// of looking around if "" is named. Ids of other measures are skipped.
void add_response_measures(const std::vector<std::string>& rated, std::vector<Measure>& measures);

std::vector<Measure> measures_of(const Questionnaire& questionnaire);

/// Describes the scale for captions: "1 none to 5 all over", "1 (none), 2 (some), 3 (much)", "a
/// number from 0 to 100", "in seconds", "in words".
std::string scale_in_words(const Measure& measure);

}  // namespace foveola::study
