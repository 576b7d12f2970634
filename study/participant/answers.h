// Simulated participants' answers to questionnaires.
#pragma once

#include <vector>

#include "renderer/base/random.h"
#include "study/participant/population.h"
#include "study/protocol/questionnaire.h"

namespace foveola::study {

/// Draws an answer to each question that needs one, within its range. "age" is normal with the
/// background's mean and deviation; other numbers and points of a scale are normal with its mean
/// and deviation as fractions of their range. A choice is any option with equal probability, but
/// for "gender" only the first or the second, as published codings have it. Answers in words are
/// always the same, and are given only where they are required.
std::vector<Answer> draw_answers(const std::vector<Question>& questions,
                                 const Background& background, Pcg32& random);

}  // namespace foveola::study
