// What the published study (Koskela et al. 2018) measured, and where its paper shows it: any other
// study's report says nothing of the paper's tables and figures.
#pragma once

#include <string>

#include "analysis/dataset/dataset.h"

namespace foveola::analysis {

/// Whether the study follows a protocol of the published one, whose names begin with koskela2018,
/// and has its marks, outline and material, and its rating, artifacts, of the points 1 to 5
/// (sections 4.2 and 5.2; the ids are ours). Somebody's own study may use the same ids for
/// something else.
bool measures_what_was_published(const Dataset& set);

/// Whether the study's baseline is the paper's, so that percentages are of the same method's times.
bool is_relative_to_od(const Dataset& set);

/// What a mark of the published study means (section 4.2), as a sentence; empty for any other.
std::string meaning_of_mark(const Dataset& set, const std::string& mark);

/// What a mark is made on, in sentences: "the outline of a chosen object could be judged", or the
/// protocol's words for it with its id.
std::string reason_for_mark(const Dataset& set, const Measure& mark);

/// A mark's name in sentences: "the outline was visible", or "the mark ID".
std::string moment_of(const Dataset& set, const Measure& mark);

}  // namespace foveola::analysis
