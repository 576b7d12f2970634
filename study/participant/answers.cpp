#include "study/participant/answers.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

namespace foveola::study {
namespace {

double draw_number(const Question& question, const Background& background, Pcg32& random) {
  const double range = question.maximum - question.minimum;
  const bool is_age = question.id == "age";
  const double mean =
      is_age ? background.age_mean_years : question.minimum + background.scale_mean_part * range;
  const double deviation =
      is_age ? background.age_deviation_years : background.scale_deviation_part * range;
  const double drawn = std::round(mean + deviation * random.normal());
  return std::clamp(drawn, question.minimum, question.maximum);
}

std::variant<double, std::string> value_of(const Option& option) {
  if (option.value) {
    return *option.value;
  }
  return option.label;
}

std::variant<double, std::string> draw_choice(const Question& question,
                                              const Background& background, Pcg32& random) {
  assert(!question.options.empty());
  if (question.id == "gender" && question.options.size() > 1) {
    return value_of(question.options[random.uniform() < background.first_gender_part ? 0 : 1]);
  }
  const auto options = static_cast<std::uint32_t>(question.options.size());
  return value_of(question.options[random.below(options)]);
}

std::optional<std::variant<double, std::string>> draw_answer(const Question& question,
                                                             const Background& background,
                                                             Pcg32& random) {
  switch (question.kind) {
    case QuestionKind::likert:
    case QuestionKind::number:
      return draw_number(question, background, random);
    case QuestionKind::choice:
      return draw_choice(question, background, random);
    case QuestionKind::text:
      break;
  }
  return question.required ? std::optional<std::variant<double, std::string>>("no comment")
                           : std::nullopt;
}

}  // namespace

std::vector<Answer> draw_answers(const std::vector<Question>& questions,
                                 const Background& background, Pcg32& random) {
  std::vector<Answer> answers;
  answers.reserve(questions.size());
  for (const Question& question : questions) {
    if (auto value = draw_answer(question, background, random)) {
      answers.push_back({.question = question.id, .value = std::move(*value)});
    }
  }
  return answers;
}

}  // namespace foveola::study
