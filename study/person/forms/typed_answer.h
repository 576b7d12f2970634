// Translates answers of forms to key presses.
#pragma once

#include <optional>
#include <vector>

#include "study/person/forms/form_input.h"
#include "study/protocol/questionnaire.h"

namespace foveola::study {

/// Returns the keys that enter the question's answer into an empty entry: arrows on scales and in
/// lists, elsewhere its characters, which are ASCII. Empty if `answers` has none.
std::vector<FormInput> typed_answer(const Question& question, const std::vector<Answer>& answers);

}  // namespace foveola::study
