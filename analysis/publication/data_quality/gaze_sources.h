// Names the sources of participants' gaze: an eye tracker, a simulated eye, or the mouse pointer.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/dataset/dataset.h"
#include "analysis/publication/data_quality/data_quality_checks.h"
#include "study/record/read/data_quality_records.h"

namespace foveola::analysis {

/// Returns whether the tracker's name is that of the mouse pointer.
bool is_pointer(const std::string& tracker);

/// Returns "the mouse pointer in place of an eye", "the eye tracker of profile fove0" and so on.
std::string tracker_in_words(const std::string& tracker);

/// A tracker, and the analysed participants whose gaze came from it.
struct GazeSource {
  std::string tracker;
  std::vector<std::string> participants;
};

/// Returns each tracker that the record names. A participant who changed trackers is listed with
/// each.
std::vector<GazeSource> gaze_sources(const Dataset& set,
                                     std::span<const study::AttemptGazeRow> gaze);

/// Returns "the mouse pointer in place of an eye (P1, P2); the eye tracker of profile fove0 (P3)",
/// without participants if all have the same; empty if the record names no tracker.
std::string gaze_sources_in_words(const std::vector<GazeSource>& sources);

/// Flags a mouse in place of an eye, and sessions with different trackers.
DataQualityCheck check_gaze_source(const Dataset& set, std::span<const study::AttemptGazeRow> gaze);

}  // namespace foveola::analysis
