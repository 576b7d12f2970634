#include "study/person/forms/typed_answer.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "study/person/forms/question_entry.h"
#include "study/person/forms/typed_number.h"

namespace foveola::study {
namespace {

using Value = std::variant<double, std::string>;

bool is_value_of(const Option& option, const Value& value) {
  return option.value ? value == Value(*option.value) : value == Value(option.label);
}

std::vector<FormInput> typed(const Value& value) {
  const auto* const number = std::get_if<double>(&value);
  const std::string text = number != nullptr ? unambiguous(*number) : std::get<std::string>(value);
  std::vector<FormInput> inputs;
  for (const unsigned char character : text) {
    inputs.emplace_back(char32_t{character});
  }
  return inputs;
}

/// The first press selects the first option.
std::vector<FormInput> presses(FormKey key, std::ptrdiff_t index) {
  return std::vector<FormInput>(static_cast<std::size_t>(index + 1), key);
}

}  // namespace

std::vector<FormInput> typed_answer(const Question& question, const std::vector<Answer>& answers) {
  const auto answer = std::find_if(answers.begin(), answers.end(),
                                   [&](const Answer& one) { return one.question == question.id; });
  if (answer == answers.end()) {
    return {};
  }
  switch (QuestionEntry(question).field().kind) {
    case ScreenField::Kind::scale:
      return presses(FormKey::right,
                     std::lround(std::get<double>(answer->value) - question.minimum));
    case ScreenField::Kind::choice: {
      const auto chosen =
          std::find_if(question.options.begin(), question.options.end(),
                       [&](const Option& option) { return is_value_of(option, answer->value); });
      return presses(FormKey::down, chosen - question.options.begin());
    }
    default:
      return typed(answer->value);
  }
}

}  // namespace foveola::study
