// What a participant has answered to one question so far.
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

  /// Chooses or types. Returns whether the key meant something: on a scale, left, right, digits and
  /// erase; in a list, up, down, digits and erase; of a number, which they count, left and right,
  /// characters and erase; elsewhere, characters and erase. Step is right, or down, and goes round.
  bool follow(const FormInput& input);

  /// The field without words on what is wrong and without focus. A number that was typed in another
  /// way than it is shown has a note.
  ScreenField field() const;

  /// A number where one is asked for and typed, if it has one reading. An empty text if there is no
  /// answer yet.
  std::variant<double, std::string> value() const;
  bool is_empty() const;

  /// Why the value is no answer, in the protocol's words; empty if it is one.
  std::string fault(const Texts& texts) const;

  /// The answer as the screen shows it: a number as it was read.
  std::string shown_value() const;

  const Question& question() const { return question_; }

  /// Scales with more points than this are typed in as numbers.
  static constexpr std::size_t max_points = 21;

 private:
  bool is_listed() const { return !labels_.empty(); }
  bool move(std::ptrdiff_t by);
  bool count(double by);
  bool step();
  bool choose_by(char32_t typed);
  bool type(char32_t typed);
  bool erase();
  /// The number that was typed; empty if there is none, or several that are meant.
  std::optional<double> number() const;

  Question question_;
  ScreenField::Kind kind_;
  std::vector<std::string> labels_;
  std::optional<std::size_t> chosen_;
  std::string typed_;
  bool is_counted_ = false;  ///< by arrows: what is typed then begins anew
};

}  // namespace foveola::study
