// Edits a participant's answer to one question.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>

#include "renderer/window/screens/screen.h"
#include "study/person/forms/form_input.h"
#include "study/protocol/questionnaire.h"

namespace foveola::study {

class QuestionEntry {
 public:
  explicit QuestionEntry(Question question);

  /// Selects or types. Returns whether the key had a meaning. A scale takes left, right, digits and
  /// erase; a list takes up, down, digits and erase. A number takes characters, erase, and left and
  /// right, which count. Other entries take characters and erase. Step acts as right or down,
  /// cyclically.
  bool follow(const FormInput& input);

  /// Returns the field, without a fault and without focus. A typed number that differs from its
  /// display has a note.
  ScreenField field() const;

  /// Returns a number if one is asked for and the typed text has one reading, else the text. Empty
  /// text if there is no answer yet.
  std::variant<double, std::string> value() const;
  bool is_empty() const;

  /// Returns the reason why the value is not a valid answer, in the protocol's words; empty if it
  /// is one.
  std::string fault(const Texts& texts) const;

  /// Returns the answer as the screen shows it; a number as it was parsed.
  std::string shown_value() const;

  const Question& question() const { return question_; }

  /// Maximum number of points of a scale on the screen; others are typed as numbers.
  static constexpr std::size_t max_points = 21;

 private:
  bool is_listed() const { return !labels_.empty(); }
  bool move(std::ptrdiff_t by);
  bool count(double by);
  bool step();
  bool choose_by(char32_t typed);
  bool type(char32_t typed);
  bool erase();
  /// Returns the typed number; empty if there is none, or several readings.
  std::optional<double> number() const;

  Question question_;
  ScreenField::Kind kind_;
  std::vector<std::string> labels_;
  std::optional<std::size_t> chosen_;
  std::string typed_;
  bool is_counted_ = false;  ///< counted by arrows: the next character begins a new number
};

}  // namespace foveola::study
