// A question of the protocol as the text that the record keeps of it, and back.
#pragma once

#include <string>

#include "study/protocol/questionnaire.h"

namespace foveola::study {

/// All of the question but its id, as the JSON object that schema.sql describes at study_rating.
std::string question_json(const Question& question);

/// The question of this id. Throws std::invalid_argument for what question_json does not make.
Question question_from(const std::string& id, const std::string& json);

}  // namespace foveola::study
