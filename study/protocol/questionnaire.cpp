#include "study/protocol/questionnaire.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace foveola::study {
namespace {

bool is_within(const Question& question, double number) {
  return number >= question.minimum && number <= question.maximum;
}

bool is_option(const Question& question, const std::variant<double, std::string>& answer) {
  return std::ranges::any_of(question.options, [&](const Option& option) {
    return option.value ? answer == std::variant<double, std::string>(*option.value)
                        : answer == std::variant<double, std::string>(option.label);
  });
}

std::string_view fault_id(const Question& question,
                          const std::variant<double, std::string>& answer) {
  const auto* const words = std::get_if<std::string>(&answer);
  if (words != nullptr && words->empty()) {
    return question.required ? "fault_missing" : "";
  }
  if (question.kind == QuestionKind::choice) {
    return is_option(question, answer) ? "" : "fault_no_option";
  }
  if (question.kind == QuestionKind::text) {
    return words != nullptr ? "" : "fault_missing";
  }
  const auto* const number = std::get_if<double>(&answer);
  if (number == nullptr || !std::isfinite(*number)) {
    return "fault_not_a_number";
  }
  if (!is_within(question, *number)) {
    return "fault_out_of_range";
  }
  const bool must_be_whole = question.kind == QuestionKind::likert;
  return must_be_whole && *number != std::round(*number) ? "fault_not_whole" : "";
}

}  // namespace

Span span_of(const Question& rating) {
  if (rating.kind != QuestionKind::choice) {
    return {.low = rating.minimum, .high = rating.maximum};
  }
  const auto [low, high] = std::minmax_element(
      rating.options.begin(), rating.options.end(),
      [](const Option& one, const Option& other) { return *one.value < *other.value; });
  return {.low = *low->value, .high = *high->value};
}

std::string fault_of(const Question& question, const std::variant<double, std::string>& answer,
                     const Texts& texts) {
  const std::string_view id = fault_id(question, answer);
  if (id.empty()) {
    return "";
  }
  return filled(text_of(texts, id), {{"minimum", fmt::format("{}", question.minimum)},
                                     {"maximum", fmt::format("{}", question.maximum)}});
}

bool all_answered(const std::vector<Question>& questions, const std::vector<Answer>& answers) {
  const auto answers_to = [&](const Question& question) {
    return std::ranges::count_if(answers, [&](const Answer& answer) {
      return answer.question == question.id && fault_of(question, answer.value).empty();
    });
  };
  std::ptrdiff_t good_answers = 0;
  for (const Question& question : questions) {
    const std::ptrdiff_t count = answers_to(question);
    if (count > 1 || (count == 0 && question.required)) {
      return false;
    }
    good_answers += count;
  }
  return good_answers == static_cast<std::ptrdiff_t>(answers.size());
}

}  // namespace foveola::study
