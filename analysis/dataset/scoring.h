// Scores published questionnaires by their published keys.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "study/record/read/study_records.h"

namespace foveola::analysis {

/// One score of one completed questionnaire.
struct ScoreRow {
  std::string participant;
  std::uint32_t session = 0;    ///< Index in the records.
  std::string questionnaire;    ///< Its id in the protocol.
  int step = 0;                 ///< Step of the session's plan: a questionnaire may be repeated.
  std::string instrument;       ///< "SSQ", "NASA-TLX" or "SUS".
  std::string score;            ///< As "nausea" or "total".
  std::optional<double> value;  ///< Empty if an item was not answered.
};

/// Returns the scores of all completed questionnaires that are known instruments, in the order of
/// sessions. A questionnaire is a known instrument if it has all of its items on their scales; it
/// may have others.
///
/// - SSQ (Kennedy, Lane, Berbaum, Lilienthal 1993): sums of the items of nausea, oculomotor and
///   disorientation times 9.54, 7.58 and 13.92; the total is the sum of the three sums times 3.74.
/// - NASA-TLX without weights (Hart 2006): the mean of the six scales of 0 to 20, times 5.
/// - SUS (Brooke 1996): odd items count their answer less 1, even ones 5 less theirs; the sum
///   times 2.5.
std::vector<ScoreRow> score_questionnaires(const study::StudyRecords& records);

}  // namespace foveola::analysis
