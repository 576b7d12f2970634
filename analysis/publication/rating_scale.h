// The words of the scale on which artifacts were rated, as the study's own protocol has them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "study/protocol/questionnaire.h"
#include "study/record/study_records.h"

namespace foveola::analysis {

/// Other words for the same points, in sessions by an amended protocol.
struct AmendedLabels {
  std::vector<std::string> labels;
  std::size_t sessions = 0;  ///< analysed ones, or parts of them
};

/// The rating `artifacts`.
struct RatingScale {
  std::optional<study::Question> question;  ///< as the protocol asks it, if it does
  std::vector<AmendedLabels> amended;

  /// Whether it has the five whole points that tables and figures have columns for.
  bool is_analysed() const;
};

/// Of the record's protocol, and of the amended ones by which `participants` went. Throws Error
/// with its place for what is no protocol.
RatingScale rating_scale_of(const study::StudyRecords& records,
                            const std::vector<std::string>& participants);

/// "1 none to 5 all over", or "1 (none), 2 (some), 3 (much), 4 (more), 5 (all over)", as the scale
/// has labels for its ends or for every point; "1 to 5" if it has none, or is not analysed.
std::string points_in_words(const RatingScale& scale);

/// The same with all labels in brackets: "1 (none) to 5 (all over)".
std::string points_in_brackets(const RatingScale& scale);

/// What else is to be said of it, each sentence after a space: whose points had other words, and
/// why there are no ratings if the protocol asks for none on this scale. Mostly empty.
std::string notes_on(const RatingScale& scale);

}  // namespace foveola::analysis
