// What a study measures: the times of marks, the ratings after them, the answers of questionnaires.
#pragma once

#include <string>
#include <vector>

#include "study/protocol/protocol.h"

namespace foveola::study {

enum class MeasureKind {
  time,      ///< Seconds from a trial's first frame to a mark.
  response,  ///< Seconds that a rating took, or that were looked around before.
  rating,    ///< The answer to a question after a trial.
  answer,    ///< The answer to a question of a questionnaire, once or more in a session.
};

/// The id of the response times of a rating is the rating's, and this.
inline constexpr const char* response_suffix = "_response";
/// The id of the times for which participants looked around before they rated.
inline constexpr const char* looking_around_id = "looking_around";

/// "time", "response", "rating", "answer".
const char* name_of(MeasureKind kind);

struct Measure {
  MeasureKind kind = MeasureKind::time;
  std::string questionnaire;  ///< The id of an answer's questionnaire.
  /// What is asked, and on which scale. Of a mark's time: the mark's id and instruction; of a
  /// response time: what it is.
  Question question;

  const std::string& id() const { return question.id; }
  /// Whether its values are seconds.
  bool is_time() const { return kind == MeasureKind::time || kind == MeasureKind::response; }
  /// "s" of times, "points" of scales of whole points, otherwise empty.
  std::string unit() const;
  /// Whether all its values are numbers: not of free text, nor of a choice whose options have
  /// no values.
  bool is_numeric() const;
  /// The values of a scale's points in their order, or of a choice's options; empty if there are
  /// none, or more than 20.
  std::vector<double> points() const;
  /// The protocol's label of a point or an option; empty if it has none.
  std::string label_of(double point) const;
};

/// The measures of each trial: the protocol's marks, then its ratings.
std::vector<Measure> trial_measures(const std::vector<MarkEntry>& marks,
                                    const std::vector<Question>& ratings);

/// Inserts before the ratings of a trial's measures the response times of those that are named, and
/// of looking around if "" is: those whose ids no other measure has.
void add_response_measures(const std::vector<std::string>& rated, std::vector<Measure>& measures);

/// The measures of a questionnaire: its questions.
std::vector<Measure> measures_of(const Questionnaire& questionnaire);

/// The scale in a few words for captions: "1 none to 5 all over", "1 (none), 2 (some), 3 (much)",
/// "a number from 0 to 100", "in seconds", "in words".
std::string scale_in_words(const Measure& measure);

}  // namespace foveola::study
