// Scores of published questionnaires by their published keys.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "study/record/study_records.h"

namespace foveola::analysis {

/// One score of a questionnaire that a participant filled in once.
struct ScoreRow {
  std::string participant;
  std::uint32_t session = 0;    ///< Its index in the records.
  std::string questionnaire;    ///< Its id in the protocol.
  int step = 0;                 ///< Of the session's plan: it may be asked twice.
  std::string instrument;       ///< "SSQ", "NASA-TLX" or "SUS".
  std::string score;            ///< As "nausea" or "total".
  std::optional<double> value;  ///< Empty if an item was not answered.
};

/// The scores of all filled-in questionnaires that are known instruments, in the order of sessions.
/// A questionnaire is one if it has all of its items on their scales, whatever else it asks.
///
/// - SSQ (Kennedy, Lane, Berbaum, Lilienthal 1993): sums of the items of nausea, oculomotor and
///   disorientation times 9.54, 7.58 and 13.92; the total is the sum of the three sums times 3.74.
/// - NASA-TLX without weights (Hart 2006): the mean of the six scales of 0 to 20, times 5.
/// - SUS (Brooke 1996): odd items count their answer less 1, even ones 5 less theirs; the sum
///   times 2.5.
std::vector<ScoreRow> score_questionnaires(const study::StudyRecords& records);

}  // namespace foveola::analysis
