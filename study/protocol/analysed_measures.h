// The measures of a protocol that `foveola analyze` has tables of. The record keeps all of them,
// and before anybody takes part the researcher learns which ones come out in the record only.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "renderer/base/error.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

/// The marks whose times are analysed.
inline constexpr std::array analysed_marks = {"outline", "material"};
/// The rating that is analysed, as a scale of the whole points from 1 to 5.
inline constexpr const char* analysed_rating = "artifacts";
/// The questionnaire whose answers in numbers are analysed.
inline constexpr const char* analysed_questionnaire = "background";

bool is_analysed(const MarkEntry& mark);
bool is_analysed(const Question& rating);

/// The ids of the protocol's marks and ratings that are analysed.
std::vector<std::string> analysed_measures(const Protocol& protocol);

/// Errors for what the protocol plans and the analysis cannot do, each with FILE:LINE:COLUMN and a
/// remedy: a rating `artifacts` that is not a scale from 1 to 5; planned comparisons and
/// equivalence margins of measures that are not analysed.
std::vector<Error> unanalysable(const Protocol& protocol);

/// Notes on what comes out in the record only, each as "FILE:LINE:COLUMN: ...": other marks,
/// ratings and questionnaires, answers in words, catch trials.
std::vector<std::string> recorded_only(const Protocol& protocol);

}  // namespace foveola::study
