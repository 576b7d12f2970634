// What simulated participants say about themselves.
#pragma once

#include <vector>

#include "renderer/base/random.h"
#include "study/participant/population.h"
#include "study/protocol/questionnaire.h"

namespace foveola::study {

/// An answer to each question that needs one, within its range. "age": normal with the background's
/// mean and deviation; other numbers and points of a scale likewise, as parts of their range.
/// Choices: any option, but for "gender" the first or the second alone, as published codings have
/// it. Words: the same few, and none where none are required.
std::vector<Answer> draw_answers(const std::vector<Question>& questions,
                                 const Background& background, Pcg32& random);

}  // namespace foveola::study
