// Converts a study's file to data frames of pandas.
#pragma once

#include <filesystem>

#include <pybind11/pybind11.h>

namespace foveola::analysis {

struct StudyChoices {
  bool unverified = false;  ///< read it even if its verification fails
  bool withdrawn = false;   ///< include the data of sessions that participants withdrew from
};

/// Returns a dictionary of data frames: trials, trials_timed_again, answers and participants, with
/// the columns of the files trials_long, trials_timed_again, answers_long and participants_wide
/// that `foveola analyze` writes. Each frame's attrs have the kind of the analysed participants
/// ("human", "pilot" or "simulated"), whether the record was verified, and each column's unit and
/// meaning. Throws Error as analyze_study does.
pybind11::dict study_frames(const std::filesystem::path& file, const StudyChoices& choices);

}  // namespace foveola::analysis
