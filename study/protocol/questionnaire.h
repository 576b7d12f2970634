// Questions that a participant answers on a form, and the forms.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "study/protocol/texts.h"

namespace foveola::study {

enum class QuestionKind {
  likert,  ///< a whole number of a scale whose points may have labels
  number,  ///< a number in a range
  choice,  ///< one of some options
  text,    ///< free words
};

/// One of a choice's options. value is what is recorded as a number; without, its label is
/// recorded.
struct Option {
  std::string label;
  std::optional<double> value;
};

struct Question {
  std::string id;    ///< none twice in a form
  std::string text;  ///< as it is asked
  QuestionKind kind = QuestionKind::likert;
  double minimum = 1.0;  ///< of a scale or a number
  double maximum = 5.0;
  /// Of a scale: none, two (its ends), or one for each of its points.
  std::vector<std::string> labels;
  std::vector<Option> options;  ///< of a choice
  bool required = true;         ///< otherwise it may be left without an answer
};

struct Questionnaire {
  std::string id;
  std::string title;
  std::string intro;   ///< above the questions; may be empty
  std::string source;  ///< of a published questionnaire; empty for the study's own
  std::vector<Question> questions;
  std::string file;  ///< as the protocol names it; empty if it is written in the protocol
  std::string toml;  ///< the file's content, for the record
};

struct Answer {
  std::string question;
  std::variant<double, std::string> value;

  friend bool operator==(const Answer&, const Answer&) = default;
};

/// Why `answer` is none to `question`, in a few words for who typed it; empty if it is one. An
/// empty text is no answer, which is a fault only if the question is required. texts: the
/// protocol's.
std::string fault_of(const Question& question, const std::variant<double, std::string>& answer,
                     const Texts& texts = {});

}  // namespace foveola::study
