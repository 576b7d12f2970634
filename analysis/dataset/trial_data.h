// What was recorded in trials, as data for other programs: a row for each trial and for each
// participant, with the protocol's own names, units and scales.
#pragma once

#include <cstddef>
#include <span>

#include "analysis/dataset/dataset.h"
#include "analysis/dataset/gaze_by_trial.h"
#include "analysis/tables/table.h"
#include "study/record/study_records.h"

namespace foveola::analysis {

// Columns of tables that may be too large for memory. What they are made from must outlive them.

/// trials_long and trials_timed_again, of an index of the records' trials: the values of every mark
/// and rating, of test, practice and catch trials, of all sessions whose data were read; and what
/// is known of the gaze in them, which is nothing in withdrawn sessions. A mark's columns end in _s
/// or _censored, and a rating's in _rating; no other column beside them does, so that ids are free.
ColumnsOf<std::size_t> trial_columns(const study::StudyRecords& records, const Dataset& set,
                                     std::span<const study::AttemptGazeRow> gaze = {});
inline constexpr std::size_t columns_of_the_participant = 3;  ///< So many of these come first.

/// gaze_by_trial, of an index of the records' trials: what is known of the gaze in an analysed one.
ColumnsOf<std::size_t> gaze_by_trial_columns(const study::StudyRecords& records, const Dataset& set,
                                             std::span<const study::AttemptGazeRow> gaze);

/// participants_wide, of an index of the set's participants: every value, in a column named
/// MEASURE.SCENE.METHOD, then participant_answer_columns.
ColumnsOf<std::size_t> participant_columns(const study::StudyRecords& records, const Dataset& set);

}  // namespace foveola::analysis
