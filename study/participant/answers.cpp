#include "study/participant/answers.h"

#include <algorithm>
#include <cmath>

namespace foveola::study {
namespace {

int draw_answer(const Question& question, Pcg32& random) {
  if (question.id == "gender") {
    return random.uniform() < 0.5 ? question.minimum : question.maximum;
  }
  const double range = question.maximum - question.minimum;
  const double center = question.minimum + range / 3.0;
  const double drawn = center + range / 5.0 * random.normal();
  return std::clamp(static_cast<int>(std::lround(drawn)), question.minimum, question.maximum);
}

}  // namespace

std::vector<Answer> draw_answers(const std::vector<Question>& questions, Pcg32& random) {
  std::vector<Answer> answers;
  answers.reserve(questions.size());
  for (const Question& question : questions) {
    answers.push_back({.question = question.id, .value = draw_answer(question, random)});
  }
  return answers;
}

}  // namespace foveola::study
