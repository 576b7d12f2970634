// Writes the notes on the paper in the report of the published study, or of a repetition of it.
#pragma once

#include <optional>
#include <string>

#include "analysis/dataset/study_tables.h"
#include "analysis/koskela2018/published_study.h"

namespace foveola::analysis {

/// Sentences for the parts of the report, without markup: where the paper shows the same, and its
/// statements there, with the section.
struct PaperNotes {
  std::string times_by_scene;
  std::string percentages;
  std::string times_by_method;
  std::string ratings;
  std::string means_of_ratings;
  std::string latency;
  std::string background;
};

/// Returns empty notes if nothing published is beside the study.
PaperNotes paper_notes(const StudyTables& tables, const std::optional<PublishedStudy>& published);

/// Returns section 5.3's description of Figure 6, beside the order of this study's mean ratings of
/// artifacts; empty unless OD, VP and FV were all rated.
std::string artifacts_in_order(const StudyTables& tables);

}  // namespace foveola::analysis
