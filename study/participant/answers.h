// What simulated participants say about themselves.
#pragma once

#include <vector>

#include "renderer/base/random.h"
#include "study/protocol/protocol.h"
#include "study/session/session.h"

namespace foveola::study {

/// One answer to each question, within its range: a bell around a third of the range, since most
/// people have little experience with most things (assumed). "gender" is answered with either end
/// of its scale, as published codings have it.
std::vector<Answer> draw_answers(const std::vector<Question>& questions, Pcg32& random);

}  // namespace foveola::study
