#include "study/participant/answers.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "study/protocol/protocol_places.h"

namespace foveola::study {
namespace {

[[noreturn]] void refuse(const Protocol& protocol, const std::string& toml_path,
                         const std::string& what) {
  throw Error(ProtocolPlaces(protocol).of(toml_path), "simulated participants cannot judge " + what,
              "name the judgement that simulates it (of a mark: simulated = \"outline\" or "
              "\"material\"; of a rating on a scale: simulated = \"artifacts\" or \"quality\"), or "
              "draw its values with study simulate --inject order:1");
}

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

bool is_judged(const Question& rating) {
  return !rating.simulated.empty() && rating.kind == QuestionKind::likert;
}

double rate(const RatingHabits& habits, const Question& scale, double noticed_jnd) {
  const double artifacts = rate_artifacts(habits, scale, noticed_jnd);
  return scale.simulated == "quality" ? scale.minimum + scale.maximum - artifacts : artifacts;
}

double rate_artifacts(const RatingHabits& habits, const Question& scale, double noticed_jnd) {
  double rating = scale.minimum;
  double threshold_jnd = habits.second_point_jnd;
  while (rating < scale.maximum && noticed_jnd >= threshold_jnd) {
    rating += 1.0;
    threshold_jnd *= habits.step_factor;
  }
  return rating;
}

std::optional<Task> judgement_of(const MarkEntry& mark) {
  if (mark.simulated == "outline") {
    return Task::mark_outline;
  }
  return mark.simulated == "material" ? std::optional(Task::mark_material) : std::nullopt;
}

void require_judgements(const Protocol& protocol) {
  for (std::size_t i = 0; i < protocol.marks.size(); ++i) {
    if (!judgement_of(protocol.marks[i])) {
      refuse(protocol, fmt::format("mark[{}].id", i), "the mark " + protocol.marks[i].id);
    }
  }
  for (std::size_t i = 0; i < protocol.ratings.size(); ++i) {
    const Question& rating = protocol.ratings[i];
    if (!is_judged(rating) && rating.kind != QuestionKind::text) {
      refuse(protocol, fmt::format("rating[{}].id", i), "the rating " + rating.id);
    }
  }
}

}  // namespace foveola::study
