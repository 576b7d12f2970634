// Recorded trials as data for other programs: a row per trial and per participant, with the
// protocol's own names, units and scales.
#pragma once

#include <cstddef>
#include <span>

#include "analysis/dataset/dataset.h"
#include "analysis/dataset/gaze_by_trial.h"
#include "analysis/tables/table.h"
#include "study/record/read/study_records.h"

namespace foveola::analysis {

// Columns of tables that may be too large for memory. Their sources must outlive them.

/// Columns of trials_long and trials_timed_again, by an index of the records' trials. They have the
/// values of every mark and rating, of test, practice and catch trials, of all sessions whose data
/// were read, and the gaze, which withdrawn sessions lack. A mark's columns end in _s or _censored,
/// and a rating's in _rating; no other columns do, so that ids are free.
ColumnsOf<std::size_t> trial_columns(const study::StudyRecords& records, const Dataset& set,
                                     std::span<const study::AttemptGazeRow> gaze = {});
inline constexpr std::size_t columns_of_the_participant =
    3;  ///< The first columns describe the participant.

/// Columns of gaze_by_trial, by an index of the records' trials: the gaze of an analysed one.
ColumnsOf<std::size_t> gaze_by_trial_columns(const study::StudyRecords& records, const Dataset& set,
                                             std::span<const study::AttemptGazeRow> gaze);

/// Columns of participants_wide, by an index of the set's participants: every value, in a column
/// named MEASURE.SCENE.METHOD, then participant_answer_columns.
ColumnsOf<std::size_t> participant_columns(const study::StudyRecords& records, const Dataset& set);

}  // namespace foveola::analysis
