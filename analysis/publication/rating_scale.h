// The scale on which artifacts were rated, with its labels as the study's own protocol has them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "study/protocol/questionnaire.h"
#include "study/record/study_records.h"

namespace foveola::analysis {

/// Other labels of the same points, in sessions by an amended protocol.
struct AmendedLabels {
  std::vector<std::string> labels;
  std::size_t sessions = 0;  ///< Analysed sessions, or parts of sessions, with these labels.
};

/// The rating `artifacts`.
struct RatingScale {
  std::optional<study::Question> question;  ///< As the protocol asks it, if it does.
  std::vector<AmendedLabels> amended;
  /// Whether the scale has the five whole points that tables and figures have columns for.
  bool is_analysed() const;
};

/// The scale of the record's protocol, with the labels of the amended ones that the sessions of
/// `participants` followed. Throws Error with its place for a text that is no protocol.
RatingScale rating_scale_of(const study::StudyRecords& records,
                            const std::vector<std::string>& participants);

/// "1 none to 5 all over", or "1 (none), 2 (some), 3 (much), 4 (more), 5 (all over)", as the scale
/// has labels for its ends or for every point; "1 to 5" if it has none, or is not analysed.
std::string points_in_words(const RatingScale& scale);

/// The scale's points with all labels in brackets: "1 (none) to 5 (all over)".
std::string points_in_brackets(const RatingScale& scale);

/// Further sentences on the scale, each after a space: in which sessions points had other labels,
/// and why there are no ratings if the protocol asks for none on this scale. Usually empty.
std::string notes_on(const RatingScale& scale);

}  // namespace foveola::analysis
