// The keys that answer a question of a form.
#pragma once

#include <vector>

#include "study/person/form_input.h"
#include "study/protocol/questionnaire.h"

namespace foveola::study {

/// What an entry that is empty takes for this answer: arrows on scales and in lists, elsewhere its
/// characters, which are ASCII. None for none.
std::vector<FormInput> typed_answer(const Question& question, const std::vector<Answer>& answers);

}  // namespace foveola::study
