// Questionnaires: forms with their questions and answers.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "renderer/base/clock.h"
#include "study/protocol/texts.h"

namespace foveola::study {

enum class QuestionKind {
  likert,  ///< A whole number on a scale whose points may have labels.
  number,  ///< A number in a range.
  choice,  ///< One of several options.
  text,    ///< Free text.
};

/// One of a choice's options. Its value is recorded as a number; without a value, its label is
/// recorded.
struct Option {
  std::string label;
  std::optional<double> value;
};

struct Question {
  std::string id;    ///< Unique in a form.
  std::string text;  ///< The question's text.
  QuestionKind kind = QuestionKind::likert;
  double minimum = 1.0;  ///< The range of a scale or a number.
  double maximum = 5.0;
  /// The labels of a scale: none, two for its ends, or one for each of its points.
  std::vector<std::string> labels;
  std::vector<Option> options;  ///< The options of a choice.
  bool required = true;         ///< False: it may be left unanswered.
  /// Judgement by which simulated participants answer a rating: "artifacts", whose lowest point is
  /// none, or "quality", the reverse; empty if there is none.
  std::string simulated;
};

/// A range of numbers.
struct Span {
  double low = 0.0;
  double high = 0.0;

  double width() const { return high - low; }
};

/// Returns the range of answers of a scale, a number or a choice whose options all have values.
Span span_of(const Question& rating);

struct Questionnaire {
  std::string id;
  std::string title;
  std::string intro;   ///< Text above the questions; may be empty.
  std::string source;  ///< Its publication; empty for the study's own.
  std::vector<Question> questions;
  std::string file;  ///< As named in the protocol; empty if it is written in the protocol.
  std::string toml;  ///< The file's content, for the record.
};

struct Answer {
  std::string question;
  std::variant<double, std::string> value;
  /// Time from the question's display to its answer; empty if it was not measured.
  std::optional<Nanoseconds> response{};

  friend bool operator==(const Answer&, const Answer&) = default;
};

/// Returns the fault of an answer in a few words for the participant, from the protocol's texts;
/// empty if it is valid. An empty text is no answer, a fault only if the question is required.
std::string fault_of(const Question& question, const std::variant<double, std::string>& answer,
                     const Texts& texts = {});

/// Whether each answer is a valid one to one of the questions, no question has two, and each
/// required one has one.
bool all_answered(const std::vector<Question>& questions, const std::vector<Answer>& answers);

}  // namespace foveola::study
