// Recognises the published study (Koskela et al. 2018): reports of other studies do not mention the
// paper's tables and figures.
#pragma once

#include <string>

#include "analysis/dataset/dataset.h"

namespace foveola::analysis {

/// Returns whether the study follows a protocol of the published one, whose names begin with
/// koskela2018, and has its marks, outline and material, and its rating, artifacts, of the points 1
/// to 5 (sections 4.2 and 5.2; the ids are ours). Another study may use the same ids with other
/// meanings.
bool measures_what_was_published(const Dataset& set);

/// Returns whether the study's baseline is the paper's, so that percentages are of the same
/// method's times.
bool is_relative_to_od(const Dataset& set);

/// Returns the meaning of a mark of the published study (section 4.2), as a sentence; empty for any
/// other.
std::string meaning_of_mark(const Dataset& set, const std::string& mark);

/// Returns a mark's criterion for sentences: "the outline of a chosen object could be judged", or
/// the protocol's text with its id.
std::string reason_for_mark(const Dataset& set, const Measure& mark);

/// Returns a mark's name in sentences: "the outline was visible", or "the mark ID".
std::string moment_of(const Dataset& set, const Measure& mark);

}  // namespace foveola::analysis
