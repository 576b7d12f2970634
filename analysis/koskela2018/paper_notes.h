// What the report of the published study, or of a repetition of it, says of its paper.
#pragma once

#include <string>

#include "analysis/dataset/dataset.h"

namespace foveola::analysis {

/// Sentences for the parts of the report, without markup: where the paper shows the same, and how
/// it reads there.
struct PaperNotes {
  std::string times_by_scene;
  std::string percentages;
  std::string times_by_method;
  std::string ratings;
  std::string means_of_ratings;
  std::string latency;
  std::string background;
};

/// All empty for a study that does not measure what was published.
PaperNotes paper_notes(const Dataset& set);

}  // namespace foveola::analysis
