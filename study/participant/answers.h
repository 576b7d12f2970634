// What simulated participants say about themselves.
#pragma once

#include <vector>

#include "renderer/base/random.h"
#include "study/protocol/questionnaire.h"

namespace foveola::study {

/// An answer to each question that needs one, within its range. Numbers and points of a scale: a
/// bell around a third of the range, since most people have little experience with most things
/// (assumed). Choices: any option, but for "gender" the first or the second alone, as published
/// codings have it. Words: the same few, and none where none are required.
std::vector<Answer> draw_answers(const std::vector<Question>& questions, Pcg32& random);

}  // namespace foveola::study
